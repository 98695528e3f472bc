// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace toile::bench {

/// The numbers of an OBJ file, one after the other, and nothing else.
struct PlainNumbers {
    std::vector<double> positions, uvs;
    std::vector<int> indices;
};

/// The least that any reader must do, as the floor to measure readers by: the file into memory,
/// line by line, every number of the lines `v`, `vt` and `f` through `std::from_chars`. Checks
/// nothing; for well-formed files only. Cost: linear.
PlainNumbers scanPlainly(const std::filesystem::path& path);

}  // namespace toile::bench
