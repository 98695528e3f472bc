// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile {

/// Reads glTF, FBX, Collada and 3MF files through assimp, in a child process with limits of time
/// and memory by the size of the file, and with no access to files outside its folder. The first
/// bytes must fit the ending. Every node that carries meshes is an object, placed by its own and
/// its parents' transforms, or by its skin; faces of a mirroring node are reversed. Assimp repeats
/// a vertex wherever its normal or texture coordinate changes, so equal positions are merged within
/// an object, never across objects, and so are equal texture coordinates at one position: islands
/// of the UV map are connected by index as in an OBJ file. Points and lines are skipped. The unit
/// is set if the format or the file states it, and z is up in 3MF. Coordinates have the precision
/// of a float, as in assimp.
/// @param bytes  of the file  @param name  the file, for messages
/// Errors: FileUnreadable (beyond the limits, a path outside the folder), MalformedFile,
/// NoGeometry, Cancelled. Cost: that of assimp, and linear in the corners of all instances.
/// Re-entrant.
Result<PolygonSoup> readWithAssimp(const std::filesystem::path& path, std::string_view bytes,
                                   const std::string& name, Progress& progress);

/// Endings of these files, lower case with the dot.
std::span<const std::string_view> assimpEndings();
/// Whether an ending is one of them, ignoring case.
bool isForAssimp(std::string_view ending);

/// Rounding error of coordinates that have passed through floats: half a step at the largest
/// coordinate, in their unit. Cost: linear. Pure.
double precisionOfFloats(const PolygonSoup& soup);

}  // namespace toile
