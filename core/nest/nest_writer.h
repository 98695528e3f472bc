// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/nest/nest.h"

namespace toile {

/// A nest as JSON: what it measures, and where each copy lies, angles in degrees. No time in it:
/// the same nest has the same bytes.
std::string nestReport(const NestInstance& instance, const NestOptions& options,
                       const NestResult& result);

/// A picture of it as SVG, in mm: the strip along x, an item a colour.
std::string nestPicture(const NestInstance& instance, const NestResult& result);

}  // namespace toile
