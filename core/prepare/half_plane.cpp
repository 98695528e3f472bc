// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/half_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"
#include "core/mesh/repair.h"

namespace toile {
namespace {

using Plane = Eigen::Hyperplane<double, 3>;

/// How far rims may lie off the plane, relative to a garment's size.
constexpr double kHalfTolerance = 1e-3;
/// Relative to a garment's size: the minimum depth off the plane, the minimum spread of the rims in
/// it, seen from above, and their minimum length if the user did not say that it is half.
constexpr double kMinDepth = 0.05, kMinSpread = 0.05, kOfferedLength = 0.5;
/// Minimum shares of all rims in the plane: offered, stated, and without any other rim.
constexpr double kOfferedShare = 0.2, kStatedShare = 0.05, kNoOtherRim = 0.99;
/// Minimum share of the rims in the plane that go up or down: those of flat panels do not.
constexpr double kRising = 0.3;
/// Minimum share of the rims in the plane that counts as a separate place.
constexpr double kChainShare = 0.1;

/// Input of the search.
struct HalfRims {
    double lengthOf(const std::pair<int, int>& rim) const {
        return (V->row(rim.first) - V->row(rim.second)).norm();
    }

    const Points3* V = nullptr;
    std::vector<int> used;                  ///< vertices
    std::vector<int> part;                  ///< per vertex: its connected part
    std::vector<std::pair<int, int>> rims;  ///< edges of the border
    double length = 0;                      ///< of these, mm
    bool isOne = false;                     ///< all connected, like those of a panel
    double size = 0;                        ///< of the garment, mm
    Eigen::Vector3d along[2];               ///< the two level axes
};

double sizeOf(const MeshArrays& mesh) {
    Eigen::AlignedBox3d box;
    for (Eigen::Index i = 0; i < mesh.F.size(); ++i) {
        box.extend(mesh.V.row(mesh.F.data()[i]).transpose());
    }
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

HalfRims rimsOfHalf(const MeshArrays& mesh, UpAxis up) {
    HalfRims found;
    found.V = &mesh.V;
    found.size = sizeOf(mesh);
    found.along[0] = Eigen::Vector3d::UnitX();
    found.along[1] = up == UpAxis::Y ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    const std::vector<char> isUsed = usedVertices(mesh.F, mesh.V.rows());
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (isUsed[v] != 0) {
            found.used.push_back(v);
        }
    }
    const Triangles faces = weldedFaces(mesh);
    const EdgeTable table = buildEdgeTable(faces, static_cast<int>(mesh.V.rows()));
    geometry::DisjointSets loops(static_cast<int>(mesh.V.rows())), parts = loops;
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
        parts.join(faces(f, 0), faces(f, 1));
        parts.join(faces(f, 0), faces(f, 2));
    }
    for (int v = 0; v < mesh.V.rows(); ++v) {
        found.part.push_back(parts.root(v));
    }
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            const int a = table.edges(e, 0), b = table.edges(e, 1);
            found.rims.emplace_back(a, b);
            found.length += found.lengthOf(found.rims.back());
            loops.join(a, b);
        }
    }
    found.isOne = std::ranges::all_of(found.rims, [&](const auto& rim) {
        return loops.root(rim.first) == loops.root(found.rims.front().first);
    });
    return found;
}

/// The rims in a plane.
struct RimsInPlane {
    double open = 0;        ///< mm, of those that continue outside it
    double closed = 0;      ///< mm, of openings entirely within it
    double spread = 0;      ///< their extent seen from above, mm
    double rise = 0;        ///< vertical extent of the open ones, mm
    int chains = 0;         ///< number of long open ones
    bool isBeside = false;  ///< parts side by side, each of which would close to its own tube
};

/// The rims of one part in the plane, by their position along it, mm.
struct PartInPlane {
    double from = 0, to = 0;
    int chains = 0;
};

