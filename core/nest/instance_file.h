// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/nest/nest.h"

namespace toile {

/// Reads a nesting instance in the published format (JSON; `strip_height` and `items` with
/// `demand`, `allowed_orientations` in degrees and `shape`: a "simple_polygon" or a "polygon" with
/// holes). An item without orientations turns freely. Numbers are taken as mm. An item is named by
/// its `id`.
/// @param name  of the file, for errors
/// Errors: MalformedFile naming the file and the place. Cost: linear.
Result<NestInstance> parseNestInstance(std::string_view text, const std::string& name);
/// Errors: also FileUnreadable.
Result<NestInstance> readNestInstance(const std::filesystem::path& path);

/// A nest as JSON: its measures and the placement of each copy, angles in degrees. Without times,
/// so that the same nest gives the same bytes.
std::string nestReport(const NestInstance& instance, const NestOptions& options,
                       const NestResult& result);

/// A picture of the nest as SVG, in mm: the strip along x, one colour per item.
std::string nestPicture(const NestInstance& instance, const NestResult& result);

}  // namespace toile
