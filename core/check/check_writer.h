// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/check/ready_to_cut.h"

namespace toile {

/// The verdict and all findings as JSON (docs/ready-to-cut.md). @param readiness  of that garment
std::string writeReadiness(const Garment& garment, const Readiness& readiness);

}  // namespace toile
