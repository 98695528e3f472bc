// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/bands.h"

#include <algorithm>
#include <limits>

#include "core/geometry/segment.h"

namespace toile::tailor {
namespace {

/// How wide a band is, mm, and how much of its rim it goes round.
constexpr double kNarrowest = 15, kWidest = 65, kAllRound = 0.85;
constexpr std::size_t kFewVertices = 3;

/// From a vertex to a line of vertices, mm.
double distanceToLine(const BodyWays& ways, int vertex, const std::vector<int>& line) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < line.size(); ++k) {
        least = std::min(least, geometry::distanceToSegment(ways.at(vertex), ways.at(line[k - 1]),
                                                            ways.at(line[k])));
    }
    return least;
}

}  // namespace

std::vector<char> bandsAmong(const BodyWays& body, const std::vector<std::vector<int>>& ways) {
    std::vector<char> isBand(ways.size(), 0);
    for (const BodyOpening& opening : body.body().openings) {
        std::vector<int> rim = opening.loop.vertices;
        if (rim.empty()) {
            continue;
        }
        rim.push_back(rim.front());
        std::vector<std::size_t> beside;
        for (std::size_t w = 0; w < ways.size(); ++w) {
            if (std::ranges::all_of(ways[w], [&](int v) {
                    const double far = distanceToLine(body, v, rim);
                    return far > kNarrowest && far < kWidest;
                })) {
                beside.push_back(w);
            }
        }
        double covered = 0;
        for (std::size_t k = 1; k < rim.size(); ++k) {
            const bool isCovered = std::ranges::any_of(beside, [&](std::size_t w) {
                return distanceToLine(body, rim[k], ways[w]) < kWidest;
            });
            covered += isCovered ? (body.at(rim[k]) - body.at(rim[k - 1])).norm() : 0;
        }
        for (const std::size_t w : beside) {
            isBand[w] = isBand[w] != 0 || covered > kAllRound * opening.loop.perimeter ? 1 : 0;
        }
    }
    return isBand;
}

MeshLines withoutBands(const BodyWays& body, MeshLines lines) {
    std::vector<std::size_t> likely;
    std::vector<std::vector<int>> ways;
    for (std::size_t line = 0; line < lines.ways.size(); ++line) {
        if (lines.likeliness[line] > MeshLines::kLikely && lines.ways[line].size() > kFewVertices) {
            likely.push_back(line);
            ways.push_back(lines.ways[line]);
        }
    }
    const std::vector<char> isBand = bandsAmong(body, ways);
    for (std::size_t k = 0; k < likely.size(); ++k) {
        lines.likeliness[likely[k]] *= isBand[k] != 0 ? 0 : 1;
    }
    return lines;
}

}  // namespace toile::tailor
