// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <Eigen/LU>

#include "core/flatten/isometric/coarsening.h"
#include "core/geometry/segment.h"

namespace toile::isometric {
namespace {

/// A point well inside the kernel of a ring: the centre of the polygon clipped by all its edges.
std::optional<Eigen::RowVector2d> kernelPoint(const Points2& Q, const int* ring, int count) {
    std::vector<Eigen::RowVector2d> polygon;
    polygon.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
        polygon.emplace_back(Q.row(ring[k]));
    }
    for (int k = 0; k < count; ++k) {
        const Eigen::RowVector2d from = Q.row(ring[k]);
        const Eigen::RowVector2d edge = Q.row(ring[(k + 1) % count]) - from;
        std::vector<Eigen::RowVector2d> cut;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Eigen::RowVector2d& p = polygon[i];
            const Eigen::RowVector2d& q = polygon[(i + 1) % polygon.size()];
            const double atP = geometry::cross(edge, p - from);
            const double atQ = geometry::cross(edge, q - from);
            if (atP >= 0) {
                cut.push_back(p);
            }
            if ((atP < 0) != (atQ < 0)) {
                cut.emplace_back(p + atP / (atP - atQ) * (q - p));
            }
        }
        polygon = std::move(cut);
    }
    if (polygon.size() < 3) {
        return std::nullopt;
    }
    Eigen::RowVector2d middle = Eigen::RowVector2d::Zero();
    for (const Eigen::RowVector2d& p : polygon) {
        middle += p / static_cast<double>(polygon.size());
    }
    return middle;
}

/// True if the triangles from a vertex to its ring are all anti-clockwise.
bool sees(const Points2& Q, int v, const int* ring, int count) {
    for (int k = 0; k < count; ++k) {
        if (!(geometry::cross(Q.row(ring[k]) - Q.row(v), Q.row(ring[(k + 1) % count]) - Q.row(v)) >
              0)) {
            return false;
        }
    }
    return true;
}

}  // namespace

Points2 Coarsening::restricted(const Points2& fine) const {
    Points2 Q(static_cast<Eigen::Index>(kept_.size()), 2);
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        Q.row(static_cast<Eigen::Index>(k)) = fine.row(kept_[k]);
    }
    return Q;
}

Points2 Coarsening::prolongedMotion(const Points2& coarse) const {
    Points2 P = Points2::Zero(fineCount_, 2);
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        P.row(kept_[k]) = coarse.row(static_cast<Eigen::Index>(k));
    }
    for (auto removal = removals_.rbegin(); removal != removals_.rend(); ++removal) {
        for (int k = removal->first; k < removal->last; ++k) {
            P.row(removal->vertex) += share_[k] * P.row(ring_[k]);
        }
    }
    return P;
}

Points2 Coarsening::restrictedForces(Points2 fine) const {
    for (const Removal& removal : removals_) {
        for (int k = removal.first; k < removal.last; ++k) {
            fine.row(ring_[k]) += share_[k] * fine.row(removal.vertex);
        }
    }
    return restricted(fine);
}

/// @param place  gives the position of a removed vertex from the flattening so far
template <class Place>
std::optional<Points2> Coarsening::laidBack(const Points2& coarse, Place place) const {
    Points2 Q = Points2::Zero(fineCount_, 2);
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        Q.row(kept_[k]) = coarse.row(static_cast<Eigen::Index>(k));
    }
    for (auto removal = removals_.rbegin(); removal != removals_.rend(); ++removal) {
        const int* ring = &ring_[removal->first];
        const int count = removal->last - removal->first;
        Q.row(removal->vertex) = place(Q, *removal);
        if (!sees(Q, removal->vertex, ring, count)) {
            const auto point = kernelPoint(Q, ring, count);
            Q.row(removal->vertex) = point.value_or(Q.row(removal->vertex));
            if (!sees(Q, removal->vertex, ring, count)) {
                return std::nullopt;
            }
        }
    }
    return Q;
}

std::optional<Points2> Coarsening::followed(const Points2& before, const Points2& coarse) const {
    return laidBack(coarse, [&](const Points2& Q, const Removal& removal) -> Eigen::RowVector2d {
        const int* ring = &ring_[removal.first];
        const int count = removal.last - removal.first;
        Eigen::RowVector2d from = Eigen::RowVector2d::Zero();
        Eigen::RowVector2d to = Eigen::RowVector2d::Zero();
        for (int k = 0; k < count; ++k) {
            from += before.row(ring[k]) / count;
            to += Q.row(ring[k]) / count;
        }
        Eigen::Matrix2d D = Eigen::Matrix2d::Zero();
        Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
        for (int k = 0; k < count; ++k) {
            const Eigen::RowVector2d d0 = before.row(ring[k]) - from;
            const Eigen::RowVector2d d1 = Q.row(ring[k]) - to;
            D += d0.transpose() * d0;
            S += d0.transpose() * d1;
        }
        return to + (before.row(removal.vertex) - from) * (D.inverse() * S);
    });
}

std::optional<Points2> Coarsening::prolonged(const Points2& coarse) const {
    return laidBack(coarse, [&](const Points2& Q, const Removal& removal) {
        Eigen::RowVector2d place = Eigen::RowVector2d::Zero();
        for (int k = removal.first; k < removal.last; ++k) {
            place += share_[k] * Q.row(ring_[k]);
        }
        return place;
    });
}

}  // namespace toile::isometric
