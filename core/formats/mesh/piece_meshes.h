// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/formats/export_source.h"

namespace toile {

/// A garment for 3D programs: single layers, a mesh for each piece, with its flat points as texture
/// coordinates at true size.

struct PieceMesh {
    std::string name;  ///< of the piece
    std::string slug;  ///< unique, for formats with restricted names
    Points3 V;         ///< #V x 3, mm, y up
    Triangles F;       ///< #F x 3, outside anti-clockwise
    Points2 uv;        ///< #V x 2, mm, pattern points; empty: it is not flat
};

/// A sewn seam as vertices of meshes, from its start to its end on both sides. A side that begins
/// or ends inside an edge includes that whole edge.
struct MeshSeam {
    std::string name;
    std::string_view kind;  ///< `name(SeamKind)`
    std::array<int, 2> mesh{-1, -1};
    std::array<std::vector<int>, 2> vertices{};
};

struct PieceMeshes {
    std::vector<PieceMesh> meshes{};  ///< one per piece of the garment, in its order
    std::vector<MeshSeam> seams{};
};

/// @param source  its options select the points of the drawn or of the exact outlines
/// Cost: linear. Pure.
PieceMeshes pieceMeshes(const ExportSource& source);

/// glTF 2.0, binary: metres, y up, a node and a mesh for each piece; TEXCOORD_0 in metres, counted
/// downwards from 1 as the format requires, so 1 - v is the pattern's. The seams are in the
/// `extras` of the scene. Single precision.
std::string writeGlb(const PieceMeshes& meshes, const std::string& title);

/// USD as text: metersPerUnit 0.001, y up; under "garment" a mesh for each piece with its pattern
/// as `primvars:st` in metres, under "pattern" the same meshes flat, under "seams" the seams. 4
/// decimals, of `st` 7.
std::string writeUsda(const PieceMeshes& meshes, const std::string& title);

/// A mesh as a separate OBJ, in its file's unit and axes.
std::string writePieceObj(const PieceMesh& mesh, const SourceFile& file);

}  // namespace toile
