// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/geometry/disjoint_sets.h"
#include "core/mesh/edge_table.h"
#include "core/prepare/shell_pairs.h"
#include "core/prepare/shell_rays.h"

namespace toile {
namespace {

/// An axis is clear if the openings lie this many times as far apart along it.
constexpr double kClearlyApart = 2;
/// Openings with less of the bounding box between them are buttonholes and slits.
constexpr double kMinBetween = 0.01;
/// A box flatter than this part of its size is not a measure either.
constexpr double kFlattest = 0.1;
/// The only opening of a hat or a sock is smaller than this part of the surface. It faces along an
/// axis if this much of its area does.
constexpr double kOneOpening = 0.6, kFacesAlong = 0.8;
/// A surface with a larger horizontal share is a sheet with a hole, not a tube.
constexpr double kLevel = 0.85;

/// A loop of border edges, or several that touch.
struct Opening {
    int part = 0;  ///< connected part of the surface
    double length = 0;
    Eigen::Vector3d centre{0, 0, 0};  ///< mean by length
    /// Of a fan that closes it, seen along each axis; independent of the faces' windings.
    Eigen::Vector3d area{0, 0, 0};
};

std::vector<Opening> openingsOf(const MeshArrays& mesh) {
    const auto vertices = static_cast<int>(mesh.V.rows());
    const EdgeTable table = buildEdgeTable(mesh.F, vertices);
    geometry::DisjointSets loops(vertices), parts(vertices);
    std::vector<std::pair<int, int>> border;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        parts.join(mesh.F(f, 0), mesh.F(f, 1));
        parts.join(mesh.F(f, 0), mesh.F(f, 2));
    }
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            border.emplace_back(table.edges(e, 0), table.edges(e, 1));
            loops.join(table.edges(e, 0), table.edges(e, 1));
        }
    }
    const auto at = [&mesh](int vertex) -> Eigen::Vector3d { return mesh.V.row(vertex); };
    std::map<int, Opening> found;
    for (const auto& [from, to] : border) {
        const double length = (at(to) - at(from)).norm();
        Opening& opening = found[loops.root(from)];
        opening.part = parts.root(from);
        opening.length += length;
        opening.centre += length * (at(from) + at(to)) / 2;
    }
    std::erase_if(found, [](const auto& opening) { return !(opening.second.length > 0); });
    for (auto& [root, opening] : found) {
        opening.centre /= opening.length;
    }
    for (const auto& [from, to] : border) {
        if (const auto opening = found.find(loops.root(from)); opening != found.end()) {
            const Eigen::Vector3d centre = opening->second.centre;
            opening->second.area += ((at(from) - centre).cross(at(to) - centre) / 2).cwiseAbs();
        }
    }
    std::vector<Opening> openings;
    for (const auto& [root, opening] : found) {
        openings.push_back(opening);
    }
    return openings;
}

/// The largest volume between two openings, along each axis.
Eigen::Vector3d volumesBetween(const std::vector<Opening>& openings) {
    Eigen::Vector3d most(0, 0, 0);
    for (std::size_t i = 0; i < openings.size(); ++i) {
        for (std::size_t j = i + 1; j < openings.size() && j < i + 1000; ++j) {
            const Opening &one = openings[i], &other = openings[j];
            if (one.part == other.part) {
                const Eigen::Vector3d faced = one.area.cwiseMin(other.area);
                most = most.cwiseMax(
                    faced.cwiseProduct((one.centre - other.centre).cwiseAbs()).eval());
            }
        }
    }
    return most;
}

Eigen::Vector3d extentsOf(const MeshArrays& mesh) {
    Eigen::AlignedBox3d box;
    for (Eigen::Index i = 0; i < mesh.F.size(); ++i) {
        box.extend(mesh.V.row(mesh.F.data()[i]).transpose());
    }
    return box.isEmpty() ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(box.sizes());
}

/// The area seen along each axis, near and far side added, and the area itself.
Eigen::Vector4d areasAlong(const MeshArrays& mesh) {
    Eigen::Vector4d sum(0, 0, 0, 0);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::Vector3d normal = doubleAreaNormal(mesh, f) / 2;
        sum.head<3>() += normal.cwiseAbs();
        sum.w() += normal.norm();
    }
    return sum;
}

/// The axis along which the only opening of a nearly closed surface faces; nothing if it faces
/// between axes, or there are more openings.
std::optional<int> axisOfOnlyOpening(const MeshArrays& mesh, const std::vector<Opening>& openings) {
    if (openings.size() != 1) {
        return std::nullopt;
    }
    const Eigen::Vector3d area = openings.front().area;
    int axis = 0;
    const double most = area.maxCoeff(&axis);
    const bool isClear =
        area.norm() < kOneOpening * areasAlong(mesh).w() && most > kFacesAlong * area.norm();
    return isClear ? std::optional(axis) : std::nullopt;
}

}  // namespace

