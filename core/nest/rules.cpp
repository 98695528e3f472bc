// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/rules.h"

#include <algorithm>
#include <cmath>

namespace toile::nest {
namespace {

constexpr double kOffTrack = 1e-6;  // mm: closer counts as on the track

bool isWithin(double at, double least, double most, double from, double to) {
    return at + least >= from && at + most <= to;
}

/// Any position between the walls.
bool clampBetween(double least, double most, double from, double to, double& at) {
    if (!(most - least <= to - from)) {
        return false;
    }
    at = std::clamp(at, from - least, std::max(from - least, to - most));
    while (at + least < from) {
        at = std::nextafter(at, HUGE_VAL);
    }
    while (at + most > to) {
        at = std::nextafter(at, -HUGE_VAL);
    }
    return true;
}

double nearestOn(const Track& track, double at) {
    return std::isinf(track.step)
               ? track.offset
               : track.offset + std::round((at - track.offset) / track.step) * track.step;
}

bool isOn(const Track& track, double at) {
    return track.step == 0 || std::abs(nearestOn(track, at) - at) <= kOffTrack;
}

}  // namespace

Tracks tracksOf(const Item& item, const Pose& pose) {
    Tracks tracks;
    const Variant& variant = item.variants[static_cast<std::size_t>(pose.variant)];
    if (item.lattice) {
        const NestLattice& lattice = *item.lattice;
        const Eigen::Vector2d way = wayOf(variant.angle + pose.turn);
        const double x = variant.mirrored ? -lattice.anchor.x() : lattice.anchor.x();
        const double y = lattice.anchor.y();
        tracks.x = {lattice.phase.x() - (way.x() * x - way.y() * y), lattice.step.x()};
        tracks.y = {lattice.phase.y() - (way.y() * x + way.x() * y), lattice.step.y()};
    }
    if (item.touchesEdge) {
        tracks.y = {variant.rest, HUGE_VAL};
    }
    return tracks;
}

bool moveBetween(const Track& track, double least, double most, double from, double to,
                 double& at) {
    if (track.step == 0) {
        return clampBetween(least, most, from, to, at);
    }
    double best = HUGE_VAL;
    if (std::isinf(track.step)) {
        best = track.offset;
    } else {
        double clamped = at;
        if (!clampBetween(least - kOffTrack, most + kOffTrack, from - 2 * kOffTrack,
                          to + 2 * kOffTrack, clamped)) {
            return false;
        }
        const double middle = nearestOn(track, clamped);
        for (const double tried : {middle, middle - track.step, middle + track.step}) {
            if (std::abs(tried - at) < std::abs(best - at) &&
                isWithin(tried, least, most, from - kOffTrack / 2, to + kOffTrack / 2)) {
                best = tried;
            }
        }
    }
    // Move places back that rounding put beyond a wall.
    double inside = best;
    if (!std::isfinite(best) || !clampBetween(least, most, from, to, inside) ||
        !(std::abs(inside - best) <= kOffTrack / 2)) {
        return false;
    }
    at = inside;
    return true;
}

bool moveInside(const Problem& problem, const Item& item, const Shape& shape, double length,
                Pose& pose) {
    const Box& box = shape.box;
    const Tracks tracks = tracksOf(item, pose);
    const double low = item.touchesEdge ? -HUGE_VAL : problem.low;
    if (!moveBetween(tracks.y, box.bottom, box.top, low, problem.high, pose.y)) {
        return false;
    }
    if (problem.stretches.size() == 1) {
        const Stretch& all = problem.stretches.front();
        return moveBetween(tracks.x, box.left, box.right, all.from, std::min(all.to, length),
                           pose.x);
    }
    const double middle = pose.x + (box.left + box.right) / 2;
    double best = HUGE_VAL;
    const auto look = [&](const Stretch& stretch) {
        double x = pose.x;
        const bool fits = moveBetween(tracks.x, box.left, box.right, stretch.from,
                                      std::min(stretch.to, length), x);
        best = fits && std::abs(x - pose.x) < std::abs(best - pose.x) ? x : best;
        return fits;
    };
    const auto after = std::ranges::upper_bound(problem.stretches, middle, {}, &Stretch::from);
    for (auto stretch = after; stretch != problem.stretches.begin() && !look(*--stretch);) {
    }
    for (auto stretch = after;
         stretch != problem.stretches.end() && stretch->from < length && !look(*stretch);
         ++stretch) {
    }
    pose.x = std::isfinite(best) ? best : pose.x;
    return std::isfinite(best);
}

double nextAlong(const Problem& problem, const Track& track, const Shape& shape, double x) {
    const Box& box = shape.box;
    auto next = std::ranges::lower_bound(problem.stretches, x + box.right, {}, &Stretch::to);
    for (; next != problem.stretches.end(); ++next) {
        const Stretch& stretch = *next;
        double at = std::max(x, stretch.from - box.left);
        if (track.step != 0) {
            at = std::isinf(track.step)
                     ? track.offset
                     : track.offset +
                           std::ceil((at - kOffTrack / 2 - track.offset) / track.step) * track.step;
            if (!(at >= x - kOffTrack)) {
                return HUGE_VAL;
            }
        }
        if (moveBetween(track, box.left, box.right, stretch.from, stretch.to, at) &&
            at >= x - kOffTrack) {
            return at;
        }
    }
    return HUGE_VAL;
}

bool keepsRules(const Problem& problem, const Item& item, const Pose& pose,
                const geometry::Polygon& grown, double length) {
    const double left = grown.col(0).minCoeff(), right = grown.col(0).maxCoeff();
    const double bottom = grown.col(1).minCoeff(), top = grown.col(1).maxCoeff();
    if (!(right <= length && top <= problem.high) ||
        std::ranges::none_of(problem.stretches, [&](const Stretch& stretch) {
            return left >= stretch.from && right <= stretch.to;
        })) {
        return false;
    }
    const double rest = item.variants[static_cast<std::size_t>(pose.variant)].rest;
    if (item.isFixed) {
        return item.touchesEdge ? pose.y >= rest : bottom >= problem.low;
    }
    const Tracks tracks = tracksOf(item, pose);
    return isOn(tracks.x, pose.x) &&
           (item.touchesEdge ? pose.y == rest : bottom >= problem.low && isOn(tracks.y, pose.y));
}

}  // namespace toile::nest
