// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile {

/// Reads the meshes of USD text in file order: each is an object with its name, placed by its own
/// and its parents' transforms; mirrored or left-handed faces are reversed. Materials come from
/// `material:binding`, of the mesh, its parents or its subsets; texture coordinates from
/// `primvars:st`, merged if equal at one position. Invisible prims, guides and proxies are skipped,
/// and so is the pattern in a file of our own. Moving meshes are read at their first time.
/// References, payloads and variants are not resolved. z up is turned to y up. The unit is the
/// file's, by default centimetres, as USD defines it. `name` is the file, for messages.
/// Errors: MalformedFile, NoGeometry, Cancelled (checked between meshes).
/// Cost: linear. Re-entrant.
Result<PolygonSoup> readUsd(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress);

}  // namespace toile
