// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/descent_pace.h"

namespace toile {
namespace {

/// Steps shorter than this part were stopped by single triangles.
constexpr double kShortStep = 0.3;
/// A step with an old factorisation is tried if the one with the new went this far.
constexpr double kGoodStep = 0.4;
/// A fall between this part of the promise and its inverse: the promise was kept.
constexpr double kKeptShare = 0.5;
/// Hardly more than the tolerance, of a step and of all with one factorisation.
constexpr double kOfOne = 2;
constexpr double kOfAll = 10;

}  // namespace

void DescentPace::count(double part, double promised, double fall, double renewingCost) {
    part_ = part;
    fall_ = fall;
    if (fresh_) {
        fallen_ = fall;
        spent_ = renewingCost;
        went_ = part >= kShortStep;
        fresh_ = part < kGoodStep;
    } else {
        fallen_ += fall;
        spent_ += 1;
        went_ = went_ || part >= kShortStep;
        const bool kept = fall > kKeptShare * promised && fall < promised / kKeptShare;
        fresh_ = part < kShortStep || (fall < fallen_ / spent_ && !kept);
    }
}

bool DescentPace::hasArrived(double tolerance) const {
    return (!wasStopped() && fall_ <= kOfOne * tolerance) ||
           (fresh_ && went_ && fallen_ <= kOfAll * tolerance);
}

bool DescentPace::wasStopped() const {
    return part_ < kShortStep;
}

}  // namespace toile
