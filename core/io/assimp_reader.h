// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile {

/// Reads glTF, FBX, Collada and 3MF files through assimp; there only where Toile is built with
/// TOILE_ASSIMP. Every node that carries meshes is an object, placed by its own and its parents'
/// transforms; a node that mirrors has its faces turned back. Assimp repeats a vertex wherever its
/// normal or texture coordinate changes, so equal positions are merged within an object, never
/// across objects, and so are equal texture coordinates at one position: islands of the UV map hang
/// together by index as they do in an OBJ file. Points and lines are passed over.
/// The unit is stated where the format or the file fixes it and assimp passes it on: not for 3MF.
/// Coordinates have a float's precision, as assimp has. `name` is the file, for messages.
/// Errors: FileUnreadable, MalformedFile, NoGeometry, Cancelled (looked at between objects).
/// Cost: linear in the corners of all instances. Re-entrant.
Result<PolygonSoup> readWithAssimp(const std::filesystem::path& path, const std::string& name,
                                   Progress& progress);

}  // namespace toile
