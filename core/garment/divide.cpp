// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/divide.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/garment/corner_uv.h"
#include "core/garment/piece_names.h"
#include "core/io/triangulate.h"
#include "core/mesh/connected_parts.h"
#include "core/mesh/repair.h"

namespace toile {
namespace {

/// A UV map whose scale is this close to 1 is in the file's own unit: the draped cloth differs from
/// its flat panel by no more. Any other scale was normalised and is fitted.
constexpr double kExactScaleBand = 0.1;

/// Takes the triangles of one part. Vertices are numbered in order of their index in the division,
/// that is of their position in the file, so that the piece does not depend on the order of
/// corners.
MeshPart gather(const SourceFile& file, const Triangulation& triangles, const Division& division,
                const std::vector<int>& members, std::vector<int>& vertices) {
    const double millimetres = millimetresPer(file.unit);
    vertices.clear();
    for (const int t : members) {
        for (int k = 0; k < 3; ++k) {
            vertices.push_back(division.cornerVertex(t, k));
        }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

    MeshPart part;
    part.mesh.V.resize(static_cast<Eigen::Index>(vertices.size()), 3);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        part.sourceVertex.push_back(division.positionOf[vertices[v]]);
        part.mesh.V.row(static_cast<Eigen::Index>(v)) =
            millimetres * withYUp(file.up, file.soup.positions[part.sourceVertex.back()]);
    }
    part.mesh.F.resize(static_cast<Eigen::Index>(members.size()), 3);
    for (std::size_t f = 0; f < members.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto at = std::lower_bound(vertices.begin(), vertices.end(),
                                             division.cornerVertex(members[f], k));
            part.mesh.F(static_cast<Eigen::Index>(f), k) = static_cast<int>(at - vertices.begin());
        }
        part.sourceFace.push_back(triangles.sourceFace[members[f]]);
    }
    return part;
}

/// The uv of each vertex of a piece, by its corners' faces; nothing where a corner has none.
std::optional<Points2> flatPanel(const PolygonSoup& soup, const Piece& piece, double scale) {
    CornerUvs uvs(soup);
    Points2 panel = Points2::Constant(piece.mesh.V.rows(), 2, std::nan(""));
    for (int f = 0; f < piece.mesh.F.rows(); ++f) {
        if (piece.sourceFace[f] < 0) {
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            const int v = piece.mesh.F(f, k);
            const int uv = uvs.at(piece.sourceFace[f], piece.sourceVertex[v]);
            if (uv >= 0) {
                panel.row(v) = scale * soup.uvs[uv];
            }
        }
    }
    return panel.allFinite() ? std::optional(panel) : std::nullopt;
}

}  // namespace

DividedFile divide(const SourceFile& file, int fileIndex, const std::string& namePrefix,
                   const DivideOptions& options) {
    const PolygonSoup& soup = file.soup;
    const double millimetres = millimetresPer(file.unit);
    Triangulation triangles = triangulate(soup, file.path.filename().string());
    DividedFile divided;
    divided.problems = std::move(triangles.problems);
    divided.split = chooseSplit(options.split, soup, triangles);
    const Division division = splitTriangles(divided.split.mode, soup, triangles);
    std::vector<std::vector<int>> members(division.partCount);
    for (std::size_t t = 0; t < division.partOfTriangle.size(); ++t) {
        members[division.partOfTriangle[t]].push_back(static_cast<int>(t));
    }

    std::optional<UvScale> uvScale;
    if (divided.split.mode == SplitMode::Uv) {
        uvScale = measureUvScale(soup, triangles);
        if (uvScale && std::abs(uvScale->ratio - 1) < kExactScaleBand) {
            uvScale->ratio = 1;
        }
    }
    PieceNames names(soup, divided.split.mode);
    std::vector<int> vertices;
    for (const auto& faces : members) {
        MeshPart part = gather(file, triangles, division, faces, vertices);
        const std::string wanted = names.inFile(part.sourceFace.front());
        std::string name = names.unique(wanted);
        if (options.repair) {
            RepairResult mended = repair(std::move(part), RepairOptions{}, namePrefix + name);
            divided.problems.insert(divided.problems.end(), mended.repairs.begin(),
                                    mended.repairs.end());
            part = std::move(mended.part);
        }
        for (auto& [connected, ignored] : connectedParts(std::move(part))) {
            if (name.empty()) {
                name = names.unique(wanted);  // the part fell apart: its pieces share the name
            }
            auto piece = std::make_shared<Piece>(
                makePiece(namePrefix + std::exchange(name, ""), std::move(connected.mesh)));
            piece->file = fileIndex;
            piece->sourceVertex = std::move(connected.sourceVertex);
            piece->sourceFace = std::move(connected.sourceFace);
            if (uvScale) {
                piece->reference = flatPanel(soup, *piece, millimetres * uvScale->ratio);
            }
            divided.pieces.push_back(std::move(piece));
        }
    }
    return divided;
}

}  // namespace toile
