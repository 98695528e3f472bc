// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/sew/side_by_side.h"

namespace toile::sew {
namespace {

/// A signed distance changes by at most this times the way, and this much, mm.
constexpr double kLeap = 1 + 1e-6;
constexpr double kSame = 1e-9;

}  // namespace

Contact::Contact(const WornSurface& surface, Eigen::VectorXd areas, const ContactForces& forces,
                 int threads)
    : surface_(surface), areas_(std::move(areas)), threads_(threads) {
    set(forces);
}

void Contact::set(const ContactForces& forces) {
    forces_ = forces;
    reach_ = 2 * (std::abs(forces.pressure) + forces.load) / forces.stiffness;
}

double Contact::slopeAt(double distance) const {
    return forces_.pressure + forces_.stiffness * std::min(distance - reach_, 0.0);
}

std::vector<WornSurface::Place> Contact::placesOf(const Points3& X) const {
    std::vector<WornSurface::Place> places(static_cast<std::size_t>(X.rows()));
    sideBySide(threads_, places.size(), [&](std::size_t v) {
        places[v] = surface_.placeOf(X.row(static_cast<Eigen::Index>(v)).transpose());
    });
    return places;
}

std::vector<WornSurface::Place> Contact::placesOf(
    const Points3& X, const Points3& before, const std::vector<WornSurface::Place>& places) const {
    std::vector<WornSurface::Place> now(places.size());
    sideBySide(threads_, places.size(), [&](std::size_t v) {
        const auto row = static_cast<Eigen::Index>(v);
        const WornSurface::Place& old = places[v];
        const Eigen::Vector3d step = (X.row(row) - before.row(row)).transpose();
        now[v] = surface_.placeOf(X.row(row).transpose(), old.face);
        if (std::abs(now[v].distance - old.distance) > kLeap * step.norm() + kSame) {
            now[v] = {old.distance + old.away.dot(step), old.away, Eigen::Matrix3d::Zero(),
                      old.face};
        }
    });
    return now;
}

double Contact::energy(const std::vector<WornSurface::Place>& places) const {
    double sum = 0;
    for (std::size_t v = 0; v < places.size(); ++v) {
        const double d = places[v].distance, inside = std::min(d - reach_, 0.0);
        sum += areas_[static_cast<Eigen::Index>(v)] *
               (forces_.pressure * d + forces_.stiffness * inside * inside / 2);
    }
    return sum;
}

void Contact::addGradient(const std::vector<WornSurface::Place>& places, Points3& g) const {
    for (std::size_t v = 0; v < places.size(); ++v) {
        const auto row = static_cast<Eigen::Index>(v);
        const double slope = slopeAt(places[v].distance);
        g.row(row) += areas_[row] * slope * places[v].away.transpose();
    }
}

void Contact::addHessian(const std::vector<WornSurface::Place>& places, double caution,
                         SpaceMatrix& H) const {
    const double pull = std::max(forces_.pressure, 0.0);
    for (std::size_t v = 0; v < places.size(); ++v) {
        const double d = places[v].distance, slope = slopeAt(d);
        double stiffness = forces_.stiffness;
        if (d >= reach_) {
            stiffness = pull > 0 ? caution * pull / (d - pull / forces_.stiffness) : 0;
        }
        Eigen::Matrix3d block = stiffness * places[v].away * places[v].away.transpose();
        if (slope * d > 0) {
            block += slope * places[v].bend;
        }
        const int row = static_cast<int>(v);
        H.add(row, row, areas_[row] * block);
    }
}

}  // namespace toile::sew
