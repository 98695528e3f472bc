// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/item_rings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <polyclipping/clipper.hpp>

#include "core/geometry/segment.h"

namespace toile {
namespace {

constexpr const char* kNoOutline = translatable("its outline is not a polygon");
constexpr const char* kWoundTwice =
    translatable("its outline winds around twice, or a hole is outside it or overlaps another");
constexpr const char* kNoArea = translatable("its outline has no area");
constexpr const char* kNoCopies = translatable("its copies or angles are not valid numbers");

}  // namespace
}  // namespace toile

namespace toile::nest {
namespace {

using geometry::Polygon;

constexpr double kNestGrid = 1e-5;  // mm: Clipper's integer grid
constexpr double kArcShare = 1e-3;  // mm: by how much the arcs of a gap exceed it
constexpr double kMinSide = 1e-3;   // mm: of an outline's box

bool isUsable(const NestPlacement& placement) {
    return std::isfinite(placement.angle) && std::abs(placement.x) <= kMaxSize &&
           std::abs(placement.y) <= kMaxSize;
}

/// The rings without points that repeat their predecessor.
Rings withoutRepeats(const Rings& rings) {
    Rings result;
    for (const Polygon& ring : rings) {
        Polygon kept(ring.rows(), 2);
        Eigen::Index count = 0;
        for (Eigen::Index k = 0; k < ring.rows(); ++k) {
            if (ring.row(k) != ring.row((k + 1) % ring.rows())) {
                kept.row(count++) = ring.row(k);
            }
        }
        result.emplace_back(kept.topRows(count));
    }
    return result;
}

ClipperLib::Path gridPathOf(const Polygon& ring) {
    ClipperLib::Path path;
    for (Eigen::Index k = 0; k < ring.rows(); ++k) {
        path.emplace_back(std::llround(ring(k, 0) / kNestGrid),
                          std::llround(ring(k, 1) / kNestGrid));
    }
    return path;
}

/// Whether the outline winds once around its inside, and the holes lie in it and apart: then the
/// areas of the rings add up to that of the difference. Overlapping edges do not count as crossing.
/// @param rings  wound, none crossing another
bool areWoundOnce(const Rings& rings) {
    ClipperLib::Clipper clipper;
    double area = 0, length = 0;
    for (std::size_t k = 0; k < rings.size(); ++k) {
        clipper.AddPath(gridPathOf(rings[k]), k == 0 ? ClipperLib::ptSubject : ClipperLib::ptClip,
                        true);
        area += geometry::signedAreaOf(rings[k]);
        length += geometry::perimeterOf(rings[k]);
    }
    ClipperLib::Paths left;
    clipper.Execute(ClipperLib::ctDifference, left, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    double covered = 0;
    for (const ClipperLib::Path& path : left) {
        covered += ClipperLib::Area(path) * kNestGrid * kNestGrid;
    }
    return std::abs(covered - area) <= 2 * kNestGrid * length + 1e-9 * covered;
}

/// @param rings  without repeats
const char* wrongInRings(const Rings& rings) {
    if (rings.empty() || std::ranges::any_of(rings, [](const Polygon& ring) {
            return ring.rows() < 3 || !ring.allFinite() || ring.cwiseAbs().maxCoeff() > kMaxSize;
        })) {
        return kNoOutline;
    }
    const Eigen::RowVector2d sides = rings[0].colwise().maxCoeff() - rings[0].colwise().minCoeff();
    if (!(sides.minCoeff() >= kMinSide && std::abs(geometry::signedAreaOf(rings[0])) > 0)) {
        return kNoArea;
    }
    if (doRingsCross(rings)) {
        return kNoOutline;
    }
    return areWoundOnce(wound(rings)) ? nullptr : kWoundTwice;
}

bool isUsable(const NestLattice& lattice) {
    return lattice.anchor.allFinite() && lattice.phase.allFinite() &&
           (lattice.step.array() >= 0).all();
}

}  // namespace

Error wrongItem(const NestItem& item, const Wording& what) {
    return {ErrorCode::MalformedFile, Subject::piece(item.name), what};
}

Result<Rings> usableRings(const Subject& subject, const Rings& rings) {
    Rings kept = withoutRepeats(rings);
    if (const char* fault = wrongInRings(kept)) {
        return Error{ErrorCode::MalformedFile, subject, fault};
    }
    return wound(std::move(kept));
}

Result<Rings> usableRings(const NestItem& item) {
    auto rings = usableRings(Subject::piece(item.name), item.rings);
    if (rings && (item.angles.empty() ||
                  !std::ranges::all_of(item.angles, [](double a) { return std::isfinite(a); }) ||
                  !(item.tolerance >= 0) || item.demand < 0 ||
                  (item.fixed && (item.demand != 1 || !isUsable(*item.fixed))) ||
                  (item.lattice && !isUsable(*item.lattice)))) {
        return wrongItem(item, kNoCopies);
    }
    return rings;
}

Result<Rings> grownRings(const Subject& subject, const Rings& rings, double distance) {
    if (!(distance > 0)) {
        return rings;
    }
    ClipperLib::ClipperOffset offset(2.0, kArcShare / kNestGrid / 2);
    for (const Polygon& ring : rings) {
        offset.AddPath(gridPathOf(ring), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    }
    ClipperLib::Paths paths;
    offset.Execute(paths, (distance + kArcShare) / kNestGrid);
    std::ranges::sort(paths, std::ranges::greater{},
                      [](const auto& path) { return ClipperLib::Area(path); });
    Rings result;
    for (const ClipperLib::Path& path : paths) {
        Polygon ring(static_cast<Eigen::Index>(path.size()), 2);
        for (std::size_t k = 0; k < path.size(); ++k) {
            ring.row(static_cast<Eigen::Index>(k)) << static_cast<double>(path[k].X) * kNestGrid,
                static_cast<double>(path[k].Y) * kNestGrid;
        }
        result.push_back(ring);
    }
    if (result.empty()) {
        return Error{ErrorCode::MalformedFile, subject, kNoOutline};
    }
    return result;
}

namespace {

using Eigen::Vector2d;
using geometry::cross;
using geometry::Polygon;

/// A possible change at a corner: remove it or, with the one after it, move it to `to`.
struct Cut {
    double area = HUGE_VAL;  ///< added area; infinite: not possible
    double off = 0;          ///< distance from the true outline afterwards
    bool isExtended = false;
    Vector2d to = Vector2d::Zero();
};

class Simplifier {
public:
    Simplifier(const Rings& rings, double tolerance) : tolerance_(tolerance) {
        for (const Polygon& ring : rings) {
            const std::size_t first = at_.size(), count = static_cast<std::size_t>(ring.rows());
            for (std::size_t k = 0; k < count; ++k) {
                at_.emplace_back(ring.row(static_cast<Eigen::Index>(k)));
                next_.push_back(first + (k + 1) % count);
                last_.push_back(first + (k + count - 1) % count);
                ring_.push_back(sizes_.size());
            }
            sizes_.push_back(count);
        }
        left_ = at_.size();
        off_.resize(left_);
        isGone_.resize(left_);
        cuts_.resize(left_);
        for (std::size_t k = 0; k < left_; ++k) {
            cuts_[k] = cutAt(k);
        }
    }

    void run(std::size_t enough) {
        while (left_ > enough) {
            const auto least = std::ranges::min_element(cuts_, {}, &Cut::area);
            if (!(least->area < HUGE_VAL)) {
                return;
            }
            const auto k = static_cast<std::size_t>(least - cuts_.begin());
            if (!apply(k, *least)) {
                least->area = HUGE_VAL;
            }
        }
    }

    Rings rings() const {
        Rings result;
        std::vector<Vector2d> points;
        for (std::size_t k = 0; k < at_.size(); ++k) {
            if (!isGone_[k]) {
                points.push_back(at_[k]);
            }
            if (k + 1 == at_.size() || ring_[k + 1] != ring_[k]) {
                Polygon ring(static_cast<Eigen::Index>(points.size()), 2);
                for (std::size_t p = 0; p < points.size(); ++p) {
                    ring.row(static_cast<Eigen::Index>(p)) = points[p];
                }
                result.push_back(std::move(ring));
                points.clear();
            }
        }
        return result;
    }

private:
    double turnAt(std::size_t k) const {
        return cross(at_[k] - at_[last_[k]], at_[next_[k]] - at_[k]);
    }

    Cut cutAt(std::size_t k) const {
        Cut cut;
        const std::size_t last = last_[k], next = next_[k], after = next_[next];
        if (isGone_[k] || sizes_[ring_[k]] <= 4) {
            return cut;
        }
        const Vector2d &a = at_[last], &b = at_[k], &c = at_[next], &d = at_[after];
        const double turn = turnAt(k);
        double off = HUGE_VAL, area = 0;
        if (turn <= 0) {
            if ((b - a).dot(c - b) > 0) {
                off = std::max(off_[last], off_[k]) + geometry::distanceToSegment(b, a, c);
                area = -turn / 2;
            }
        } else if (turnAt(next) > 0 && cross(b - a, d - c) > 0) {
            const double share = cross(c - b, d - c) / cross(b - a, d - c);
            cut.isExtended = true;
            cut.to = b + share * (b - a);
            off = off_[k] + geometry::distanceToSegment(cut.to, b, c);
            area = cross(cut.to - b, c - b) / 2;
            area = std::abs(area);
        }
        if (off <= tolerance_) {
            cut.off = off;
            cut.area = area;
        }
        return cut;
    }

    /// Whether a new side touches none but its neighbours.
    bool isFree(const Vector2d& from, const Vector2d& to) const {
        const Vector2d low = from.cwiseMin(to), high = from.cwiseMax(to);
        for (std::size_t k = 0; k < at_.size(); ++k) {
            if (isGone_[k]) {
                continue;
            }
            const Vector2d &a = at_[k], &b = at_[next_[k]];
            if (a == from || a == to || b == from || b == to ||
                !(a.cwiseMin(b).array() <= high.array()).all() ||
                !(a.cwiseMax(b).array() >= low.array()).all()) {
                continue;
            }
            const double s0 = cross(to - from, a - from), s1 = cross(to - from, b - from);
            const double t0 = cross(b - a, from - a), t1 = cross(b - a, to - a);
            if (s0 * s1 <= 0 && t0 * t1 <= 0) {
                return false;
            }
        }
        return true;
    }

    bool apply(std::size_t k, const Cut& cut) {
        const std::size_t last = last_[k], next = next_[k];
        const Vector2d before = at_[k], beforeNext = at_[next];
        if (cut.isExtended) {  // the side temporarily shrinks to a point
            at_[k] = at_[next] = cut.to;
            if (!isFree(at_[last], cut.to) || !isFree(cut.to, at_[next_[next]])) {
                at_[k] = before;
                at_[next] = beforeNext;
                return false;
            }
            off_[last] = std::max(off_[last], cut.off);
            off_[k] = std::max(off_[next], cut.off);
            remove(next);
        } else {
            isGone_[k] = true;
            if (!isFree(at_[last], at_[next])) {
                isGone_[k] = false;
                return false;
            }
            off_[last] = cut.off;
            remove(k);
        }
        std::size_t changed = last_[last_[last]];
        for (int count = 0; count < 7; ++count) {
            cuts_[changed] = cutAt(changed);
            changed = next_[changed];
        }
        return true;
    }

    void remove(std::size_t k) {
        isGone_[k] = true;
        next_[last_[k]] = next_[k];
        last_[next_[k]] = last_[k];
        --sizes_[ring_[k]];
        --left_;
        cuts_[k] = {};
    }

    double tolerance_;
    std::vector<Vector2d> at_;
    std::vector<std::size_t> next_, last_, ring_, sizes_;
    std::vector<double> off_;  ///< of the side after a corner
    std::vector<bool> isGone_;
    std::vector<Cut> cuts_;
    std::size_t left_ = 0;
};

}  // namespace

Rings simplified(const Rings& rings, double tolerance, std::size_t enough) {
    Simplifier simplifier(rings, tolerance);
    simplifier.run(enough);
    Rings result = simplifier.rings();
    return doRingsCross(result) ? rings : result;
}

}  // namespace toile::nest
