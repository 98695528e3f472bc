// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/notches.h"
#include "core/pattern/segments.h"
#include "core/seam/outline.h"

// Internal header of this folder.
namespace toile {

/// Places of automatic notches, seam by seam. They have a share, a count, a reason and sides.
class NotchPlaces {
public:
    /// The arguments must outlive this.
    NotchPlaces(const Garment& garment, const seam::Outlines& outlines,
                const std::vector<OutlineSegments>& segments);

    /// Fixed notches: at ends that no corner marks, at ease, at the start of a closed seam.
    std::vector<Notch> fixed(int seam) const;
    /// Adds balance notches in one of the possible ways, except those too near to another notch; 0
    /// is the usual way for the seam's length.
    std::vector<Notch> balanced(int seam, std::vector<Notch> notches, int way) const;
    static int ways();

    /// Whether two seams of a piece could be confused by their length and notches.
    bool canBeConfused(int one, const std::vector<Notch>& notches, int other,
                       const std::vector<Notch>& others) const;

    /// The sewn seams that touch a piece, ascending.
    const std::vector<int>& seamsOf(int piece) const { return seamsOf_[piece]; }
    double lengthOf(int seam) const;
    /// By convention: 2 towards the back.
    int countOf(int seam) const;

private:
    bool runsOn(const SeamSide& side, double at) const;
    bool isSleeveHead(const SeamSide& side, double at) const;
    double lowestOf(const SeamSide& side) const;

    const Garment& garment_;
    const seam::Outlines& outlines_;
    const std::vector<OutlineSegments>& segments_;
    std::vector<std::vector<int>> seamsOf_;
    double backwards_ = 0;  ///< seams with less z than this are towards the back
};

}  // namespace toile
