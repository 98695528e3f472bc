// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/straighten.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/cut/surface_paths.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

/// The consecutive triangles along a curve: triangle i is left by the side `exits[i]`. The curve
/// starts in the first and ends in the last one.
struct Strip {
    SurfacePoint from;  ///< with weights for the first triangle
    SurfacePoint to;    ///< with weights for the last triangle
    std::vector<int> exits;
};

/// A strip laid flat, triangle by triangle.
struct FlatStrip {
    /// A crossed side, seen in the direction of travel.
    struct Gate {
        Eigen::Vector2d left, right;
        int leftVertex, rightVertex;
    };

    Eigen::Vector2d from, to;
    std::vector<Gate> gates;  ///< one per exit
};

/// A bend of the shortest path through a flat strip.
struct Bend {
    int gate;   ///< a gate with the bend's vertex at one end
    bool left;  ///< which end
    Eigen::Vector2d at;
};

double angleOfTurn(const SurfaceLinks& links, int vertex, const std::vector<int>& exits) {
    double sum = 0;
    for (std::size_t i = 1; i < exits.size(); ++i) {
        const int face = exits[i] / 3;
        sum += links.angleAt(3 * face + links.cornerIn(face, vertex));
    }
    return sum;
}

/// Sides crossed when going around `vertex` from one triangle to another; nothing if a wall blocks
/// the way. @param leftward  anti-clockwise, seen from the right side
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

/// Removes steps back and forth across one edge, and triangles at the ends that are not needed
/// because the end point already touches the next one.
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

/// The strip along a polyline. At a vertex it turns to the side with the smaller angle, so that the
/// polyline runs inside the strip or along its rim. Nothing if neighbouring points share no
/// triangle, or if walls on both sides block the way around a vertex.
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

/// Bends of the shortest path from `from` to `to` through all gates, in order [LP84]. Cost: usually
/// linear, at worst quadratic in the number of gates.
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

/// A vertex is passed on the other side if that angle is smaller than pi by this much; the possible
/// gain below it is of the order of its square.
constexpr double kStraightAngle = 1e-8;
/// A crossing closer to an edge's end than this fraction of the edge goes through the vertex.
constexpr double kThroughVertex = 1e-9;
constexpr int kMaxPasses = 10000;

/// A run of gates that share a vertex, and the path around the vertex's other side.
struct Detour {
    int first, last;  ///< gates
    double angle;     ///< on the other side; below pi
    std::vector<int> exits;
};

class Tightener {
public:
    Tightener(const SurfaceLinks& links, Strip strip) : links_(links), strip_(std::move(strip)) {}

    PathPolyline run() {
        double best = HUGE_VAL;
        for (int pass = 0; pass < kMaxPasses; ++pass) {
            flat_ = layFlat(links_, strip_);
            bends_ = shortestThroughGates(flat_);
            const double length = flatLength();
            if (!(length < best * (1 - 1e-15))) {
                break;
            }
            best = length;
            const Strip before = strip_;
            if (!takeDetours()) {
                break;
            }
            tidy(links_, strip_);
            // A detour without gain in floating point would repeat forever.
            const FlatStrip next = layFlat(links_, strip_);
            if (!(lengthOf(next, shortestThroughGates(next)) < best)) {
                strip_ = before;
                break;
            }
        }
        flat_ = layFlat(links_, strip_);
        bends_ = shortestThroughGates(flat_);
        return polyline();
    }

private:
    static double lengthOf(const FlatStrip& flat, const std::vector<Bend>& bends) {
        Eigen::Vector2d at = flat.from;
        double sum = 0;
        for (const Bend& bend : bends) {
            sum += (bend.at - at).norm();
            at = bend.at;
        }
        return sum + (flat.to - at).norm();
    }

    double flatLength() const { return lengthOf(flat_, bends_); }

    int vertexAt(int gate, bool left) const {
        return left ? flat_.gates[gate].leftVertex : flat_.gates[gate].rightVertex;
    }

    Eigen::Vector2d otherEnd(int gate, bool left) const {
        return left ? flat_.gates[gate].right : flat_.gates[gate].left;
    }

