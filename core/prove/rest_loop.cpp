// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/pattern/corners.h"
#include "core/prove/rest_pattern.h"

namespace toile::prove {

RestLoop::RestLoop(Points3 space, geometry::Line drawn, geometry::Line rest, LineMap map)
    : space_(geometry::SpaceLine::closed(std::move(space))),
      drawn_(std::move(drawn)),
      along_(geometry::Line::closed(drawn_.points())),
      rest_(std::move(rest)),
      map_(std::move(map)) {
    for (const int k : findCorners(drawn_.points())) {
        // A line drawn as the image of another may begin elsewhere than the outline.
        corners_.push_back(space_.wrap(drawn_.arc()[k]));
    }
}

}  // namespace toile::prove
