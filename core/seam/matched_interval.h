// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "core/seam/contacts.h"
#include "core/seam/find_seams.h"
#include "core/seam/outline.h"

namespace toile::seam {

/// A stretch of a closed line from `from` to `to` >= from, counted on past the line's length.
struct Arc {
    double from = 0, to = 0;
};

/// A set of places on a closed line, kept as disjoint stretches.
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

/// A place on one outline and the place on another that faces it, counted on along both outlines.
struct Correspondence {
    double a = 0, b = 0;  ///< mm
    double gap = 0;       ///< distance, mm
};

/// Two stretches of outline that face each other all along: a seam, before anything competes for
/// its place. `line` has increasing a; its b increases where `parallel`, else decreases.
struct MatchedInterval {
    int outlineA = 0, outlineB = 0;  ///< of Outlines::list, outlineA <= outlineB
    bool parallel = false;
    bool certain = false;  ///< made of contacts that are certain
    bool folded = false;   ///< the outline folded on itself at a plain edge: a pleat, if at all
    bool stacked = false;  ///< side b lies on a place that another interval has been given
    std::vector<Correspondence> line;

    Arc arcA() const { return {line.front().a, line.back().a}; }
    Arc arcB() const;
    double length() const { return line.back().a - line.front().a; }
    double lengthB() const { return std::abs(line.back().b - line.front().b); }
    /// The facing places at a place on side a, or on side b; interpolated, clamped to the ends.
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

/// Where a piece meets itself: the ends of an interval at which its two sides come together.
struct FoldEnds {
    bool start = false, end = false;
    double angle = 0;  ///< inner angle of the outline there, radians
};

FoldEnds foldEndsOf(const MatchedInterval& interval, const Outlines& outlines);

/// Joins contacts that follow each other on both outlines into maximal intervals.
/// @param contacts  sorted by (a, b). Linear but for look-ups.
std::vector<MatchedInterval> chainContacts(const Outlines& outlines,
                                           const std::vector<Contact>& contacts);

/// Decides between intervals that compete for a place, so that each place of an outline is in one
/// interval at most (but for stacked layers). Intervals are cut where others begin and end; the
/// parts are taken in order of their gap, then of what their interval has undisputed, then of
/// length; parts of an interval that follow each other are one again. Cost: n log n where few
/// intervals lie on one place. Of what was found by nearness alone intervals are left out that are
/// shorter than nine tenths of a local edge, or that gape far more than this garment's seams do: an
/// accident, and no seam.
std::vector<MatchedInterval> chooseIntervals(const Outlines& outlines,
                                             const std::vector<MatchedInterval>& candidates);

/// Makes one of intervals that follow each other on both outlines, with nothing or only a few free
/// edges between them. `taken` are the places of all intervals per piece; bridges are added to it.
std::vector<MatchedInterval> joinIntervals(const Outlines& outlines,
                                           std::vector<MatchedInterval> intervals,
                                           std::vector<ArcSet>& taken);

/// Makes a seam of an interval: decides the kind, puts its ends on vertices that are near enough,
/// and writes down the corresponding places. No name yet.
Seam finishSeam(const Outlines& outlines, MatchedInterval interval);

/// A seam of one side: an edge sewn to nothing.
/// @param index  of the outline
Seam freeEdge(const Outlines& outlines, int index, Arc arc);

/// Orders seams (sewn ones first; by piece, kind, then place in space) and names them.
void orderAndName(const std::vector<std::shared_ptr<const Piece>>& pieces, const Outlines& outlines,
                  std::vector<Seam>& seams);

}  // namespace toile::seam