UpGuess guessUpAxis(const MeshArrays& mesh) {
    const Eigen::Vector3d extents = extentsOf(mesh);
    const UpGuess byExtents = guessUpAxis(extents);
    const std::vector<Opening> openings = openingsOf(mesh);
    Eigen::Vector3d between = volumesBetween(openings);
    const Eigen::Vector4d surface = areasAlong(mesh);
    for (int axis = 0; axis < 3; ++axis) {
        between[axis] = surface[axis] > kLevel * surface.w() ? 0 : between[axis];
    }
    const double size = extents.maxCoeff();
    const double least = kMinBetween * extents.cwiseMax(kFlattest * size).prod();
    const double along = std::max(between.y(), between.z());
    if (along > least && along > 0) {
        if (between.z() > kClearlyApart * between.y()) {
            return {UpAxis::Z, false,
                    worded("the openings lie one above the other along z: z is up")};
        }
        if (between.y() > kClearlyApart * between.z()) {
            return {UpAxis::Y, false,
                    worded("the openings lie one above the other along y: y is up")};
        }
        return byExtents.axis == UpAxis::Z
                   ? byExtents
                   : UpGuess{UpAxis::Y, true,
                             worded("the openings lie as far apart along y as along z: z may be "
                                    "up")};
    }
    const std::optional<int> facing = axisOfOnlyOpening(mesh, openings);
    if (byExtents.axis == UpAxis::Z) {
        return byExtents;
    }
    if (facing == 1) {
        return {UpAxis::Y, false, worded("the only opening faces along y: y is up")};
    }
    if (facing == 2) {
        return {UpAxis::Y, true, worded("the only opening faces along z: z may be up")};
    }
    return between.x() > least && between.x() > 0 && !byExtents.inDoubt
               ? UpGuess{UpAxis::Y, true,
                         worded("the openings lie beside each other along x: y or z may be up")}
               : byExtents;
}

namespace {

/// Number of triangles to sample.
constexpr int kMaxLooks = 500;
/// In how many more directions one side must see cloth than the other.
constexpr int kSeesMore = 2;
/// A part, or a file, is a sheet if less than this share of it has an inside. If it has one, at
/// least the second share must face the same side.
constexpr double kEnoughSeen = 0.3, kMaxLook = 0.8;
/// A smaller share of cloth that faces inwards is a pocket or a facing.
constexpr double kInwards = 0.1;

/// Triangles that represent equal shares of the area.
std::vector<int> sampledTriangles(const Eigen::VectorXd& areas) {
    std::vector<double> upTo(static_cast<std::size_t>(areas.size()));
    std::partial_sum(areas.begin(), areas.end(), upTo.begin());
    std::vector<int> sampled;
    for (int k = 0; k < kMaxLooks; ++k) {
        const auto found =
            std::lower_bound(upTo.begin(), upTo.end(), upTo.back() * (k + 0.5) / kMaxLooks);
        sampled.push_back(static_cast<int>(found - upTo.begin()));
    }
    return sampled;
}

/// Faces with the same winding, joined by edges: pieces, after repair.
geometry::DisjointSets partsWoundAlike(const Triangles& F, Eigen::Index vertices) {
    const EdgeTable table = buildEdgeTable(F, static_cast<int>(vertices));
    geometry::DisjointSets parts(static_cast<int>(F.rows()));
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const auto uses = table.usesOf(e);
        const auto starts = [&](int use) { return F(use / 3, use % 3); };
        if (uses.size() == 2 && starts(uses[0]) != starts(uses[1])) {
            parts.join(uses[0] / 3, uses[1] / 3);
        }
    }
    return parts;
}

/// How many of five directions around the normal, or against it, hit cloth.
int clothSeen(const shell::Rays& rays, int triangle, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d across = normal.unitOrthogonal(), other = normal.cross(across);
    int met = rays.all(triangle, normal).empty() ? 0 : 1;
    for (const Eigen::Vector3d& aside :
         {across, other, Eigen::Vector3d(-across), Eigen::Vector3d(-other)}) {
        met += rays.all(triangle, (normal + aside).normalized()).empty() ? 0 : 1;
    }
    return met;
}

/// The observations of a part.
struct PartLooks {
    int looks = 0, outwards = 0, inwards = 0;

    bool isMostly(int count) const {
        return outwards + inwards >= kEnoughSeen * looks &&
               count >= kMaxLook * (outwards + inwards);
    }
};

}  // namespace

ClothSide sideOfFaces(const MeshArrays& mesh) {
    const shell::Surface surface =
        shell::surfaceWith(mesh, std::vector<int>(static_cast<std::size_t>(mesh.F.rows()), 0));
    if (!(surface.area.sum() > 0)) {
        return {};
    }
    const shell::Rays rays(surface);
    geometry::DisjointSets parts = partsWoundAlike(mesh.F, mesh.V.rows());
    std::map<int, PartLooks> seen;
    for (const int triangle : sampledTriangles(surface.area)) {
        const Eigen::Vector3d normal = surface.normal.row(triangle);
        PartLooks& part = seen[parts.root(triangle)];
        const int before = clothSeen(rays, triangle, normal),
                  behind = clothSeen(rays, triangle, -normal);
        ++part.looks;
        part.outwards += behind - before >= kSeesMore ? 1 : 0;
        part.inwards += before - behind >= kSeesMore ? 1 : 0;
    }
    int outwards = 0, inwards = 0;
    for (const auto& [root, part] : seen) {
        outwards += part.isMostly(part.outwards) ? part.outwards : 0;
        inwards += part.isMostly(part.inwards) ? part.inwards : 0;
    }
    const int both = outwards + inwards;
    if (both < kEnoughSeen * kMaxLooks) {
        return {
            ClothSide::Way::Unknown,
            worded(
                "an open sheet does not show its right side, so the winding of its faces decides")};
    }
    const auto percent = [both](int count) { return figure(100.0 * count / both); };
    return inwards >= kInwards * both
               ? ClothSide{ClothSide::Way::Inwards,
                           worded("%1 % of the cloth around an inside points inwards",
                                  {percent(inwards)})}
               : ClothSide{ClothSide::Way::Outwards,
                           worded("%1 % of the cloth around an inside points outwards",
                                  {percent(outwards)})};
}

}  // namespace toile
