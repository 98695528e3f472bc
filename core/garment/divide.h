// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/garment/garment.h"

namespace toile {

/// Divides a file into pieces: connected components of shared vertices, in order of first face,
/// positions scaled to millimetres. Pieces are named from the file's objects, else groups, else
/// "piece"; several pieces of one name get " 2", " 3"; `namePrefix` goes before every name. Each is
/// checked and becomes a half-edge mesh; one that is no disk keeps its arrays and says why in
/// `defect`.
/// Cost: linear but for one sort of the edges. `problems` receives what triangulating had to say.
std::vector<std::shared_ptr<const Piece>> divide(const SourceFile& file, int fileIndex,
                                                 const std::string& namePrefix, Problems& problems);

}  // namespace toile
