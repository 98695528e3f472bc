// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/wording.h"
#include "core/formats/read_pattern.h"
#include "core/marker/marker_settings.h"

namespace toile {

/// A hide from a drawing. The largest closed line is the edge; closed lines inside it are zones of
/// the grade that their layer names ("grade 2", "Grade_3"), or holes.
struct HideFile {
    Hide hide;  ///< its lower left corner at the origin
    std::vector<Wording> notes{};
};

/// @param kind  Dxf or Svg
/// Errors: MalformedFile, NoGeometry (no closed line), without a subject. Cost: that of reading,
/// plus zones times points of the edge. Pure.
Result<HideFile> readHide(std::string_view bytes, PatternFileKind kind);

/// Reads a hide by its file extension.
/// Errors: as above, plus UnknownFormat and FileUnreadable, with the file's name.
Result<HideFile> readHide(const std::filesystem::path& path);

/// The grade that a layer names: the number after "grade", in any case; 0 if there is none.
int gradeOfLayer(std::string_view layer);

}  // namespace toile
