// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/mirrored_pair.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "core/cut/surface_point.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/geometry/buckets.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/symmetry/mirror_plane.h"

namespace toile {
namespace {

using symmetry::GarmentSurface;

constexpr int kSamplesOfPieces = 20000;

/// The sampled vertices of each piece.
geometry::Buckets<> samplesByPiece(const GarmentSurface& surface, int pieceCount) {
    const std::vector<int> vertices = surface.sampled(kSamplesOfPieces);
    return {pieceCount, [&](const auto& add) {
                for (const int v : vertices) {
                    add(surface.pieceOfVertex[v], v);
                }
            }};
}

/// Per piece: where most of its area lies once reflected, the least index of ties; -1 without area.
std::vector<int> majorities(const GarmentSurface& surface, const geometry::Buckets<>& samples,
                            const MirrorPlane& plane, const Progress& progress) {
    const NearestSurface nearest(surface.mesh);
    std::vector<int> most(static_cast<std::size_t>(samples.keyCount()), -1);
    for (int p = 0; p < samples.keyCount(); ++p) {
        std::map<int, double> areas;
        for (const int v : samples[p]) {
            if (progress.isCancelled()) {
                return most;
            }
            const Eigen::Vector3d image = plane.reflected(surface.mesh.V.row(v));
            areas[surface.pieceOfFace[nearest.find(image).face]] += surface.area[v];
        }
        double largest = 0;
        for (const auto& [piece, area] : areas) {
            if (area > largest) {
                largest = area;
                most[p] = piece;
            }
        }
    }
    return most;
}

/// Sums over the reflected samples of a piece: squared distance to another piece, and weight.
Eigen::Vector2d distancesTo(const NearestSurface& nearest, const MeshArrays& there,
                            std::span<const int> samples, const GarmentSurface& surface,
                            const MirrorPlane& plane) {
    Eigen::Vector2d sums(0, 0);
    for (const int v : samples) {
        const Eigen::Vector3d image = plane.reflected(surface.mesh.V.row(v));
        const Eigen::Vector3d point = positionOf(there, nearest.find(image));
        sums += surface.area[v] * Eigen::Vector2d((point - image).squaredNorm(), 1);
    }
    return sums;
}

}  // namespace

MirrorPieces pairPieces(const Garment& garment, const MirrorPlane& plane,
                        const Progress& progress) {
    const auto count = static_cast<int>(garment.pieces.size());
    MirrorPieces none{std::vector<int>(garment.pieces.size(), -1),
                      std::vector<double>(garment.pieces.size(), 0)};
    const GarmentSurface surface = symmetry::surfaceOf(garment.pieces);
    if (surface.mesh.F.rows() == 0) {
        return none;
    }
    MirrorPieces pairs = none;
    const geometry::Buckets<> samples = samplesByPiece(surface, count);
    const std::vector<int> most = majorities(surface, samples, plane, progress);
    std::vector<Eigen::Vector2d> sums(garment.pieces.size(), Eigen::Vector2d::Zero());
    for (int p = 0; p < count; ++p) {
        if (progress.isCancelled()) {
            return none;
        }
        const int q = most[p];
        if (q < 0 || most[q] != p) {
            continue;
        }
        pairs.counterpart[p] = q;
        const MeshArrays& there = garment.pieces[q]->mesh;
        sums[p] = distancesTo(NearestSurface(there), there, samples[p], surface, plane);
    }
    for (int p = 0; p < count; ++p) {
        if (const int q = pairs.counterpart[p]; q >= 0) {
            const Eigen::Vector2d both = sums[std::min(p, q)] + sums[std::max(p, q)];
            pairs.deviation[p] = std::sqrt(both.x() / both.y());
        }
    }
    return pairs;
}

namespace {

/// Corners closer than this share of a segment are merged.
constexpr double kSameCorner = 1e-9;

/// The segments of a line, in the direction of the walk.
class Segments {
public:
    /// @param ends  in the order of the walk  @param sense  1 along the line, -1 backwards
    Segments(const geometry::Line& line, const std::vector<double>& ends, int sense)
        : line_(line), first_(ends.front()), sense_(sense) {
        for (const double end : ends) {
            begins_.push_back(walked(end));
        }
        begins_.push_back(line.length());
    }

    double length(std::size_t segment) const { return begins_[segment + 1] - begins_[segment]; }

    /// The place of a corner: the number of its segment plus the share of it before the corner.
    double placeOf(Eigen::Index corner) const {
        const double way = walked(line_.arc()[static_cast<int>(corner)]);
        const auto next = std::upper_bound(begins_.begin() + 1, begins_.end() - 1, way);
        const auto segment = static_cast<std::size_t>(next - begins_.begin()) - 1;
        return static_cast<double>(segment) + (way - begins_[segment]) / length(segment);
    }

private:
    double walked(double place) const { return line_.wrap(sense_ * (place - first_)); }

