// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/strip.h"

#include <array>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"

namespace toile {
namespace {

double angleOfTurn(const SurfaceLinks& links, int vertex, const std::vector<int>& exits) {
    double sum = 0;
    for (std::size_t i = 1; i < exits.size(); ++i) {
        const int face = exits[i] / 3;
        sum += links.angleAt(3 * face + links.cornerIn(face, vertex));
    }
    return sum;
}

/// The path from one triangle to the next at a point that both touch.
std::optional<std::vector<int>> exitsAt(const SurfaceLinks& links, const SurfacePoint& point,
                                        int fromFace, int toFace) {
    const Carrier carrier = links.carrierOf(point);
    if (fromFace == toFace) {
        return std::vector<int>{};
    }
    if (carrier.kind == Carrier::Kind::Edge) {
        for (int use = 3 * fromFace; use < 3 * fromFace + 3; ++use) {
            if (links.edgeOf(use) == carrier.index && links.twin(use) / 3 == toFace &&
                links.twin(use) >= 0) {
                return std::vector<int>{use};
            }
        }
        return std::nullopt;
    }
    if (carrier.kind == Carrier::Kind::Face) {
        return std::nullopt;
    }
    auto left = exitsAround(links, carrier.index, fromFace, toFace, true);
    auto right = exitsAround(links, carrier.index, fromFace, toFace, false);
    if (left && right) {
        const bool leftIsSmaller =
            angleOfTurn(links, carrier.index, *left) <= angleOfTurn(links, carrier.index, *right);
        return leftIsSmaller ? left : right;
    }
    return left ? left : right;
}

}  // namespace

std::optional<std::vector<int>> exitsAround(const SurfaceLinks& links, int vertex, int fromFace,
                                            int toFace, bool leftward) {
    std::vector<int> exits;
    for (int face = fromFace; face != toFace;) {
        const int corner = links.cornerIn(face, vertex);
        const int use = 3 * face + (leftward ? (corner + 2) % 3 : corner);
        if (links.twin(use) < 0) {
            return std::nullopt;
        }
        exits.push_back(use);
        face = links.twin(use) / 3;
        if (face == fromFace) {
            return std::nullopt;  // once around: another fan of a pinched vertex
        }
    }
    return exits;
}

std::optional<Strip> stripAlong(const SurfaceLinks& links,
                                const std::vector<SurfacePoint>& points) {
    Strip strip;
    int face = points.size() < 2 ? -1 : links.commonFace(points[0], points[1]);
    if (face < 0) {
        return std::nullopt;
    }
    strip.from = *links.seenFrom(face, points.front());
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const int next = links.commonFace(points[i], points[i + 1], face);
        if (next < 0) {
            return std::nullopt;
        }
        const auto exits = exitsAt(links, points[i], face, next);
        if (!exits) {
            return std::nullopt;
        }
        strip.exits.insert(strip.exits.end(), exits->begin(), exits->end());
        face = next;
    }
    strip.to = *links.seenFrom(face, points.back());
    tidy(links, strip);
    return strip;
}