/// Half a garment goes around once, with its lining inside; two strips next to each other go around
/// twice.
bool areBeside(const std::map<int, PartInPlane>& parts, double leastSpread) {
    std::vector<PartInPlane> round;
    for (const auto& [part, in] : parts) {
        if (in.chains > 1 && in.to - in.from >= leastSpread) {
            round.push_back(in);
        }
    }
    std::ranges::sort(round, {}, &PartInPlane::from);
    double reached = round.empty() ? 0 : round.front().to;
    return std::ranges::any_of(round, [&reached](const PartInPlane& in) {
        const bool isApart = in.from > reached;
        reached = std::max(reached, in.to);
        return isApart;
    });
}

RimsInPlane rimsIn(const HalfRims& half, const Plane& plane, double tolerance) {
    const auto isIn = [&](int v) {
        return std::abs(plane.signedDistance(half.V->row(v).transpose())) <= tolerance;
    };
    double all = 0;
    for (const auto& rim : half.rims) {
        all += isIn(rim.first) && isIn(rim.second) ? half.lengthOf(rim) : 0;
    }
    if (all < kStatedShare * half.length) {
        return {};  // true for most planes: the rest takes longer
    }
    geometry::DisjointSets chains(static_cast<int>(half.V->rows()));
    std::vector<char> goesOn(static_cast<std::size_t>(half.V->rows()), 0);
    for (const auto& [a, b] : half.rims) {
        const bool first = isIn(a), second = isIn(b);
        if (first && second) {
            chains.join(a, b);
        } else {
            goesOn[first ? a : b] |= static_cast<char>(first || second);
        }
    }
    for (int v = 0; v < half.V->rows(); ++v) {
        if (goesOn[v] != 0) {
            goesOn[chains.root(v)] = 1;
        }
    }
    const Eigen::Vector3d upright = half.along[0].cross(half.along[1]);
    const Eigen::Vector3d level = upright.cross(plane.normal());
    RimsInPlane found;
    std::vector<double> ofChain(static_cast<std::size_t>(half.V->rows()), 0);
    std::map<int, PartInPlane> ofPart;
    double least = 0, most = 0;
    bool isAny = false;
    for (const auto& [a, b] : half.rims) {
        if (!isIn(a) || !isIn(b)) {
            continue;
        }
        const double length = half.lengthOf({a, b});
        const int chain = chains.root(a);
        (goesOn[chain] != 0 ? found.open : found.closed) += length;
        if (goesOn[chain] != 0) {
            ofChain[chain] += length;
            found.rise += std::abs((half.V->row(b) - half.V->row(a)) * upright);
        }
        for (const int v : {a, b}) {
            const double at = half.V->row(v) * level;
            least = isAny ? std::min(least, at) : at;
            most = isAny ? std::max(most, at) : at;
            isAny = true;
            PartInPlane& in = ofPart.try_emplace(half.part[v], PartInPlane{at, at}).first->second;
            in = {std::min(in.from, at), std::max(in.to, at)};
        }
    }
    found.spread = most - least;
    for (int chain = 0; chain < half.V->rows(); ++chain) {
        if (ofChain[chain] > 0 && ofChain[chain] >= kChainShare * found.open) {
            ++found.chains;
            ++ofPart[half.part[chain]].chains;
        }
    }
    found.isBeside = areBeside(ofPart, kMinSpread * half.size);
    return found;
}

/// Whether these rims alone indicate half a garment.
bool mayBeOffered(const HalfRims& half, const RimsInPlane& in) {
    return in.open >= kOfferedShare * half.length && in.open >= kOfferedLength * half.size &&
           in.spread >= kMinSpread * half.size && in.rise >= kRising * in.open && !in.isBeside &&
           (in.chains > 1 || !half.isOne);
}

