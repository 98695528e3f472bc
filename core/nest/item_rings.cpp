// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/item_rings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <polyclipping/clipper.hpp>

namespace toile {
namespace {

constexpr const char* kNoOutline = translatable("its outline is no polygon");
constexpr const char* kWoundTwice =
    translatable("its outline goes round twice, or a hole lies outside it or on another");
constexpr const char* kNoArea = translatable("its outline has no area");
constexpr const char* kNoCopies = translatable("its copies or angles are no usable numbers");

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

}  // namespace toile::nest