    /// Last point before bend i and first after it.
    Eigen::Vector2d before(std::size_t i) const { return i == 0 ? flat_.from : bends_[i - 1].at; }

    Eigen::Vector2d after(std::size_t i) const {
        return i + 1 == bends_.size() ? flat_.to : bends_[i + 1].at;
    }

    std::optional<Detour> detourAt(std::size_t i) const {
        const Bend& bend = bends_[i];
        const int vertex = vertexAt(bend.gate, bend.left);
        const int count = static_cast<int>(flat_.gates.size());
        Detour detour{bend.gate, bend.gate, 0, {}};
        while (detour.first > 0 && vertexAt(detour.first - 1, bend.left) == vertex) {
            --detour.first;
        }
        while (detour.last + 1 < count && vertexAt(detour.last + 1, bend.left) == vertex) {
            ++detour.last;
        }
        if (!links_.isInner(vertex)) {
            return std::nullopt;
        }
        double inside =
            geometry::angleBetween(before(i) - bend.at,
                                   otherEnd(detour.first, bend.left) - bend.at) +
            geometry::angleBetween(after(i) - bend.at, otherEnd(detour.last, bend.left) - bend.at);
        for (int g = detour.first; g < detour.last; ++g) {
            inside += geometry::angleBetween(otherEnd(g, bend.left) - bend.at,
                                             otherEnd(g + 1, bend.left) - bend.at);
        }
        detour.angle = links_.angleAround(vertex) - inside;
        if (!(detour.angle < std::numbers::pi - kStraightAngle)) {
            return std::nullopt;
        }
        // The strip has the vertex on its left and turns left around it: now it turns right.
        const int fromFace = strip_.exits[detour.first] / 3;
        const int toFace = links_.twin(strip_.exits[detour.last]) / 3;
        const auto exits = exitsAround(links_, vertex, fromFace, toFace, !bend.left);
        if (!exits) {
            return std::nullopt;
        }
        detour.exits = *exits;
        return detour;
    }

    /// Takes all detours that do not touch each other, those with the largest gain first.
    bool takeDetours() {
        std::vector<Detour> found;
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            if (auto detour = detourAt(i)) {
                found.push_back(std::move(*detour));
            }
        }
        std::ranges::stable_sort(found, {}, &Detour::angle);
        std::vector<Detour> taken;
        for (Detour& detour : found) {
            const bool isFree = std::ranges::none_of(taken, [&](const Detour& other) {
                return detour.first <= other.last && other.first <= detour.last;
            });
            if (isFree) {
                taken.push_back(std::move(detour));
            }
        }
        std::ranges::sort(taken, {}, &Detour::first);
        std::vector<int> exits;
        int next = 0;
        for (const Detour& detour : taken) {
            exits.insert(exits.end(), strip_.exits.begin() + next,
                         strip_.exits.begin() + detour.first);
            exits.insert(exits.end(), detour.exits.begin(), detour.exits.end());
            next = detour.last + 1;
        }
        exits.insert(exits.end(), strip_.exits.begin() + next, strip_.exits.end());
        strip_.exits = std::move(exits);
        return !taken.empty();
    }

    void add(PathPolyline& path, const SurfacePoint& point) const {
        const Carrier next = links_.carrierOf(point);
        if (next.kind != Carrier::Kind::Vertex || path.points.empty() ||
            links_.carrierOf(path.points.back()) != next) {
            path.points.push_back(point);
        }
    }

    /// The points where the shortest path crosses each gate.
    PathPolyline polyline() const {
        PathPolyline path;
        path.length = flatLength();
        add(path, strip_.from);
        std::size_t next = 0;  // bend
        for (int g = 0; g < static_cast<int>(flat_.gates.size()); ++g) {
            const FlatStrip::Gate& gate = flat_.gates[g];
            const int use = strip_.exits[g];
            SurfacePoint point{use / 3, Eigen::Vector3d::Zero()};
            double t;
            if (next < bends_.size() && bends_[next].gate == g) {
                t = bends_[next].left ? 1 : 0;
                while (next < bends_.size() && bends_[next].gate == g) {
                    ++next;
                }
            } else {
                const Eigen::Vector2d a = next == 0 ? flat_.from : bends_[next - 1].at;
                const Eigen::Vector2d b = next < bends_.size() ? bends_[next].at : flat_.to;
                const double right = geometry::cross(b - a, gate.right - a);
                const double left = geometry::cross(b - a, gate.left - a);
                if (right == left) {  // along the gate: its closer end
                    t = (a - gate.left).squaredNorm() <= (a - gate.right).squaredNorm() ? 1 : 0;
                } else {
                    t = right / (right - left);
                }
                t = t < kThroughVertex ? 0 : t > 1 - kThroughVertex ? 1 : t;
            }
            point.barycentric[use % 3] = 1 - t;
            point.barycentric[(use % 3 + 1) % 3] = t;
            add(path, point);
        }
        add(path, strip_.to);
        return path;
    }

    const SurfaceLinks& links_;
    Strip strip_;
    FlatStrip flat_;
    std::vector<Bend> bends_;
};

}  // namespace

