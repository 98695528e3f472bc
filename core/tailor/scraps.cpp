// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/scraps.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/geometry/disjoint_sets.h"
#include "core/tailor/cut_stretches.h"

namespace toile::tailor {
namespace {

/// Parts smaller than this are scraps, mm2.
constexpr double kScrapArea = 600;

constexpr int kUncut = -1, kCutAnyhow = -2;

class Scraps {
public:
    Scraps(const BodyWays& ways, const std::vector<TailorSeam>& seams,
           const std::vector<std::vector<int>>& cuts)
        : links_(ways.links()),
          seams_(seams),
          seamOf_(static_cast<std::size_t>(links_.edgeCount()), kUncut),
          parts_(links_.faceCount()) {
        for (std::size_t s = 0; s < seams.size(); ++s) {
            mark(seams[s].way, static_cast<int>(s));
        }
        for (const std::vector<int>& cut : cuts) {
            mark(cut, kCutAnyhow);
        }
    }

    std::vector<TailorSeam> run() {
        for (int e = 0; e < links_.edgeCount(); ++e) {
            if (seamOf_[e] == kUncut) {
                join(e);
            }
        }
        while (joinScraps()) {
        }
        std::vector<TailorSeam> left;
        for (const TailorSeam& seam : seams_) {
            const auto isLeftOut = [this](int from, int to) {
                return seamOf_[findEdge(links_.table().edges, from, to)] < 0;
            };
            for (std::vector<int>& way : stretchesOf(seam.way, isLeftOut)) {
                left.push_back({seam.line, seam.side, std::move(way), seam.likeliness});
            }
        }
        return left;
    }

private:
    void mark(const std::vector<int>& way, int seam) {
        for (std::size_t k = 1; k < way.size(); ++k) {
            seamOf_[findEdge(links_.table().edges, way[k - 1], way[k])] = seam;
        }
    }

    /// The triangles at an edge; the second -1 at a rim.
    std::pair<int, int> facesAt(int edge) const {
        const auto uses = links_.table().usesOf(edge);
        return {uses[0] / 3, uses.size() == 2 ? uses[1] / 3 : -1};
    }

    void join(int edge) {
        const auto [one, other] = facesAt(edge);
        if (other >= 0) {
            parts_.join(one, other);
        }
    }

    /// The edges of a line between a part and a neighbour.
    struct Border {
        double length = 0;
        std::vector<int> edges;
    };

    /// Joins each scrap to the neighbour with which it shares most of a proposed line; those that
    /// have come to be one with another wait for the next turn. False where there is none.
    bool joinScraps() {
        std::vector<double> areas(static_cast<std::size_t>(links_.faceCount()), 0);
        for (int f = 0; f < links_.faceCount(); ++f) {
            areas[parts_.root(f)] += doubleAreaNormal(links_.mesh(), f).norm() / 2;
        }
        std::map<int, std::map<std::pair<int, int>, Border>> borders;  // by scrap
        for (int e = 0; e < links_.edgeCount(); ++e) {
            const auto [one, other] = facesAt(e);
            if (seamOf_[e] < 0 || other < 0) {
                continue;
            }
            const int a = parts_.root(one), b = parts_.root(other);
            for (const auto& [scrap, neighbour] : {std::pair(a, b), std::pair(b, a)}) {
                if (a != b && areas[scrap] < kScrapArea) {
                    Border& border = borders[scrap][{neighbour, seamOf_[e]}];
                    border.length += lengthOf(e);
                    border.edges.push_back(e);
                }
            }
        }
        for (const auto& [scrap, around] : borders) {
            const auto most = std::ranges::max_element(
                around, {}, [](const auto& one) { return one.second.length; });
            for (const int e : most->second.edges) {
                const auto [one, other] = facesAt(e);
                if (parts_.root(one) != parts_.root(other)) {
                    seamOf_[e] = kUncut;
                }
            }
            for (const int e : most->second.edges) {
                if (seamOf_[e] == kUncut) {
                    join(e);
                }
            }
        }
        return !borders.empty();
    }

    double lengthOf(int edge) const {
        const auto ends = links_.table().edges.row(edge);
        return (links_.mesh().V.row(ends[1]) - links_.mesh().V.row(ends[0])).norm();
    }

    const SurfaceLinks& links_;
    const std::vector<TailorSeam>& seams_;
    std::vector<int> seamOf_;  ///< per edge: the seam that cuts it, or what else
    geometry::DisjointSets parts_;
};

}  // namespace

std::vector<TailorSeam> withoutScraps(const BodyWays& ways, const std::vector<TailorSeam>& seams,
                                      const std::vector<std::vector<int>>& cuts) {
    return Scraps(ways, seams, cuts).run();
}

}  // namespace toile::tailor
