// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/path_strip.h"

namespace toile {
namespace {

double angleOfTurn(const SurfaceLinks& links, int vertex, const std::vector<int>& exits) {
    double sum = 0;
    for (std::size_t i = 1; i < exits.size(); ++i) {
        const int face = exits[i] / 3;
        sum += links.angleAt(3 * face + links.cornerIn(face, vertex));
    }
    return sum;
}

/// The way from one triangle to the next at a point that both touch.
std::optional<std::vector<int>> exitsAt(const SurfaceLinks& links, const SurfacePoint& point,
                                        int fromFace, int toFace) {
    const Carrier carrier = links.carrierOf(point);
    if (fromFace == toFace) {
        return std::vector<int>{};
    }
    if (carrier.kind == Carrier::Kind::Edge) {
        for (int use = 3 * fromFace; use < 3 * fromFace + 3; ++use) {
            if (links.edgeOf(use) == carrier.index && links.twin(use) / 3 == toFace &&
                links.twin(use) >= 0) {
                return std::vector<int>{use};
            }
        }
        return std::nullopt;
    }
    if (carrier.kind == Carrier::Kind::Face) {
        return std::nullopt;
    }
    auto left = exitsAround(links, carrier.index, fromFace, toFace, true);
    auto right = exitsAround(links, carrier.index, fromFace, toFace, false);
    if (left && right) {
        const bool leftIsSmaller =
            angleOfTurn(links, carrier.index, *left) <= angleOfTurn(links, carrier.index, *right);
        return leftIsSmaller ? left : right;
    }
    return left ? left : right;
}

}  // namespace

std::optional<std::vector<int>> exitsAround(const SurfaceLinks& links, int vertex, int fromFace,
                                            int toFace, bool leftward) {
    std::vector<int> exits;
    for (int face = fromFace; face != toFace;) {
        const int corner = links.cornerIn(face, vertex);
        const int use = 3 * face + (leftward ? (corner + 2) % 3 : corner);
        if (links.twin(use) < 0) {
            return std::nullopt;
        }
        exits.push_back(use);
        face = links.twin(use) / 3;
        if (face == fromFace) {
            return std::nullopt;  // once around: another fan of a pinched vertex
        }
    }
    return exits;
}

std::optional<Strip> stripAlong(const SurfaceLinks& links,
                                const std::vector<SurfacePoint>& points) {
    Strip strip;
    int face = points.size() < 2 ? -1 : links.commonFace(points[0], points[1]);
    if (face < 0) {
        return std::nullopt;
    }
    strip.from = *links.seenFrom(face, points.front());
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const int next = links.commonFace(points[i], points[i + 1], face);
        if (next < 0) {
            return std::nullopt;
        }
        const auto exits = exitsAt(links, points[i], face, next);
        if (!exits) {
            return std::nullopt;
        }
        strip.exits.insert(strip.exits.end(), exits->begin(), exits->end());
        face = next;
    }
    strip.to = *links.seenFrom(face, points.back());
    tidy(links, strip);
    return strip;
}

void tidy(const SurfaceLinks& links, Strip& strip) {
    std::vector<int> kept;
    for (const int use : strip.exits) {
        if (!kept.empty() && links.twin(kept.back()) == use) {
            kept.pop_back();
        } else {
            kept.push_back(use);
        }
    }
    std::size_t first = 0;
    while (first < kept.size()) {
        const auto seen = links.seenFrom(links.twin(kept[first]) / 3, strip.from);
        if (!seen) {
            break;
        }
        strip.from = *seen;
        ++first;
    }
    while (kept.size() > first) {
        const auto seen = links.seenFrom(kept.back() / 3, strip.to);
        if (!seen) {
            break;
        }
        strip.to = *seen;
        kept.pop_back();
    }
    strip.exits.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

}  // namespace toile
