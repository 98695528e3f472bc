// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/garment/piece.h"
#include "core/seam/outline.h"

namespace toile::seam {

/// A place with more edges within each other's radius than any garment has.
struct CrowdedPlace {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< mm
    int edges = 0;
};

struct NearbyEdges {
    std::vector<std::pair<int, int>> pairs;  ///< a < b, each once, sorted
    std::vector<CrowdedPlace> crowded;       ///< places whose pairs are left out
};

/// All pairs of outline edges, not in `skip`, that may come within the sum of their radii (mm, per
/// edge) of each other, and a few more; pairs in crowded places are left out. Octree cells are
/// split while that separates edges, so that uneven sampling costs nothing. Cost: n log n; memory
/// linear in the edges, in any arrangement. Pure.
NearbyEdges nearbyEdges(const Outlines& outlines, const std::vector<char>& skip,
                        const std::vector<double>& radius);

/// Two outline edges that coincide or are near each other: the parts that face each other.
struct Contact {
    int a = 0, b = 0;           ///< edges, a < b
    double a0 = 0, a1 = 0;      ///< from .. to along edge a, mm, a0 < a1
    double b0 = 0, b1 = 0;      ///< the places on edge b that face a0 and a1
    double gap0 = 0, gap1 = 0;  ///< distance there
    bool parallel = false;      ///< the two edges run in the same direction
    bool certain = false;       ///< the only two edges between their two source positions
};

/// Edges of one file between the same two source positions. Edges found twice or more are marked in
/// `settled`, so that proximity is not tested for them. If three or more share the positions, every
/// pair gives a contact that is not certain.
std::vector<Contact> sharedContacts(const Pieces& pieces, const Outlines& outlines,
                                    std::vector<char>& settled);

/// Pairs of unsettled edges that come closer than `gap` local edge lengths along a common stretch
/// and run (nearly) along one line; parallel pairs only between different pieces. Pairs in crowded
/// places are left out. Cost: n log n.
std::vector<Contact> nearContacts(const Outlines& outlines, double gap,
                                  const std::vector<char>& settled,
                                  std::vector<CrowdedPlace>& crowded);

/// Edges that are everywhere closer than this fraction of the garment's diagonal coincide.
inline constexpr double kCoincidentShare = 1e-6;

/// Removes near contacts that contradict the garment's vertices, so that two hems that lie on each
/// other stay open. Proximity adds nothing between pieces that are welded to each other in their
/// file, or both to others. Between pieces with whole edges that coincide, or are the two sides of
/// a cut, it adds nothing if the cloth of both lies on the same side, as in layers. The parts
/// of a cut piece count as a single piece. Coincident contacts are kept.
/// @param shared  from `sharedContacts`  Cost: linear.
void dropContradicted(const Pieces& pieces, const Outlines& outlines,
                      const std::vector<Contact>& shared, std::vector<Contact>& near);

/// Removes contacts that run the wrong way: the balance of contacts decides which pieces have
/// opposite winding. Sorts by (a, b).
void keepConsistentWinding(const Outlines& outlines, std::vector<Contact>& contacts);

}  // namespace toile::seam