/// The plane oriented so that its normal points at the cloth; nothing if cloth lies on both sides
/// or nowhere off it.
std::optional<Plane> besideCloth(const HalfRims& half, const Plane& plane, double tolerance) {
    double least = 0, most = 0;
    for (const int v : half.used) {
        const double distance = plane.signedDistance(half.V->row(v).transpose());
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
    if (std::min(-least, most) > tolerance || std::max(-least, most) < kMinDepth * half.size) {
        return std::nullopt;
    }
    return most >= -least ? plane : Plane(-plane.normal(), -plane.offset());
}

/// The convex hull of the rims seen from above.
geometry::Polygon outlineFromAbove(const HalfRims& half) {
    geometry::Polygon points(2 * static_cast<Eigen::Index>(half.rims.size()), 2);
    Eigen::Index k = 0;
    for (const auto& [a, b] : half.rims) {
        for (const int v : {a, b}) {
            points.row(k++) << half.V->row(v) * half.along[0], half.V->row(v) * half.along[1];
        }
    }
    return geometry::convexHull(points);
}

/// Candidate mirror planes, the most likely first; the first two are the file's own.
std::vector<Plane> candidates(const HalfRims& half) {
    std::vector<Plane> planes{{half.along[0], 0}, {half.along[1], 0}};
    const geometry::Polygon hull = outlineFromAbove(half);
    for (Eigen::Index k = 0; k < hull.rows(); ++k) {
        const Eigen::Vector2d way = hull.row((k + 1) % hull.rows()) - hull.row(k);
        if (way.norm() >= kMinSpread * half.size) {
            const Eigen::Vector2d inwards = geometry::leftOf(way.normalized());
            const Eigen::Vector3d normal =
                inwards.x() * half.along[0] + inwards.y() * half.along[1];
            planes.emplace_back(normal, -hull.row(k).dot(inwards));
        }
    }
    // A flat panel has no outline from above: use its ends.
    for (const Eigen::Vector3d& axis : half.along) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const int v : half.used) {
            const double at = half.V->row(v).dot(axis);
            least = std::min(least, at);
            most = std::max(most, at);
        }
        planes.emplace_back(axis, -least);
        planes.emplace_back(-axis, most);
    }
    return planes;
}

}  // namespace

double halfTolerance(const MeshArrays& mesh) {
    return kHalfTolerance * sizeOf(mesh);
}

std::optional<HalfPlane> findHalfPlane(const FileSurface& surface, UpAxis up, bool isStated) {
    const HalfRims half = rimsOfHalf(surface.mesh, up);
    if (half.rims.empty() || !(half.size > 0) || !std::isfinite(half.size)) {
        return std::nullopt;
    }
    const double tolerance = kHalfTolerance * half.size;
    std::vector<HalfPlane> offered;  // the file's own planes first
    std::optional<HalfPlane> longest;
    int index = 0;
    for (const Plane& candidate : candidates(half)) {
        const bool isOfFile = index++ < 2;
        const RimsInPlane in = rimsIn(half, candidate, tolerance);
        const double length =
            isStated && in.closed > kNoOtherRim * half.length ? in.closed : in.open;
        const bool isGood = mayBeOffered(half, in);
        const auto plane = isGood || (isStated && length >= kStatedShare * half.length)
                               ? besideCloth(half, candidate, tolerance)
                               : std::nullopt;
        if (plane && isGood) {
            offered.push_back({*plane, length, false});
            if (isOfFile && isStated) {
                break;
            }
        }
        if (plane && (!longest || length > longest->length)) {
            longest = HalfPlane{*plane, length, false};
        }
    }
    if (isStated) {
        return offered.empty() ? longest : offered.front();
    }
    // Panels that are not sewn yet have such rims on both sides.
    const bool isOnBothSides = std::ranges::any_of(offered, [&](const HalfPlane& other) {
        return other.plane.normal().dot(offered.front().plane.normal()) < 0;
    });
    return offered.empty() || isOnBothSides ? std::nullopt : std::optional(offered.front());
}

}  // namespace toile
