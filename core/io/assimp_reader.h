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

/// Reads glTF, FBX, Collada and 3MF files through assimp. Every node that carries meshes is an
/// object, placed by its own and its parents' transforms; a node that mirrors has its faces turned
/// back. Assimp repeats a vertex wherever its normal or texture coordinate changes, so equal
/// positions are merged within an object, never across objects, and so are equal texture
/// coordinates at one position: islands of the UV map hang together by index as they do in an OBJ
/// file. Points and lines are passed over. The unit is stated where the format or the file fixes it
/// and assimp passes it on: not for 3MF. Coordinates have a float's precision, as assimp has.
/// Damaged files may end assimp, or never end: it reads each once in a process that is thrown away.
/// `name` is the file, for messages. Errors: FileUnreadable, MalformedFile, NoGeometry, Cancelled
/// (looked at between objects). Cost: assimp's own twice, and linear in the corners of all
/// instances. Re-entrant.
Result<PolygonSoup> readWithAssimp(const std::filesystem::path& path, const std::string& name,
                                   Progress& progress);

/// Endings of the files that are read so, lower case with the dot.
std::span<const std::string_view> assimpEndings();
/// Whether one of them is this, in any case.
bool isForAssimp(std::string_view ending);

/// How far a coordinate may lie from the one that was meant, where all of them have passed through
/// floats: half a step at the largest of them, in their unit. Cost: linear. Pure.
double precisionOfFloats(const PolygonSoup& soup);

}  // namespace toile
