// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/face_spans.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"

namespace toile {
namespace {

/// A weight this little below zero is still in the triangle, and shares this near are equal.
constexpr double kOutside = 1e-9, kSameShare = 1e-9;

}  // namespace

SurfacePoint FaceSpan::at(double share) const {
    const Eigen::Vector3d weights = ((1 - share) * start + share * end).cwiseMax(0.0);
    return {face, weights / weights.sum()};
}

std::optional<FaceSpan> spanIn(int face, const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
    FaceSpan span{face, 0, 1, start, end};
    for (int k = 0; k < 3; ++k) {
        const double before = start[k] + kOutside, after = end[k] + kOutside;
        if (before < 0 && after < 0) {
            return std::nullopt;
        }
        if (before < 0) {
            span.from = std::max(span.from, before / (before - after));
        } else if (after < 0) {
            span.to = std::min(span.to, before / (before - after));
        }
    }
    // The comparison is also false for NaN.
    return span.to - span.from > kSameShare ? std::optional(span) : std::nullopt;
}

std::vector<FaceSpan> flatSpans(const Points2& Q, const Triangles& F, const Eigen::RowVector2d& a,
                                const Eigen::RowVector2d& b) {
    const Eigen::RowVector2d low = a.cwiseMin(b), high = a.cwiseMax(b);
    std::vector<FaceSpan> spans;
    for (int f = 0; f < F.rows(); ++f) {
        const Eigen::RowVector2d p = Q.row(F(f, 0)), q = Q.row(F(f, 1)), r = Q.row(F(f, 2));
        if ((p.cwiseMin(q).cwiseMin(r).array() > high.array()).any() ||
            (p.cwiseMax(q).cwiseMax(r).array() < low.array()).any()) {
            continue;
        }
        const double area = geometry::cross(q - p, r - p);
        const auto weights = [&](const Eigen::RowVector2d& x) -> Eigen::Vector3d {
            return Eigen::Vector3d(geometry::cross(q - x, r - x), geometry::cross(r - x, p - x),
                                   geometry::cross(p - x, q - x)) /
                   area;
        };
        if (area != 0) {
            if (const auto span = spanIn(f, weights(a), weights(b))) {
                spans.push_back(*span);
            }
        }
    }
    return spans;
}

std::optional<Eigen::Vector3d> weightsIn(const MeshArrays& mesh, int face,
                                         const Eigen::Vector3d& point, double reach) {
    const Eigen::Vector3d p = mesh.V.row(mesh.F(face, 0)), q = mesh.V.row(mesh.F(face, 1)),
                          r = mesh.V.row(mesh.F(face, 2));
    const Eigen::Vector3d normal = (q - p).cross(r - p);
    const double square = normal.squaredNorm();
    if (!(square > 0) || std::abs(normal.dot(point - p)) > reach * std::sqrt(square)) {
        return std::nullopt;
    }
    const double ofQ = normal.dot((r - p).cross(p - point)) / square;
    const double ofR = normal.dot((q - p).cross(point - p)) / square;
    return Eigen::Vector3d(1 - ofQ - ofR, ofQ, ofR);
}

bool isOnePlace(const Triangles& F, const SurfacePoint& a, const SurfacePoint& b) {
    if (a.face == b.face) {
        return (a.barycentric - b.barycentric).cwiseAbs().maxCoeff() < kSameWeight;
    }
    double shared = 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            if (F(a.face, i) == F(b.face, k)) {
                if (std::abs(a.barycentric[i] - b.barycentric[k]) > kSameWeight) {
                    return false;
                }
                shared += a.barycentric[i];
            }
        }
    }
    return shared > 1 - 2 * kSameWeight;
}

std::optional<std::vector<SurfacePoint>> straightWay(const Points2& Q, const Triangles& F,
                                                     const SurfacePoint& a, const SurfacePoint& b) {
    const std::vector<FaceSpan> spans =
        flatSpans(Q, F, flatPositionOf(Q, F, a), flatPositionOf(Q, F, b));
    std::vector<SurfacePoint> way{a};
    double at = 0;
    while (at < 1 - kSameShare) {
        const FaceSpan* next = nullptr;
        for (const FaceSpan& span : spans) {
            const bool goesOn = span.from <= at + kSameShare && span.to > at + kSameShare;
            if (goesOn && (!next || span.to > next->to) && isOnePlace(F, way.back(), span.at(at))) {
                next = &span;
            }
        }
        if (!next) {
            return std::nullopt;
        }
        at = next->to;
        way.push_back(next->at(at));
    }
    if (!isOnePlace(F, way.back(), b)) {
        return std::nullopt;
    }
    way.back() = b;
    return way;
}

}  // namespace toile
