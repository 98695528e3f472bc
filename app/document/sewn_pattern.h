// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is sewn back together, `SewnPattern`.
#include "core/prove/proof_settings.h"