PathPolyline straightened(const SurfaceLinks& links, const PathPolyline& path) {
    const auto strip = stripAlong(links, path.points);
    return strip ? Tightener(links, *strip).run() : path;
}

namespace {

constexpr int kMaxRounds = 32;
/// Minimum relative gain of a slide, so that rounding does not move ends.
constexpr double kWorthwhile = 1e-9;

/// The loop that contains a vertex, and the position in it.
struct RimPlace {
    const RimLoop* loop = nullptr;
    int index = 0;
};

RimPlace placeOnRim(const SurfaceLinks& links, const std::vector<RimLoop>& rims,
                    const SurfacePoint& point) {
    const Carrier carrier = links.carrierOf(point);
    if (carrier.kind == Carrier::Kind::Vertex) {
        for (const RimLoop& rim : rims) {
            const auto at = std::ranges::find(rim.vertices, carrier.index);
            if (at != rim.vertices.end()) {
                return {&rim, static_cast<int>(at - rim.vertices.begin())};
            }
        }
    }
    return {};
}

/// The cut with its last point moved along the loop by `steps` vertices, pulled tight.
PathPolyline slid(const SurfaceLinks& links, PathPolyline cut, const RimPlace& place, int steps) {
    const int size = static_cast<int>(place.loop->vertices.size());
    const int stride = steps > 0 ? 1 : -1;
    for (int s = stride; s != steps + stride; s += stride) {
        const int at = ((place.index + s) % size + size) % size;
        cut.points.push_back(links.atVertex(place.loop->vertices[at]));
    }
    return straightened(links, cut);
}

/// Slides the last point as long as that shortens the cut. True if it did.
bool slideEnd(const SurfaceLinks& links, const std::vector<RimLoop>& rims, PathPolyline& cut) {
    RimPlace place = placeOnRim(links, rims, cut.points.back());
    if (place.loop == nullptr) {
        return false;
    }
    const int size = static_cast<int>(place.loop->vertices.size());
    bool moved = false;
    for (int step = std::max(1, size / 8); step > 0; step /= 2) {
        for (int round = 0; round < kMaxRounds; ++round) {
            PathPolyline best = cut;
            int direction = 0;
            for (const int d : {1, -1}) {
                PathPolyline other = slid(links, cut, place, d * step);
                if (other.length < best.length - kWorthwhile * cut.length) {
                    best = std::move(other);
                    direction = d;
                }
            }
            if (direction == 0) {
                break;
            }
            cut = std::move(best);
            place.index = ((place.index + direction * step) % size + size) % size;
            moved = true;
        }
    }
    return moved;
}

}  // namespace

PathPolyline shortenedCut(const SurfaceLinks& links, const std::vector<RimLoop>& rims,
                          const PathPolyline& cut) {
    PathPolyline best = straightened(links, cut);
    const auto flip = [&best] { std::reverse(best.points.begin(), best.points.end()); };
    for (int round = 0; round < kMaxRounds; ++round) {
        const bool back = slideEnd(links, rims, best);
        flip();
        const bool front = slideEnd(links, rims, best);
        flip();
        if (!back && !front) {
            break;
        }
    }
    return best;
}

}  // namespace toile
