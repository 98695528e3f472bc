// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// What our own GLB and USD files hold, read to compare it with what they were made from; files of
/// other programs are read by core/io.

/// Bytes of a mesh's name: seams repeat it.
inline constexpr std::size_t kLongestMeshName = 1000;

struct FileMesh {
    std::string name{};
    Points3 V = Points3(0, 3);  ///< mm
    Triangles F = Triangles(0, 3);
    Points2 uv = Points2(0, 2);  ///< mm, as the pattern counts; empty: none
};

struct FileSeam {
    std::string name{};
    std::array<std::string, 2> mesh{};  ///< names
    std::array<std::vector<int>, 2> vertices{};
};

struct MeshFile {
    std::vector<FileMesh> meshes{};  ///< of the garment
    std::vector<FileMesh> flat{};    ///< of the pattern, where the format has them apart
    std::vector<FileSeam> seams{};
};

/// glTF 2.0, binary, one buffer, float and unsigned int accessors.
/// Errors: MalformedFile with what is wrong. Cost: linear. Pure.
Result<MeshFile> readGlb(std::string_view bytes);

/// USD as text, as far as `def` prims with attributes of numbers, strings, arrays and one
/// relationship go. Errors: MalformedFile with the line. Cost: linear. Pure.
Result<MeshFile> readUsda(std::string_view bytes);

}  // namespace toile
