// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/split.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/assemble/corner_uv.h"
#include "core/base/statistics.h"
#include "core/base/wording.h"
#include "core/geometry/buckets.h"
#include "core/mesh/edge_table.h"

namespace toile {
namespace {

/// The names by which a mode separates faces: their objects, groups or materials; null if it uses
/// none.
const std::vector<int>* classesOf(SplitMode mode, const PolygonSoup& soup) {
    return mode == SplitMode::Objects     ? &soup.faceObject
           : mode == SplitMode::Groups    ? &soup.faceGroup
           : mode == SplitMode::Materials ? &soup.faceMaterial
                                          : nullptr;
}

/// Makes one vertex per position and kind of corner, in order of both, and assigns corners their
/// vertices. @param kind  per corner; empty if all are of one kind
void numberVertices(const Triangles& F, const std::vector<int>& kind, int positionCount,
                    Division& division) {
    const int* position = F.data();
    const int cornerCount = static_cast<int>(F.size());
    division.cornerVertex.resize(F.rows(), 3);
    int* vertex = division.cornerVertex.data();
    if (kind.empty()) {
        std::vector<int> vertexAt(static_cast<std::size_t>(positionCount), -1);
        for (int c = 0; c < cornerCount; ++c) {
            vertexAt[position[c]] = 0;
        }
        for (int p = 0; p < positionCount; ++p) {
            if (vertexAt[p] == 0) {
                vertexAt[p] = static_cast<int>(division.positionOf.size());
                division.positionOf.push_back(p);
            }
        }
        for (int c = 0; c < cornerCount; ++c) {
            vertex[c] = vertexAt[position[c]];
        }
        return;
    }
    // Buckets by position, small sorts by kind inside.
    using Corner = std::pair<int, int>;  // kind, corner
    geometry::Buckets<Corner> corners(positionCount, [&](auto add) {
        for (int c = 0; c < cornerCount; ++c) {
            add(position[c], Corner(kind[c], c));
        }
    });
    for (int p = 0; p < positionCount; ++p) {
        std::ranges::sort(corners[p]);
        const int* last = nullptr;
        for (const Corner& corner : corners[p]) {
            if (last == nullptr || *last != corner.first) {
                division.positionOf.push_back(p);
            }
            last = &corner.first;
            vertex[corner.second] = static_cast<int>(division.positionOf.size()) - 1;
        }
    }
}

/// The kinds that separate corners of one position: the class of the face, or the corner's uv;
/// empty if all are of one kind.
std::vector<int> kindsOfCorners(SplitMode mode, const PolygonSoup& soup,
                                const Triangulation& triangles) {
    std::vector<int> kinds;
    const std::vector<int>* classes = classesOf(mode, soup);
    if (mode != SplitMode::Uv && (!classes || classes->empty())) {
        return kinds;
    }
    kinds.resize(static_cast<std::size_t>(triangles.F.size()));
    CornerUvs uvs(soup);
    for (std::size_t c = 0; c < kinds.size(); ++c) {
        const int face = triangles.sourceFace[c / 3];
        kinds[c] = classes ? (*classes)[face] : uvs.at(face, triangles.F.data()[c]);
    }
    return kinds;
}

}  // namespace

Division splitTriangles(SplitMode mode, const PolygonSoup& soup, const Triangulation& triangles) {
    Division division;
    numberVertices(triangles.F, kindsOfCorners(mode, soup, triangles),
                   static_cast<int>(soup.positions.size()), division);
    division.partOfTriangle =
        faceComponents(division.cornerVertex, static_cast<int>(division.positionOf.size()));
    division.partCount =
        division.partOfTriangle.empty()
            ? 0
            : 1 + *std::max_element(division.partOfTriangle.begin(), division.partOfTriangle.end());
    return division;
}

int diskCount(const Division& division) {
    const auto vertexCount = static_cast<int>(division.positionOf.size());
    std::vector<int> euler(division.partCount, 0);
    std::vector<int> partOfVertex(vertexCount, -1);
    for (int t = 0; t < division.cornerVertex.rows(); ++t) {
        ++euler[division.partOfTriangle[t]];
        for (int k = 0; k < 3; ++k) {
            partOfVertex[division.cornerVertex(t, k)] = division.partOfTriangle[t];
        }
    }
    for (const int part : partOfVertex) {
        ++euler[part];
    }
    const EdgeTable table = buildEdgeTable(division.cornerVertex, vertexCount);
    for (int e = 0; e < table.edges.rows(); ++e) {
        --euler[partOfVertex[table.edges(e, 0)]];
    }
    return static_cast<int>(std::ranges::count(euler, 1));
}

SplitChoice chooseSplit(SplitMode wanted, const PolygonSoup& soup, const Triangulation& triangles) {
    constexpr double kMostEdgesAreClose = 0.8;
    // Nearly all panels of a garment are disks; an artist's islands are tubes and rings too.
    constexpr double kMostIslandsAreDisks = 0.8;
    if (wanted != SplitMode::Auto) {
        return {wanted, ""};
    }
    const auto scale = measureUvScale(soup, triangles);
    if (scale && scale->closeShare >= kMostEdgesAreClose) {
        const Division division = splitTriangles(SplitMode::Uv, soup, triangles);
        const int islands = division.partCount;
        if (islands > 1 &&
            static_cast<double>(triangles.F.rows()) >= kMinTrianglesPerPart * islands &&
            diskCount(division) >= kMostIslandsAreDisks * islands) {
            return {SplitMode::Uv,
                    worded("the UV map is a flat pattern of %1 (%2 % of its edges keep "
                           "their length)",
                           {countWording(islands, "panel"), figure(100 * scale->closeShare)})};
        }
    }
    if (soup.objects.size() > 1) {
        return {SplitMode::Objects,
                worded("the file names %1 objects", {figure(double(soup.objects.size()))})};
    }
    if (soup.groups.size() > 1) {
        return {SplitMode::Groups,
                worded("the file names %1 groups", {figure(double(soup.groups.size()))})};
    }
    return {SplitMode::Components,
            worded("connected parts, as the file names no objects or groups")};
}

std::optional<UvScale> measureUvScale(const PolygonSoup& soup, const Triangulation& triangles) {
    if (soup.cornerUvs.empty()) {
        return std::nullopt;
    }
    std::vector<double> ratios;
    int uncovered = 0;
    CornerUvs uvs(soup);
    for (int t = 0; t < triangles.F.rows(); ++t) {
        const int face = triangles.sourceFace[t];
        for (int k = 0; k < 3; ++k) {
            const int v = triangles.F(t, k);
            const int w = triangles.F(t, (k + 1) % 3);
            const int a = uvs.at(face, v);
            const int b = uvs.at(face, w);
            const double flat = a < 0 || b < 0 ? 0.0 : (soup.uvs[a] - soup.uvs[b]).norm();
            const double ratio = (soup.positions[v] - soup.positions[w]).norm() / flat;
            if (std::isfinite(ratio) && ratio > 0) {
                ratios.push_back(ratio);
            } else {
                ++uncovered;  // no uv, or an edge without length
            }
        }
    }
    if (ratios.empty()) {
        return std::nullopt;
    }
    const double median = medianOf(ratios);
    const auto close = std::count_if(ratios.begin(), ratios.end(), [median](double ratio) {
        return std::abs(ratio / median - 1) <= kIsometricBand;
    });
    return UvScale{median,
                   static_cast<double>(close) / (static_cast<double>(ratios.size()) + uncovered)};
}

}  // namespace toile
