// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/linalg/elimination_order.h"
#include "core/linalg/landmark_distances.h"

namespace toile {
namespace {

constexpr int kLeaf = 24;
/// Each side of a separator has at least this part of the unknowns, if there is such a separator.
constexpr double kLeastSide = 0.2;
/// Behind a narrow place all landmarks lie the same way, and all levels run across: separators get
/// long, measured by the root of the unknowns. Then distances are counted anew within the part.
constexpr double kLongSeparator = 1.3;
constexpr double kMuchSmaller = 0.6;
constexpr double kWorthASurvey = 100;
/// Of the unknowns: so many may lie in parts that cannot be halved.
constexpr double kMostUnsplit = 0.1;

using Distances = LandmarkDistances;

/// Vertices at one distance from one landmark.
struct Level {
    int landmark = -1;  ///< -1: none
    int distance = 0;
    double size = 0;
};

class Dissection {
public:
    explicit Dissection(const CouplingGraph& graph)
        : graph_(graph),
          distances_(static_cast<std::size_t>(graph.size())),
          members_(distances_.size()),
          sorted_(distances_.size()),
          order_(distances_.size()),
          inSeparator_(distances_.size(), 0) {
        for (std::size_t v = 0; v < members_.size(); ++v) {
            members_[v].vertex = static_cast<int>(v);
        }
    }

    std::vector<int> run() {
        const std::size_t size = members_.size();
        Workspace work(graph_);
        measure(0, size, work);
        dissect(0, size, size, size, work);
        if (static_cast<double>(work.unsplit) > kMostUnsplit * static_cast<double>(size)) {
            return {};
        }
        return std::move(order_);
    }

private:
    /// What dissecting a part needs.
    struct Workspace {
        explicit Workspace(const CouplingGraph& graph)
            : survey(graph), local(static_cast<std::size_t>(graph.size()), -1) {}

        LandmarkSurvey survey;
        std::vector<int> local;  ///< numbers within a leaf
        std::vector<int> sizes;  ///< of levels
        std::vector<int> part;   ///< to be surveyed
        std::size_t unsplit = 0;
    };

    /// A vertex and its distances side by side, for going through a part without jumps.
    struct Member {
        int vertex = 0;
        Distances distances{};
    };

    /// Orders the members first to last - 1; they are eliminated just before place `end`.
    /// @param surveyed  size of the part in which the distances were counted
    void dissect(std::size_t first, std::size_t last, std::size_t end, std::size_t surveyed,
                 Workspace& work) {
        if (last - first <= kLeaf) {
            orderByDegree(first, last, end, work);
            return;
        }
        Level level = smallestLevel(first, last, work);
        const auto size = static_cast<double>(last - first);
        if (size > kWorthASurvey && level.size > kLongSeparator * std::sqrt(size) &&
            size < kMuchSmaller * static_cast<double>(surveyed)) {
            measure(first, last, work);
            surveyed = last - first;
            level = smallestLevel(first, last, work);
        }
        if (level.landmark < 0) {
            work.unsplit += last - first;
            for (std::size_t k = last; k > first; --k) {
                order_[--end] = members_[k - 1].vertex;
            }
            return;
        }
        const auto [lower, upper] = divide(first, last, level);
        for (std::size_t k = upper; k > lower; --k) {
            order_[--end] = members_[k - 1].vertex;
        }
        dissect(upper, last, end, surveyed, work);
        dissect(first, lower, end - (last - upper), surveyed, work);
    }

    /// Counts the distances of the members anew, within their part.
    void measure(std::size_t first, std::size_t last, Workspace& work) {
        work.part.clear();
        for (std::size_t k = first; k < last; ++k) {
            work.part.push_back(members_[k].vertex);
        }
        work.survey.measure(work.part, inSeparator_, distances_);
        for (std::size_t k = first; k < last; ++k) {
            members_[k].distances = distances_[members_[k].vertex];
        }
    }

    /// The smallest level that has enough vertices on either side; where no level has, the one in
    /// the middle.
    Level smallestLevel(std::size_t first, std::size_t last, Workspace& work) {
        Distances low = members_[first].distances;
        Distances high = low;
        for (std::size_t k = first + 1; k < last; ++k) {
            for (int c = 0; c < kLandmarks; ++c) {
                low[c] = std::min(low[c], members_[k].distances[c]);
                high[c] = std::max(high[c], members_[k].distances[c]);
            }
        }
        std::array<int, kLandmarks + 1> start{};  // of each landmark's levels in work.sizes
        for (int c = 0; c < kLandmarks; ++c) {
            start[c + 1] = start[c] + high[c] - low[c] + 1;
        }
        work.sizes.assign(static_cast<std::size_t>(start[kLandmarks]), 0);
        for (std::size_t k = first; k < last; ++k) {
            for (int c = 0; c < kLandmarks; ++c) {
                ++work.sizes[start[c] + members_[k].distances[c] - low[c]];
            }
        }
        const auto all = static_cast<double>(last - first);
        Level best;
        double bestCost = std::numeric_limits<double>::infinity();
        for (int c = 0; c < kLandmarks; ++c) {
            double below = 0;
            for (int d = 0; d <= high[c] - low[c]; ++d) {
                const double size = work.sizes[start[c] + d];
                const double above = all - below - size;
                const bool even = std::min(below, above) >= kLeastSide * all;
                const bool middle = below <= 0.5 * all && above <= 0.5 * all;
                const double cost = size * (1 + std::abs(below - above) / all);
                if ((even || middle) && below > 0 && above > 0 && cost < bestCost) {
                    bestCost = cost;
                    best = {c, low[c] + d, size};
                }
                below += size;
            }
        }
        return best;
    }

