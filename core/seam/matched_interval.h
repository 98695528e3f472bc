// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "core/seam/contacts.h"
#include "core/seam/find_seams.h"
#include "core/seam/outline.h"

namespace toile::seam {

/// A stretch of a closed line from `from` to `to` >= from; `to` may exceed the line's length.
struct Arc {
    double from = 0, to = 0;
};

/// A set of places on a closed line, stored as disjoint stretches.
class ArcSet {
public:
    explicit ArcSet(double length) : length_(length) {}

    void add(Arc arc);
    /// The parts of `arc` that are not in the set, in order, counted like `arc`.
    std::vector<Arc> outside(Arc arc) const;

private:
    void insert(Arc arc);

    double length_;
    std::vector<Arc> taken_;  ///< in [0, length], sorted, disjoint
};

/// A place on one outline and the facing place on another; both may exceed the perimeter.
struct Correspondence {
    double a = 0, b = 0;  ///< mm
    double gap = 0;       ///< distance, mm
};

/// Two stretches of outline that face each other: a candidate seam. `line` has increasing a; its b
/// increases if `parallel`, else decreases.
struct MatchedInterval {
    int outlineA = 0, outlineB = 0;  ///< of Outlines::list, outlineA <= outlineB
    bool parallel = false;
    bool certain = false;  ///< all contacts are certain
    bool folded = false;   ///< the outline folds onto itself at a plain edge: at most a pleat
    bool stacked = false;  ///< side b overlaps a place of another interval
    std::vector<Correspondence> line;

    Arc arcA() const { return {line.front().a, line.back().a}; }
    Arc arcB() const;
    double length() const { return line.back().a - line.front().a; }
    double lengthB() const { return std::abs(line.back().b - line.front().b); }
    /// The facing places at a place on side a or b; interpolated, clamped to the ends.
    Correspondence atA(double a) const;
    Correspondence atB(double b) const;
    /// The part between two places on side a.
    MatchedInterval part(Arc onA) const;
    /// The part between two places on side b.
    MatchedInterval partOnB(Arc onB) const;
    /// Mean distance of the sides, mm.
    double meanGap() const;
    /// Local edge length in the middle, the mean of both sides.
    double spacing(const Outlines& outlines) const;
};

/// Ends at which the two sides of an interval of a piece with itself meet.
struct FoldEnds {
    bool start = false, end = false;
    double angle = 0;  ///< inner angle of the outline there, radians
};

FoldEnds foldEndsOf(const MatchedInterval& interval, const Outlines& outlines);

/// Joins consecutive contacts on both outlines into maximal intervals.
/// @param contacts  sorted by (a, b). Cost: linear, plus look-ups.
std::vector<MatchedInterval> chainContacts(const Outlines& outlines,
                                           const std::vector<Contact>& contacts);

/// Decides between competing intervals, so that each place of an outline is in at most one interval
/// (stacked layers excepted). Intervals are split where others begin and end. Parts are chosen by
/// gap, then by the undisputed length of their interval, then by length; consecutive parts of an
/// interval are joined again. Cost: n log n if few intervals overlap. Intervals found only by
/// proximity are accidents, and are dropped, if they are shorter than nine tenths of a local edge,
/// or if their gap is far above that of this garment's seams.
std::vector<MatchedInterval> chooseIntervals(const Outlines& outlines,
                                             const std::vector<MatchedInterval>& candidates);

/// Joins consecutive intervals on both outlines with no or only a few free edges between them.
/// `taken` has the places of all intervals per piece; bridges are added to it.
std::vector<MatchedInterval> joinIntervals(const Outlines& outlines,
                                           std::vector<MatchedInterval> intervals,
                                           std::vector<ArcSet>& taken);

/// Turns an interval into a seam: decides the kind, snaps its ends to near vertices, and records
/// the corresponding places. Does not set a name.
Seam finishSeam(const Outlines& outlines, MatchedInterval interval);

/// A seam with one side: an edge that is not sewn.
/// @param index  the outline
Seam freeEdge(const Outlines& outlines, int index, Arc arc);

/// Orders seams (sewn ones first; by piece, kind, then place in space) and names them.
void orderAndName(const Pieces& pieces, const Outlines& outlines, std::vector<Seam>& seams);

}  // namespace toile::seam
