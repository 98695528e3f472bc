// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/garment/garment.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Reads what cloth is worn on from a mesh file: in mm, y up, in the space of the garment; put
/// right as pieces are, each part that hangs together with its faces outwards.
/// @param unit  of its coordinates, where a person has said it; else what the file states, else
/// that of the garment's first file, whose axes it has too where it states none
/// Errors: those of `readSoup`, NoGeometry. Cost: n log n.
Result<MeshArrays> readBody(const std::filesystem::path& path, const std::optional<FileUnit>& unit,
                            const Garment& garment, Progress& progress);

/// Whether their boxes meet. Where they do not, unit or axes are wrong. Linear. Pure.
bool isNear(const MeshArrays& body, const Garment& garment);
/// What is to be said of a body that is not.
Error bodyNotNear(const std::filesystem::path& path);

}  // namespace toile