    /// Sorts members into those below the level, the separator, and those above. Vertices of the
    /// level without a neighbour above are not needed to separate.
    /// @return where the separator begins and ends
    std::pair<std::size_t, std::size_t> divide(std::size_t first, std::size_t last,
                                               const Level& level) {
        const int c = level.landmark;
        std::size_t below = 0, above = 0;
        for (std::size_t k = first; k < last; ++k) {
            below += members_[k].distances[c] < level.distance ? 1 : 0;
            above += members_[k].distances[c] > level.distance ? 1 : 0;
        }
        std::size_t low = first, high = last - above, separator = high;
        for (std::size_t k = first; k < last; ++k) {
            const Member& member = members_[k];
            if (member.distances[c] > level.distance) {
                sorted_[high++] = member;
            } else if (member.distances[c] < level.distance || !touchesAbove(member, level)) {
                sorted_[low++] = member;
            } else {
                sorted_[--separator] = member;
            }
        }
        for (std::size_t k = separator; k < last - above; ++k) {
            inSeparator_[sorted_[k].vertex] = 1;
        }
        std::copy(sorted_.begin() + static_cast<std::ptrdiff_t>(first),
                  sorted_.begin() + static_cast<std::ptrdiff_t>(last),
                  members_.begin() + static_cast<std::ptrdiff_t>(first));
        return {separator, last - above};
    }

    /// Neighbours outside the part lie in separators made before.
    bool touchesAbove(const Member& member, const Level& level) const {
        for (int e = graph_.start[member.vertex]; e < graph_.start[member.vertex + 1]; ++e) {
            const int w = graph_.neighbour[e];
            if (inSeparator_[w] == 0 && distances_[w][level.landmark] > level.distance) {
                return true;
            }
        }
        return false;
    }

    /// Minimum degree among a few vertices; their neighbours outside count, as far as 64 bits go.
    void orderByDegree(std::size_t first, std::size_t last, std::size_t end, Workspace& work) {
        constexpr int kBits = 64;
        std::array<int, kBits> vertex{};
        int count = 0;
        const auto number = [&](int v) -> int {
            if (work.local[v] < 0 && count < kBits) {
                work.local[v] = count;
                vertex[count++] = v;
            }
            return work.local[v];
        };
        for (std::size_t k = first; k < last; ++k) {
            number(members_[k].vertex);
        }
        const int inside = count;
        std::array<std::uint64_t, kBits> adjacent{};
        for (int i = 0; i < inside; ++i) {
            for (int e = graph_.start[vertex[i]]; e < graph_.start[vertex[i] + 1]; ++e) {
                if (const int j = number(graph_.neighbour[e]); j >= 0) {
                    adjacent[i] |= std::uint64_t{1} << j;
                    adjacent[j] |= std::uint64_t{1} << i;
                }
            }
        }
        for (int i = 0; i < count; ++i) {
            work.local[vertex[i]] = -1;
        }
        std::size_t place = end - (last - first);
        for (std::uint64_t left = (std::uint64_t{1} << inside) - 1; left != 0;) {
            int least = std::countr_zero(left);
            for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
                const int i = std::countr_zero(rest);
                least = std::popcount(adjacent[i]) < std::popcount(adjacent[least]) ? i : least;
            }
            order_[place++] = vertex[least];
            left &= ~(std::uint64_t{1} << least);
            for (std::uint64_t rest = adjacent[least]; rest != 0; rest &= rest - 1) {
                const int i = std::countr_zero(rest);
                adjacent[i] |= adjacent[least];
                adjacent[i] &= ~((std::uint64_t{1} << i) | (std::uint64_t{1} << least));
            }
        }
    }

    const CouplingGraph& graph_;
    std::vector<Distances> distances_;
    std::vector<Member> members_;  ///< permuted so that each part is a range
    std::vector<Member> sorted_;
    std::vector<int> order_;
    std::vector<char> inSeparator_;
};

}  // namespace

std::vector<int> nestedDissection(const CouplingGraph& graph) {
    return Dissection(graph).run();
}

}  // namespace toile
