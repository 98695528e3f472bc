// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/garment/garment.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Reads the body that the cloth is worn on from a mesh file: mm, y up, in the garment's space;
/// repaired like pieces, with the faces of each connected part outwards.
/// @param unit  of its coordinates, if set by the user; else the file's unit, else that of the
///              garment's first file, which also gives the axes if the file states none
/// Errors: those of `readSoup`, NoGeometry. Cost: n log n.
Result<MeshArrays> readBody(const std::filesystem::path& path, const std::optional<FileUnit>& unit,
                            const Garment& garment, Progress& progress);

/// Whether their boxes overlap. If not, unit or axes are wrong. Linear. Pure.
bool isNear(const MeshArrays& body, const Garment& garment);
/// The error for a body whose box does not overlap the garment's.
Error bodyNotNear(const std::filesystem::path& path);

}  // namespace toile
