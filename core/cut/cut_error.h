// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/error.h"

namespace toile {

/// A cut that cannot be made as asked: unconnected points, fewer points than it needs.
Error cutError(std::string where, Wording detail);

}  // namespace toile
