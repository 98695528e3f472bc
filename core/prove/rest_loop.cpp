// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/pattern/corners.h"
#include "core/prove/rest_pattern.h"

namespace toile::prove {

RestLoop::RestLoop(Points3 space, ClosedLine drawn, ClosedLine rest, LineMap map)
    : space_(std::move(space)),
      arc_{0},
      drawn_(std::move(drawn)),
      along_(drawn_.points()),
      rest_(std::move(rest)),
      map_(std::move(map)) {
    for (Eigen::Index k = 0; k < space_.rows(); ++k) {
        arc_.push_back(arc_.back() + (space_.row((k + 1) % space_.rows()) - space_.row(k)).norm());
    }
    for (const int k : findCorners(drawn_.points())) {
        corners_.push_back(withinTurn(drawn_.arc()[k]));
    }
}

// A line that was drawn as the image of another need not begin where the outline does.
double RestLoop::withinTurn(double place) const {
    return place - std::floor(place / arc_.back()) * arc_.back();
}

Eigen::RowVector3d RestLoop::spaceAt(double place) const {
    const double within = withinTurn(place);
    const auto after = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, within);
    const Eigen::Index k = after - arc_.begin();
    const double edge = arc_[k] - arc_[k - 1];
    const double t = edge > 0 ? std::clamp((within - arc_[k - 1]) / edge, 0.0, 1.0) : 0;
    return (1 - t) * space_.row(k - 1) + t * space_.row(k % space_.rows());
}

}  // namespace toile::prove
