// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace toile::bench {

/// An OBJ file like those that garment programs write, in the folder for temporary files: one
/// folded panel of 217 800 triangles with its flat form as UV map, six decimals, about 15 MB.
class PanelFile {
public:
    PanelFile();

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace toile::bench
