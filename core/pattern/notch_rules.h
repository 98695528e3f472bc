// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/notches.h"
#include "core/pattern/segments.h"
#include "core/seam/outline.h"

// For the sources of this folder only.
namespace toile {

/// Where notches go by themselves, seam by seam. They have a share, a count, a reason and sides.
class NotchPlaces {
public:
    /// What is given stays while this lives.
    NotchPlaces(const Garment& garment, const seam::Outlines& outlines,
                const std::vector<OutlineSegments>& segments);

    /// Those that nothing else decides: ends that no corner marks, ease, the start of a closed
    /// seam.
    std::vector<Notch> fixed(int seam) const;
    /// With balance notches in one of the ways there are, but for those too near to another: 0 is
    /// the usual one for a seam so long.
    std::vector<Notch> balanced(int seam, std::vector<Notch> notches, int way) const;
    static int ways();

    /// Whether two seams of one piece could be taken for each other by length and notches.
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
    double backwards_ = 0;  ///< seams with less z than this lie towards the back
};

}  // namespace toile
