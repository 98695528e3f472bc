// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CGAL and is slow to compile.
#include "core/prove/fresh_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <numbers>
#include <utility>

#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"
#include "core/geometry/segment_pairs.h"

// Header-only exact arithmetic: no library to link.
#undef CGAL_USE_GMP
#undef CGAL_USE_MPFR
#undef CGAL_USE_GMPXX
#ifndef CGAL_DISABLE_GMP
#define CGAL_DISABLE_GMP 1
#endif
#ifndef CGAL_NDEBUG
#define CGAL_NDEBUG
#endif
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace toile::prove {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<
                CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>,
                CGAL::Triangulation_face_base_with_info_2<
                    int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>>>;

/// Smallest distance of grid points, and of given points, from the outline, in edge lengths.
constexpr double kOffRim = 0.6, kGivenOffRim = 0.4;
constexpr int kRounds = 4;  ///< rounds of triangulation after points have moved
constexpr int kMoves = 3;   ///< moves of the points per round
/// Insets, in edge lengths, for triangulating outlines that touch themselves.
constexpr double kDrawnIn[] = {0, 1e-4, 1e-3, 1e-2};

Eigen::RowVector2d next(const Points2& loop, Eigen::Index k) {
    return loop.row((k + 1) % loop.rows());
}

/// Moves each point to the left of the line.
Points2 drawnIn(const Points2& loop, double by) {
    Points2 moved = loop;
    for (Eigen::Index k = 0; by > 0 && k < loop.rows(); ++k) {
        const Eigen::RowVector2d before = loop.row((k + loop.rows() - 1) % loop.rows());
        const Eigen::RowVector2d in = loop.row(k) - before, out = next(loop, k) - loop.row(k);
        const double half = geometry::turnBetween(in, out) / 2;
        // Along the bisector of the two directions, a quarter turn to the left.
        const double angle = std::atan2(in.y(), in.x()) + half + std::numbers::pi / 2;
        moved(k, 0) += by * std::cos(angle);
        moved(k, 1) += by * std::sin(angle);
    }
    return moved;
}

/// Whether two non-adjacent edges meet, or adjacent ones overlap.
bool touchesItself(const std::vector<Points2>& loops) {
    std::vector<geometry::Segment2> segments;
    std::vector<std::pair<int, int>> ends;  // point numbers
    int first = 0;
    for (const Points2& loop : loops) {
        const auto count = static_cast<int>(loop.rows());
        for (int k = 0; k < count; ++k) {
            segments.push_back({loop.row(k), next(loop, k)});
            ends.emplace_back(first + k, first + (k + 1) % count);
        }
        first += count;
    }
    bool touches = false;
    geometry::visitSegmentPairs(segments, 0, [&](int i, int j, const geometry::PlaneCell&) {
        const auto& [a, b] = segments[i];
        const auto& [c, d] = segments[j];
        const int sides[] = {
            geometry::exactOrientation(a, b, c), geometry::exactOrientation(a, b, d),
            geometry::exactOrientation(c, d, a), geometry::exactOrientation(c, d, b)};
        if (ends[i].second == ends[j].first || ends[i].first == ends[j].second) {
            const bool isAhead = ends[i].second == ends[j].first;
            const Eigen::RowVector2d in = isAhead ? b - a : d - c, out = isAhead ? d - c : b - a;
            touches = touches || (sides[0] == 0 && sides[1] == 0 && in.dot(out) < 0);
            return !touches;
        }
        if (sides[0] == 0 && sides[1] == 0) {  // collinear
            const Eigen::RowVector2d low = a.cwiseMin(b), high = a.cwiseMax(b);
            touches = touches || ((low.array() <= c.cwiseMax(d).array()).all() &&
                                  (c.cwiseMin(d).array() <= high.array()).all());
        } else {
            touches = touches || (sides[0] * sides[1] <= 0 && sides[2] * sides[3] <= 0);
        }
        return !touches;
    });
    return touches;
}

/// Points of a grid of equilateral triangles over the outline's box.
Points2 gridPoints(const Points2& outline, double edge) {
    const Eigen::RowVector2d low = outline.colwise().minCoeff();
    const Eigen::RowVector2d high = outline.colwise().maxCoeff();
    const double rise = edge * std::sqrt(3.0) / 2;
    std::vector<Eigen::RowVector2d> points;
    for (int row = 1; low.y() + row * rise < high.y(); ++row) {
        for (int k = 0; low.x() + k * edge < high.x(); ++k) {
            points.emplace_back(low.x() + (k + (row % 2 == 0 ? 1 : 0.5)) * edge,
                                low.y() + row * rise);
        }
    }
    Points2 grid(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        grid.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    return grid;
}

/// Numbers of the points inside the shape, away from its rims.
std::vector<int> pointsInside(const std::vector<Points2>& loops, const Points2& points,
                              double offRim) {
    const std::vector<geometry::NearestOnLine> nearest(loops.begin(), loops.end());
    std::vector<int> inside;
    for (int v = 0; v < static_cast<int>(points.rows()); ++v) {
        const Eigen::RowVector2d p = points.row(v);
        bool isIn = geometry::isInside(loops.front(), p.transpose());
        for (std::size_t k = 0; isIn && k < loops.size(); ++k) {
            isIn = (k == 0 || !geometry::isInside(loops[k], p.transpose())) &&
                   (nearest[k](p) - p).norm() >= offRim;
        }
        if (isIn) {
            inside.push_back(v);
        }
    }
    return inside;
}

/// Marks each triangle with the number of rims between it and the outside.
void markDepth(Delaunay& delaunay) {
    constexpr int kUnknown = -1;
    for (const auto face : delaunay.all_face_handles()) {
        face->info() = kUnknown;
    }
    std::vector<Delaunay::Face_handle> here{delaunay.infinite_face()}, beyond;
    for (int depth = 0; !here.empty(); ++depth, here = std::exchange(beyond, {})) {
        while (!here.empty()) {
            const auto face = here.back();
            here.pop_back();
            if (face->info() != kUnknown) {
                continue;
            }
            face->info() = depth;
            for (int k = 0; k < 3; ++k) {
                (face->is_constrained(k) ? beyond : here).push_back(face->neighbor(k));
            }
        }
    }
}

Triangles trianglesOf(const Points2& Q, const std::vector<Points2>& loops) {
    Delaunay delaunay;
    std::vector<Delaunay::Vertex_handle> vertices;
    Delaunay::Face_handle hint;
    for (int k = 0; k < static_cast<int>(Q.rows()); ++k) {
        vertices.push_back(delaunay.insert({Q(k, 0), Q(k, 1)}, hint));
        vertices.back()->info() = k;
        hint = vertices.back()->face();
    }
    std::size_t first = 0;
    for (const Points2& loop : loops) {
        const auto count = static_cast<std::size_t>(loop.rows());
        for (std::size_t k = 0; k < count; ++k) {
            delaunay.insert_constraint(vertices[first + k], vertices[first + (k + 1) % count]);
        }
        first += count;
    }
    markDepth(delaunay);
    std::vector<std::array<int, 3>> found;
    for (const auto face : delaunay.finite_face_handles()) {
        if (face->info() % 2 == 1) {
            std::array<int, 3> corners{face->vertex(0)->info(), face->vertex(1)->info(),
                                       face->vertex(2)->info()};
            std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
            found.push_back(corners);
        }
    }
    std::ranges::sort(found);
    Triangles F(static_cast<Eigen::Index>(found.size()), 3);
    for (std::size_t f = 0; f < found.size(); ++f) {
        F.row(static_cast<Eigen::Index>(f)) << found[f][0], found[f][1], found[f][2];
    }
    return F;
}

double doubleArea(const Points2& Q, const Triangles& F, int f) {
    return geometry::cross(Q.row(F(f, 1)) - Q.row(F(f, 0)), Q.row(F(f, 2)) - Q.row(F(f, 0)));
}

/// Moves inside points to the mean of their neighbours unless a triangle would flip.
void moveInside(Points2& Q, const Triangles& F, Eigen::Index firstInside) {
    std::vector<std::vector<int>> facesOf(static_cast<std::size_t>(Q.rows()));
    for (int side = 0; side < static_cast<int>(F.size()); ++side) {
        facesOf[F.data()[side]].push_back(side / 3);
    }
    for (Eigen::Index v = firstInside; v < Q.rows(); ++v) {
        const Eigen::RowVector2d before = Q.row(v);
        Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
        for (const int f : facesOf[v]) {
            sum += Q.row(F(f, 0)) + Q.row(F(f, 1)) + Q.row(F(f, 2)) - before;
        }
        const auto turnsOver = [&](int f) { return !(doubleArea(Q, F, f) > 0); };
        if (!facesOf[v].empty()) {
            Q.row(v) = sum / (2.0 * static_cast<double>(facesOf[v].size()));
            if (std::ranges::any_of(facesOf[v], turnsOver)) {
                Q.row(v) = before;
            }
        }
    }
}

}  // namespace

Result<FreshMesh> freshMesh(const std::vector<Points2>& loops, double edge, const Subject& subject,
                            const Points2* inside) {
    std::vector<Points2> lines;
    for (const double share : kDrawnIn) {
        lines.clear();
        for (const Points2& loop : loops) {
            lines.push_back(drawnIn(loop, share * edge));
        }
        if (!touchesItself(lines)) {
            break;
        }
        if (share == kDrawnIn[std::size(kDrawnIn) - 1]) {
            return Error{ErrorCode::OutlineCrosses, subject};
        }
    }
    Eigen::Index rim = 0;
    for (const Points2& loop : lines) {
        rim += loop.rows();
    }
    const Points2 points = inside != nullptr ? *inside : gridPoints(lines.front(), edge);
    const auto kept = pointsInside(lines, points, (inside ? kGivenOffRim : kOffRim) * edge);
    FreshMesh mesh{Points2(rim + static_cast<Eigen::Index>(kept.size()), 2), {}};
    Points2& Q = mesh.Q;
    Eigen::Index at = 0;
    for (const Points2& loop : lines) {
        Q.middleRows(at, loop.rows()) = loop;
        at += loop.rows();
    }
    Q.bottomRows(static_cast<Eigen::Index>(kept.size())) = points(kept, Eigen::all);
    try {
        mesh.F = trianglesOf(Q, lines);
        for (int round = 0; inside == nullptr && !kept.empty() && round < kRounds; ++round) {
            for (int k = 0; k < kMoves; ++k) {
                moveInside(Q, mesh.F, rim);
            }
            mesh.F = trianglesOf(Q, lines);
        }
    } catch (const std::exception&) {
        return Error{ErrorCode::OutlineCrosses, subject};
    }
    if (inside != nullptr) {
        mesh.insideOf = kept;
    }
    at = 0;
    for (const Points2& loop : loops) {
        Q.middleRows(at, loop.rows()) = loop;
        at += loop.rows();
    }
    return mesh;
}

}  // namespace toile::prove
