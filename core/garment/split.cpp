// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/split.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/base/text.h"
#include "core/garment/corner_uv.h"
#include "core/mesh/edge_table.h"

namespace toile {
namespace {

constexpr std::array kModes = {SplitMode::Auto,   SplitMode::Components, SplitMode::Objects,
                               SplitMode::Groups, SplitMode::Materials,  SplitMode::Uv,
                               SplitMode::Seams};

/// What keeps a face apart from others: its object, group or material, 0 where the mode has none.
int classOf(SplitMode mode, const PolygonSoup& soup, int face) {
    const auto in = [face](const std::vector<int>& labels) {
        return labels.empty() ? -1 : labels[face];
    };
    switch (mode) {
        case SplitMode::Objects:
            return in(soup.faceObject);
        case SplitMode::Groups:
            return in(soup.faceGroup);
        case SplitMode::Materials:
            return in(soup.faceMaterial);
        case SplitMode::Auto:
        case SplitMode::Components:
        case SplitMode::Uv:
        case SplitMode::Seams:
            return 0;
    }
    return 0;
}

}  // namespace

Division splitTriangles(SplitMode mode, const PolygonSoup& soup, const Triangulation& triangles) {
    struct Corner {
        int position, kind, index;  // kind: the class of the face, or the corner's uv
    };
    const bool byUv = mode == SplitMode::Uv;
    const auto count = static_cast<int>(triangles.F.size());
    std::vector<Corner> corners(count);
    CornerUvs uvs(soup);
    for (int c = 0; c < count; ++c) {
        const int face = triangles.sourceFace[c / 3];
        const int position = triangles.F(c / 3, c % 3);
        corners[c] = {position, byUv ? uvs.at(face, position) : classOf(mode, soup, face), c};
    }
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
        return std::tie(a.position, a.kind, a.index) < std::tie(b.position, b.kind, b.index);
    });

    Division division;
    division.cornerVertex.resize(triangles.F.rows(), 3);
    for (int k = 0; k < count; ++k) {
        const Corner& corner = corners[k];
        if (k == 0 || corner.position != corners[k - 1].position ||
            corner.kind != corners[k - 1].kind) {
            division.positionOf.push_back(corner.position);
            division.uvOf.push_back(byUv ? corner.kind : -1);
        }
        division.cornerVertex(corner.index / 3, corner.index % 3) =
            static_cast<int>(division.positionOf.size()) - 1;
    }
    division.partOfTriangle =
        faceComponents(division.cornerVertex, static_cast<int>(division.positionOf.size()));
    division.partCount =
        division.partOfTriangle.empty()
            ? 0
            : 1 + *std::max_element(division.partOfTriangle.begin(), division.partOfTriangle.end());
    return division;
}

namespace {

/// The share of parts that are disks, by Euler's number: the panels of a garment nearly all are,
/// the islands of an artist's texture map are tubes and rings too.
double diskShare(const Division& division) {
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
    return static_cast<double>(std::count(euler.begin(), euler.end(), 1)) / division.partCount;
}

}  // namespace

SplitChoice chooseSplit(SplitMode wanted, const PolygonSoup& soup, const Triangulation& triangles) {
    constexpr double kMostEdgesAreClose = 0.8;
    constexpr double kMostIslandsAreDisks = 0.8;
    constexpr double kFewestTrianglesPerIsland = 4;  // an atlas of single triangles is no pattern
    if (wanted != SplitMode::Auto) {
        return {wanted, ""};
    }
    const auto scale = measureUvScale(soup, triangles);
    if (scale && scale->closeShare >= kMostEdgesAreClose) {
        const Division division = splitTriangles(SplitMode::Uv, soup, triangles);
        const int islands = division.partCount;
        if (islands > 1 &&
            static_cast<double>(triangles.F.rows()) >= kFewestTrianglesPerIsland * islands &&
            diskShare(division) >= kMostIslandsAreDisks) {
            return {SplitMode::Uv, "the UV map is a flat pattern of " + counted(islands, "panel") +
                                       " (" + fixed(100 * scale->closeShare, 0) +
                                       " % of its edges keep their length)"};
        }
    }
    if (soup.objects.size() > 1) {
        return {SplitMode::Objects,
                "the file names " + std::to_string(soup.objects.size()) + " objects"};
    }
    if (soup.groups.size() > 1) {
        return {SplitMode::Groups,
                "the file names " + std::to_string(soup.groups.size()) + " groups"};
    }
    return {SplitMode::Components, "connected parts, as the file names no objects or groups"};
}

std::string_view name(SplitMode mode) {
    switch (mode) {
        case SplitMode::Auto:
            return "auto";
        case SplitMode::Components:
            return "components";
        case SplitMode::Objects:
            return "objects";
        case SplitMode::Groups:
            return "groups";
        case SplitMode::Materials:
            return "materials";
        case SplitMode::Uv:
            return "uv";
        case SplitMode::Seams:
            return "seams";
    }
    return "";
}

std::optional<SplitMode> parseSplitMode(std::string_view text) {
    for (const SplitMode mode : kModes) {
        if (text == name(mode)) {
            return mode;
        }
    }
    return std::nullopt;
}

}  // namespace toile