void tidy(const SurfaceLinks& links, Strip& strip) {
    std::vector<int> kept;
    for (const int use : strip.exits) {
        if (!kept.empty() && links.twin(kept.back()) == use) {
            kept.pop_back();
        } else {
            kept.push_back(use);
        }
    }
    std::size_t first = 0;
    while (first < kept.size()) {
        const auto seen = links.seenFrom(links.twin(kept[first]) / 3, strip.from);
        if (!seen) {
            break;
        }
        strip.from = *seen;
        ++first;
    }
    while (kept.size() > first) {
        const auto seen = links.seenFrom(kept.back() / 3, strip.to);
        if (!seen) {
            break;
        }
        strip.to = *seen;
        kept.pop_back();
    }
    strip.exits.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

namespace {

using Flat = std::array<Eigen::Vector2d, 3>;

/// The third corner of a triangle in the plane, to the left of a -> b or to its right.
Eigen::Vector2d thirdCorner(const MeshArrays& mesh, int a, int b, int c,
                            const Eigen::Vector2d& flatA, const Eigen::Vector2d& flatB,
                            bool toTheLeft) {
    const Eigen::Vector3d ab = mesh.V.row(b) - mesh.V.row(a);
    const Eigen::Vector3d ac = mesh.V.row(c) - mesh.V.row(a);
    const double length = ab.norm();
    const Eigen::Vector2d along = (flatB - flatA).normalized();
    const Eigen::Vector2d across(-along.y(), along.x());
    const double height = ab.cross(ac).norm() / length;
    return flatA + ab.dot(ac) / length * along + (toTheLeft ? height : -height) * across;
}

Eigen::Vector2d mix(const Flat& corners, const Eigen::Vector3d& weights) {
    return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

}  // namespace

FlatStrip layFlat(const SurfaceLinks& links, const Strip& strip) {
    const MeshArrays& mesh = links.mesh();
    const int first = strip.from.face;
    Flat corners;
    corners[0] = Eigen::Vector2d::Zero();
    corners[1] =
        Eigen::Vector2d((mesh.V.row(mesh.F(first, 1)) - mesh.V.row(mesh.F(first, 0))).norm(), 0);
    corners[2] = thirdCorner(mesh, mesh.F(first, 0), mesh.F(first, 1), mesh.F(first, 2), corners[0],
                             corners[1], true);
    FlatStrip flat;
    flat.from = mix(corners, strip.from.barycentric);
    flat.gates.reserve(strip.exits.size());
    for (const int use : strip.exits) {
        const int k = use % 3;
        const FlatStrip::Gate gate{corners[(k + 1) % 3], corners[k], links.head(use),
                                   links.tail(use)};
        flat.gates.push_back(gate);
        const int other = links.twin(use);
        const int apex = (other % 3 + 2) % 3;
        corners[other % 3] = gate.left;
        corners[(other % 3 + 1) % 3] = gate.right;
        corners[apex] = thirdCorner(mesh, gate.rightVertex, gate.leftVertex,
                                    mesh.F(other / 3, apex), gate.right, gate.left, false);
    }
    flat.to = mix(corners, strip.to.barycentric);
    return flat;
}

std::vector<Bend> shortestThroughGates(const FlatStrip& strip) {
    const int count = static_cast<int>(strip.gates.size());
    std::vector<Bend> bends;
    Eigen::Vector2d apex = strip.from;
    int apexGate = -1;
    // The funnel's two arms, as vectors from the apex, and the gate that last narrowed each.
    Eigen::Vector2d left = Eigen::Vector2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    int leftGate = -1;
    int rightGate = -1;
    bool hasLeft = false;  // an arm of zero length blocks nothing
    bool hasRight = false;
    const auto restartAt = [&](int gate, bool atLeft) {
        apex = atLeft ? strip.gates[gate].left : strip.gates[gate].right;
        bends.push_back({gate, atLeft, apex});
        apexGate = gate;
        hasLeft = false;
        hasRight = false;
    };
    int i = 0;
    while (i <= count) {
        const Eigen::Vector2d toLeft = (i < count ? strip.gates[i].left : strip.to) - apex;
        const Eigen::Vector2d toRight = (i < count ? strip.gates[i].right : strip.to) - apex;
        if (hasLeft && toRight.squaredNorm() > 0 && geometry::cross(left, toRight) > 0) {
            restartAt(leftGate, true);  // the right arm would cross the left one
            i = apexGate + 1;
            continue;
        }
        if (hasRight && toLeft.squaredNorm() > 0 && geometry::cross(right, toLeft) < 0) {
            restartAt(rightGate, false);
            i = apexGate + 1;
            continue;
        }
        if (toLeft.squaredNorm() > 0 && (!hasLeft || geometry::cross(left, toLeft) <= 0)) {
            left = toLeft;
            leftGate = i;
            hasLeft = true;
        }
        if (toRight.squaredNorm() > 0 && (!hasRight || geometry::cross(right, toRight) >= 0)) {
            right = toRight;
            rightGate = i;
            hasRight = true;
        }
        ++i;
    }
    return bends;
}

}  // namespace toile
