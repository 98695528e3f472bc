// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/garment/piece.h"
#include "core/seam/outline.h"

namespace toile::seam {

/// A place where more edges lie within each other's radius than any garment has.
struct CrowdedPlace {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< mm
    int edges = 0;
};

struct NearbyEdges {
    std::vector<std::pair<int, int>> pairs;  ///< a < b, each once, sorted
    std::vector<CrowdedPlace> crowded;       ///< pairs are left out there
};

/// Outline edges, not in `skip`, that may come within the sum of their radii (mm, per edge) of
/// each other: all such pairs, and some more, but for those in crowded places. The cells of an
/// octree are divided as long as that parts the edges in them, so that uneven sampling costs
/// nothing. Cost: n log n; memory linear in the edges, however they lie. Pure.
NearbyEdges nearbyEdges(const Outlines& outlines, const std::vector<char>& skip,
                        const std::vector<double>& radius);

/// Two outline edges that lie on each other, or near: the part of each that faces the other.
struct Contact {
    int a = 0, b = 0;           ///< edges, a < b
    double a0 = 0, a1 = 0;      ///< from .. to along edge a, mm, a0 < a1
    double b0 = 0, b1 = 0;      ///< the places on edge b that face a0 and a1
    double gap0 = 0, gap1 = 0;  ///< distance there
    bool parallel = false;      ///< the two edges run in the same direction
    bool certain = false;       ///< the only two edges between their two source positions
};

/// Edges of one file between the same two source positions. Edges seen here twice or more are
/// marked in `settled`, so that nearness is not asked about them. Where three and more share the
/// positions there is a contact for every pair, none of them certain.
std::vector<Contact> sharedContacts(const std::vector<std::shared_ptr<const Piece>>& pieces,
                                    const Outlines& outlines, std::vector<char>& settled);

/// Pairs of edges, not settled, that come closer than `gap` local edge lengths along a common
/// stretch and run (nearly) along one line. Parallel ones only between different pieces.
/// Pairs in crowded places are left out. Cost: n log n.
std::vector<Contact> nearContacts(const Outlines& outlines, double gap,
                                  const std::vector<char>& settled,
                                  std::vector<CrowdedPlace>& crowded);

/// Edges that are nowhere further apart than this part of the garment's diagonal coincide.
inline constexpr double kCoincidentShare = 1e-6;

/// Takes out near contacts that the garment's own vertices speak against, so that a hem that lies
/// on another hem stays open. Nearness adds nothing between pieces that are welded to each other in
/// their file, or both to others. Between pieces with whole edges that coincide, or are the two
/// sides of a cut, it adds nothing where the cloth of both lies on the same side, as in layers. The
/// parts of a cut piece count as one. Contacts that coincide stay.
/// @param shared  of `sharedContacts`  Cost: linear.
void dropContradicted(const std::vector<std::shared_ptr<const Piece>>& pieces,
                      const Outlines& outlines, const std::vector<Contact>& shared,
                      std::vector<Contact>& near);

/// Takes out the contacts that run the wrong way: decides from the balance of contacts which pieces
/// are wound against each other. Sorts by (a, b).
void keepConsistentWinding(const Outlines& outlines, std::vector<Contact>& contacts);

}  // namespace toile::seam
