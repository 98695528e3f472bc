// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile {

/// Reads the meshes of USD as text, as they stand in the file: each is an object by its name,
/// placed by its own and its parents' transforms, and a face that is mirrored or left-handed is
/// turned back. Materials come from `material:binding`, of the mesh, its parents or its subsets;
/// texture coordinates from `primvars:st`, those that are equal at one position merged. What is
/// invisible, a guide or a proxy is passed over, and so is the pattern in a file of our own.
/// Of moving meshes the first moment is read. What references, payloads and variants would add is
/// not there. z up is turned to y up. The unit is the file's, centimetres where it states none, as
/// USD has it. `name` is the file, for messages.
/// Errors: MalformedFile, NoGeometry, Cancelled (looked at between meshes).
/// Cost: linear. Re-entrant.
Result<PolygonSoup> readUsd(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress);

}  // namespace toile
