// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/nest/nest.h"

namespace toile {

/// A nest as JSON: its measures and the placement of each copy, angles in degrees. Without times,
/// so that the same nest gives the same bytes.
std::string nestReport(const NestInstance& instance, const NestOptions& options,
                       const NestResult& result);

/// A picture of the nest as SVG, in mm: the strip along x, one colour per item.
std::string nestPicture(const NestInstance& instance, const NestResult& result);

}  // namespace toile
