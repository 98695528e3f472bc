// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>

#include "core/cut/straighten.h"

namespace toile {
namespace {

constexpr int kMaxRounds = 32;
/// A slide has to gain this much, relatively, so that rounding does not move ends.
constexpr double kWorthwhile = 1e-9;

/// The loop that a vertex lies on, and where.
struct RimPlace {
    const RimLoop* loop = nullptr;
    int index = 0;
};

RimPlace placeOnRim(const SurfaceLinks& links, const std::vector<RimLoop>& rims,
                    const SurfacePoint& point) {
    const Carrier carrier = links.carrierOf(point);
    if (carrier.kind == Carrier::Kind::Vertex) {
        for (const RimLoop& rim : rims) {
            const auto at = std::ranges::find(rim.vertices, carrier.index);
            if (at != rim.vertices.end()) {
                return {&rim, static_cast<int>(at - rim.vertices.begin())};
            }
        }
    }
    return {};
}

/// The cut with its last point moved along the loop by `steps` vertices, pulled tight.
PathPolyline slid(const SurfaceLinks& links, PathPolyline cut, const RimPlace& place, int steps) {
    const int size = static_cast<int>(place.loop->vertices.size());
    const int stride = steps > 0 ? 1 : -1;
    for (int s = stride; s != steps + stride; s += stride) {
        const int at = ((place.index + s) % size + size) % size;
        cut.points.push_back(links.atVertex(place.loop->vertices[at]));
    }
    return straightened(links, cut);
}

/// Slides the last point as far as it helps. True where it did.
bool slideEnd(const SurfaceLinks& links, const std::vector<RimLoop>& rims, PathPolyline& cut) {
    RimPlace place = placeOnRim(links, rims, cut.points.back());
    if (place.loop == nullptr) {
        return false;
    }
    const int size = static_cast<int>(place.loop->vertices.size());
    bool moved = false;
    for (int step = std::max(1, size / 8); step > 0; step /= 2) {
        for (int round = 0; round < kMaxRounds; ++round) {
            PathPolyline best = cut;
            int direction = 0;
            for (const int d : {1, -1}) {
                PathPolyline other = slid(links, cut, place, d * step);
                if (other.length < best.length - kWorthwhile * cut.length) {
                    best = std::move(other);
                    direction = d;
                }
            }
            if (direction == 0) {
                break;
            }
            cut = std::move(best);
            place.index = ((place.index + direction * step) % size + size) % size;
            moved = true;
        }
    }
    return moved;
}

}  // namespace

PathPolyline shortenedCut(const SurfaceLinks& links, const std::vector<RimLoop>& rims,
                          const PathPolyline& cut) {
    PathPolyline best = straightened(links, cut);
    const auto flip = [&best] { std::reverse(best.points.begin(), best.points.end()); };
    for (int round = 0; round < kMaxRounds; ++round) {
        const bool back = slideEnd(links, rims, best);
        flip();
        const bool front = slideEnd(links, rims, best);
        flip();
        if (!back && !front) {
            break;
        }
    }
    return best;
}

}  // namespace toile
