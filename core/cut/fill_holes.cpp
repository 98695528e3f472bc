// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/fill_holes.h"

#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "core/cut/loop_around.h"

namespace toile {
namespace {

/// A cap becomes a cone if a triangle is lower than this fraction of a round hole's radius.
constexpr double kFlatCap = 0.1;

/// The centre of the cap's fan.
Eigen::Vector3d capMiddle(const MeshArrays& mesh, const RimLoop& hole) {
    const std::size_t n = hole.vertices.size();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int v : hole.vertices) {
        middle += mesh.V.row(v).transpose() / static_cast<double>(n);
    }
    const double radius = hole.perimeter / (2 * std::numbers::pi);
    double lowest = radius;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d a = mesh.V.row(hole.vertices[i]);
        const Eigen::Vector3d b = mesh.V.row(hole.vertices[(i + 1) % n]);
        const Eigen::Vector3d twice = (b - middle).cross(a - middle);
        lowest = std::min(lowest, twice.norm() / (b - a).norm());
        normal += twice;
    }
    if (lowest < kFlatCap * radius) {
        if (normal.norm() < kFlatCap * radius * radius) {
            // Without a defined normal: any direction across the first edge.
            const Eigen::Vector3d edge =
                (mesh.V.row(hole.vertices[1]) - mesh.V.row(hole.vertices[0])).transpose();
            normal = edge.unitOrthogonal();
        }
        middle += radius * normal.normalized();
    }
    return middle;
}

/// Three quarters of a turn: the minimum for a flat piece.
constexpr double kNearlyATurn = 1.5 * std::numbers::pi;

/// A ring is a tube if it must stretch across by more than this to be worn, once its rims are flat
/// at their lengths. This is the mean: at this value it reaches a quarter near a rim, more than any
/// cloth takes (diagnose/doubt.h).
constexpr double kMaxStrainAcross = 0.15;

/// How far the rim turns to the side of the cloth, radians: 2 pi for a disk's outline.
double turning(const SurfaceLinks& links, const RimLoop& loop) {
    double sum = 0;
    for (const int v : loop.vertices) {
        sum += std::numbers::pi - links.angleAround(v);
    }
    return sum;
}

}  // namespace

MeshArrays fillHoles(const MeshArrays& mesh, const std::vector<RimLoop>& holes) {
    const int vertexCount = static_cast<int>(mesh.V.rows());
    const int faceCount = static_cast<int>(mesh.F.rows());
    int midpoints = 0;
    int caps = 0;
    for (const RimLoop& hole : holes) {
        const bool isTriangle = hole.vertices.size() == 3;
        midpoints += isTriangle ? 0 : 1;
        caps += isTriangle ? 1 : static_cast<int>(hole.vertices.size());
    }
    MeshArrays filled = mesh;
    filled.V.conservativeResize(vertexCount + midpoints, 3);
    filled.F.conservativeResize(faceCount + caps, 3);
    int vertex = vertexCount;
    int face = faceCount;
    for (const RimLoop& hole : holes) {
        const std::vector<int>& rim = hole.vertices;
        if (rim.size() == 3) {
            filled.F.row(face++) << rim[2], rim[1], rim[0];
            continue;
        }
        filled.V.row(vertex) = capMiddle(mesh, hole);
        for (std::size_t i = 0; i < rim.size(); ++i) {
            filled.F.row(face++) << rim[(i + 1) % rim.size()], rim[i], vertex;
        }
        ++vertex;
    }
    return filled;
}

SortedLoops sortLoops(const SurfaceLinks& links, double smallHole) {
    SortedLoops sorted;
    std::vector<RimLoop> loops = rimsOf(links.mesh(), links.table());
    if (loops.empty()) {
        return sorted;
    }
    std::vector<double> turns;
    turns.reserve(loops.size());
    for (const RimLoop& loop : loops) {
        turns.push_back(turning(links, loop));
    }
    // The outline is the longest loop, except on a flat piece with a longer slit.
    auto outline = std::ranges::max_element(loops, {}, &RimLoop::perimeter) - loops.begin();
    const double longest = loops[outline].perimeter;
    if (turns[outline] <= -kNearlyATurn) {
        outline = std::ranges::max_element(turns) - turns.begin();
    }
    const bool isFlat = turns[outline] >= kNearlyATurn;
    const auto isShort = [&](std::ptrdiff_t k) {
        return k != outline && loops[k].perimeter < smallHole * longest;
    };
    const auto turnsAsHole = [&](std::ptrdiff_t k) {
        return k != outline && !isShort(k) && isFlat && turns[k] <= -kNearlyATurn;
    };
    std::vector<RimLoop> longHoles;
    for (std::ptrdiff_t k = 0; smallHole > 0 && k < std::ssize(loops); ++k) {
        if (turnsAsHole(k)) {
            longHoles.push_back(loops[k]);
        }
    }
    const std::vector<double> strains =
        strainsAcross(links, loops[outline], longHoles, kMaxStrainAcross);
    auto strain = strains.begin();
    for (std::ptrdiff_t k = 0; k < std::ssize(loops); ++k) {
        const bool isHole =
            smallHole > 0 && (isShort(k) || (turnsAsHole(k) && *strain++ <= kMaxStrainAcross));
        (isHole ? sorted.holes : sorted.openings).push_back(std::move(loops[k]));
    }
    return sorted;
}

}  // namespace toile
