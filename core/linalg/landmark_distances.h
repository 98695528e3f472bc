// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/linalg/elimination_order.h"

namespace toile {

inline constexpr int kLandmarks = 5;

/// Of one vertex: distances from the landmarks, in edges. Those beyond 65535 count as that.
using LandmarkDistances = std::array<std::uint16_t, kLandmarks>;

/// Measures how far vertices are from a few landmarks on the rim of their part of the graph, each
/// landmark as far as can be from those before; in every connected part from landmarks of its own.
/// Along an edge each distance changes by one at most. One thread at a time.
class LandmarkSurvey {
public:
    /// Keeps a reference.
    explicit LandmarkSurvey(const CouplingGraph& graph);

    /// Sets the distances of some vertices, counted over these alone.
    /// @param vertices   each once  @param closed  per vertex of the graph: not 0 where no way
    /// leads
    ///                   through; whatever else is beside the vertices must be closed
    /// @param distances  per vertex of the graph; those of other vertices stay
    /// Cost: linear in the vertices and their neighbours.
    void measure(const std::vector<int>& vertices, const std::vector<char>& closed,
                 std::vector<LandmarkDistances>& distances);

private:
    void walkFrom(const std::vector<int>& landmarks, const std::vector<int>& vertices,
                  const std::vector<char>& closed);
    void walkPart(int first, const std::vector<char>& closed);
    std::size_t endOf(std::size_t part) const;
    std::vector<int> farthestOfParts() const;

    const CouplingGraph& graph_;
    std::vector<int> queue_;          ///< vertices by depth, connected part after part
    std::vector<int> depth_;          ///< per vertex: distance from its part's landmark
    std::vector<int> nearest_;        ///< per vertex: distance from the nearest landmark so far
    std::vector<std::size_t> parts_;  ///< where each part begins in the queue
};

}  // namespace toile
