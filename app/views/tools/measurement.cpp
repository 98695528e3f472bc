// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/measurement.h"

#include <algorithm>
#include <cmath>

namespace toile::app {

namespace {

/// A weight below this puts a place on the opposite edge.
constexpr double kZero = 1e-9;

Eigen::RowVector2d flatPoint(const Piece& piece, const Points2& Q, const SurfacePoint& at) {
    Eigen::RowVector2d point = Eigen::RowVector2d::Zero();
    for (int k = 0; k < 3; ++k) {
        point += at.barycentric[k] * Q.row(piece.mesh.F(at.face, k));
    }
    return point;
}

/// A place on a loop: after vertex `index` by `part` of the edge that leaves it.
struct OnLoop {
    std::size_t index;
    double part;
};

double weightOf(const Piece& piece, const SurfacePoint& at, int vertex) {
    for (int k = 0; k < 3; ++k) {
        if (piece.mesh.F(at.face, k) == vertex) {
            return at.barycentric[k];
        }
    }
    return 0;
}

std::optional<OnLoop> placeOn(const std::vector<int>& loop, const Piece& piece,
                              const SurfacePoint& at) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const double here = weightOf(piece, at, loop[i]);
        const double next = weightOf(piece, at, loop[(i + 1) % loop.size()]);
        if (here > kZero && here + next > 1 - kZero) {
            return OnLoop{i, next};
        }
    }
    return std::nullopt;
}

template <class Points>
double lengthUpTo(const std::vector<int>& loop, const Points& P, const OnLoop& at) {
    double sum = 0;
    for (std::size_t i = 0; i <= at.index; ++i) {
        const double edge = (P.row(loop[(i + 1) % loop.size()]) - P.row(loop[i])).norm();
        sum += i < at.index ? edge : at.part * edge;
    }
    return sum;
}

template <class Points>
double perimeter(const std::vector<int>& loop, const Points& P) {
    return lengthUpTo(loop, P, {loop.size() - 1, 1});
}

std::optional<MeasuredLength> along(const std::vector<int>& loop, const Piece& piece,
                                    const Points2* Q, const SurfacePoint& from,
                                    const SurfacePoint& to) {
    const auto a = placeOn(loop, piece, from), b = placeOn(loop, piece, to);
    if (!a || !b) {
        return std::nullopt;
    }
    const auto between = [&](const auto& P) {
        return std::abs(lengthUpTo(loop, P, *b) - lengthUpTo(loop, P, *a));
    };
    const double direct = between(piece.mesh.V), all = perimeter(loop, piece.mesh.V);
    const bool goesRound = direct > all - direct;
    MeasuredLength length{goesRound ? all - direct : direct};
    if (Q) {
        length.flat = goesRound ? perimeter(loop, *Q) - between(*Q) : between(*Q);
    }
    return length;
}

}  // namespace

double flatDistance(const Piece& piece, const Points2& Q, const SurfacePoint& from,
                    const SurfacePoint& to) {
    return (flatPoint(piece, Q, to) - flatPoint(piece, Q, from)).norm();
}

std::optional<MeasuredLength> alongOutline(const Piece& piece, const Points2* Q,
                                           const SurfacePoint& from, const SurfacePoint& to) {
    if (!piece.boundary.empty()) {
        if (const auto length = along(piece.boundary, piece, Q, from, to)) {
            return length;
        }
    }
    for (const auto& hole : piece.holes) {
        if (const auto length = along(hole, piece, Q, from, to)) {
            return length;
        }
    }
    return std::nullopt;
}

}  // namespace toile::app