    const geometry::Line& line_;
    double first_;
    int sense_;
    std::vector<double> begins_;  ///< of each segment, along the walk; the perimeter at the end
};

/// A corner of one of two lines, or an end of a segment, by its place along both.
struct Mark {
    double place;
    int line = -1;  ///< 0 or 1; -1: an end
    int corner = -1;
};

std::vector<Mark> sortedMarks(const Segments& a, const Segments& b, Eigen::Index cornersOfA,
                              Eigen::Index cornersOfB, int segmentCount) {
    std::vector<Mark> marks;
    const auto add = [&](const Segments& segments, int line, Eigen::Index corners) {
        for (Eigen::Index k = 0; k < corners; ++k) {
            const double place = segments.placeOf(k);
            const bool isAtStart = place > segmentCount - kSameCorner;
            marks.push_back({isAtStart ? 0 : place, line, static_cast<int>(k)});
        }
    };
    for (int k = 0; k < segmentCount; ++k) {
        marks.push_back({static_cast<double>(k)});
    }
    add(a, 0, cornersOfA);
    add(b, 1, cornersOfB);
    std::ranges::stable_sort(marks, {}, &Mark::place);
    return marks;
}

/// Both lines with the corners of both.
struct CommonCorners {
    std::vector<double> place;
    std::vector<double> turn;  ///< mean of both lines, radians
    std::vector<int> rowOf[2];
};

CommonCorners commonCorners(const std::vector<Mark>& marks, const geometry::Line& a,
                            const geometry::Line& b) {
    CommonCorners common;
    common.rowOf[0].resize(static_cast<std::size_t>(a.count()));
    common.rowOf[1].resize(static_cast<std::size_t>(b.count()));
    double before = -1;
    for (const Mark& mark : marks) {
        if (mark.place - before > kSameCorner) {
            common.place.push_back(mark.place);
            common.turn.push_back(0);
        }
        before = mark.place;
        if (mark.line < 0) {
            common.place.back() = mark.place;  // exactly
            continue;
        }
        common.turn.back() += 0.5 * (mark.line == 0 ? a : b).turnAt(mark.corner);
        common.rowOf[mark.line][mark.corner] = static_cast<int>(common.place.size()) - 1;
    }
    return common;
}

BoundaryProblem problemOf(const CommonCorners& common, const Segments& a, const Segments& b,
                          int segmentCount) {
    const auto count = static_cast<Eigen::Index>(common.place.size());
    BoundaryProblem problem{Eigen::VectorXd(count), Eigen::VectorXd(count)};
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const double here = common.place[at];
        const double next = k + 1 < count ? common.place[at + 1] : segmentCount;
        const auto segment = static_cast<std::size_t>(here);
        problem.lengths[k] = (next - here) * 0.5 * (a.length(segment) + b.length(segment));
        problem.angles[k] = std::numbers::pi - common.turn[at];
    }
    return problem;
}

/// Corner k becomes corner #m - k, modulo #m.
Points2 reflectedRows(const Points2& line) {
    const Eigen::Index m = line.rows();
    Points2 image(m, 2);
    for (Eigen::Index k = 0; k < m; ++k) {
        image.row(k) << -line((m - k) % m, 0), line((m - k) % m, 1);
    }
    return image;
}

/// Moves row 0 to the origin and turns the line until row `above` is above it.
Points2 upright(const Points2& line, int above) {
    const Eigen::RowVector2d up = (line.row(above) - line.row(0)).normalized();
    const Eigen::RowVector2d across(up.y(), -up.x());
    const Points2 moved = line.rowwise() - line.row(0);
    Points2 turned(line.rows(), 2);
    turned << moved * across.transpose(), moved * up.transpose();
    return turned;
}

}  // namespace

Points2 mirroredLine(const Points2& line, double start) {
    const auto n = static_cast<int>(line.rows());
    const auto [edge, share] = geometry::Line::closed(line).arc().edgePlace(start);
    const bool isCorner = share <= kSameCorner, isNext = share >= 1 - kSameCorner;
    const int first = isNext ? edge + 1 : edge;  // the corner before the start, or at it
    const bool isWithin = !isCorner && !isNext;
    Points2 from(n + (isWithin ? 1 : 0), 2);
    if (isWithin) {
        from.row(0) = (1 - share) * line.row(edge) + share * line.row((edge + 1) % n);
    }
    for (int k = 0; k < n; ++k) {
        from.row(k + (isWithin ? 1 : 0)) = line.row((first + k + (isWithin ? 1 : 0)) % n);
    }
    return reflectedRows(from);
}

Result<MirroredPair> meanLine(const Points2& a, const Points2& b,
                              const std::vector<MirrorEnd>& ends) {
    const auto lineA = geometry::Line::closed(a), lineB = geometry::Line::closed(b);
    std::vector<double> endsOfA, endsOfB;
    for (const MirrorEnd& end : ends) {
        endsOfA.push_back(end.a);
        endsOfB.push_back(end.b);
    }
    const Segments along(lineA, endsOfA, 1), back(lineB, endsOfB, -1);
    const auto segmentCount = static_cast<int>(ends.size());
    const CommonCorners common =
        commonCorners(sortedMarks(along, back, a.rows(), b.rows(), segmentCount), lineA, lineB);
    const auto solved = solveBoundary(problemOf(common, along, back, segmentCount),
                                      BoundarySolver::Newton, Progress());
    if (!solved) {
        return solved.error();
    }
    MirroredPair pair{solved->points, reflectedRows(solved->points), common.rowOf[0],
                      common.rowOf[1]};
    const auto rows = static_cast<int>(common.place.size());
    for (int& row : pair.rowOfB) {
        row = (rows - row) % rows;
    }
    return pair;
}

Result<SymmetricLine> symmetricLine(const Points2& line, double from, double to) {
    const auto mean = meanLine(line, line, {{from, from}, {to, to}});
    if (!mean) {
        return mean.error();
    }
    const auto half = static_cast<int>(mean->a.rows() / 2);
    const Points2 found = upright(mean->a, half);
    // The minimum is symmetric; the rest is the solver's rounding.
    return SymmetricLine{0.5 * (found + reflectedRows(found)), mean->rowOfA};
}

}  // namespace toile
