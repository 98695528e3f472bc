// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/garment/garment.h"

namespace toile::bench {

/// The pieces that speed is measured on, by the names that benchmarks carry: "panel/45000",
/// "head/1000000" (bench_meshes.h), or "dress", "face" and "mannequin-devil" from the folder of
/// shared garments. Made at the first call and kept: afterwards they cost nothing. One thread.

/// Empty where the file is not there. Pieces that are no disk are left out.
const Pieces& piecesOf(const std::string& name);

/// Triangles of all pieces together.
double triangleCount(const Pieces& pieces);

/// The three garments of the shared folder.
std::vector<std::string> sharedGarments();
/// Where such a garment's file stands, or would.
std::filesystem::path sharedFile(const std::string& name);
/// The raw scan of a dress, 58 771 triangles.
std::filesystem::path sharedScan();

/// A generated piece as an OBJ file with six decimals, in a temporary folder that goes when the
/// program ends. Written at the first call.
const std::filesystem::path& fileOf(const std::string& name);
/// That folder, for what is to be written.
const std::filesystem::path& temporaryFolder();

}  // namespace toile::bench
