// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/line_facts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/seam/seam_measure.h"
#include "core/symmetry/symmetry.h"

namespace toile::app {

namespace {

/// Places on an outline are equal if they differ by less, mm.
constexpr double kSamePlace = 1e-3;

const PieceResult* shownOf(const Garment& garment, const PieceResults& results, std::size_t piece) {
    const PieceResult* result = piece < results.size() ? results[piece].get() : nullptr;
    return result && result->piece == garment.pieces[piece] && result->flat ? result : nullptr;
}

double largestStrain(const PieceResult& result) {
    if (!result.quality) {
        return 0;
    }
    return std::max(std::abs(result.quality->strainMin.value_or(0)),
                    std::abs(result.quality->strainMax.value_or(0)));
}

/// Sorts the ends by kink, the largest first, and measures the kinks of the drawn lines.
void judgeEnds(const Garment& garment, const PieceResults& results, LineFacts& facts) {
    std::ranges::stable_sort(facts.ends, std::greater<>(),
                             [](const SeamEnd& end) { return std::abs(end.kink); });
    const auto turnAt = [&](const OutlineCorner& corner) -> double {
        const auto piece = static_cast<std::size_t>(corner.piece);
        const TurnPoint& point =
            facts.segments[piece].turnPoints[static_cast<std::size_t>(corner.point)];
        const PieceResult* const shown = shownOf(garment, results, piece);
        return shown ? drawnTurn(*shown, point) : point.turn;
    };
    for (const SeamEnd& end : facts.ends) {
        facts.kept.push_back(kinkOf(turnAt(end.left), turnAt(end.right)));
    }
}

/// How much of a segment lies between two places of its outline, which may count past its end.
double shared(const Segment& segment, double from, double to, double perimeter) {
    double length = 0;
    for (int turn = -2; turn <= 2; ++turn) {
        length += std::max(0.0, std::min(segment.at.end, to + turn * perimeter) -
                                    std::max(segment.at.start, from + turn * perimeter));
    }
    return length;
}

double perimeterOf(const OutlineSegments& segments) {
    double perimeter = 0;
    for (const Segment& segment : segments.segments) {
        perimeter += segment.length();
    }
    return perimeter;
}

/// The segment that covers most of a stretch of outline.
std::optional<SegmentAt> mostOf(const LineFacts& facts, int piece, double from, double to) {
    if (piece < 0 || piece >= static_cast<int>(facts.segments.size())) {
        return std::nullopt;
    }
    const OutlineSegments& of = facts.segments[static_cast<std::size_t>(piece)];
    const double perimeter = perimeterOf(of);
    SegmentAt found{piece, -1};
    double most = 0;
    for (std::size_t k = 0; k < of.segments.size(); ++k) {
        if (const double has = shared(of.segments[k], from, to, perimeter); has > most) {
            most = has;
            found.segment = static_cast<int>(k);
        }
    }
    return found.segment < 0 ? std::nullopt : std::optional(found);
}

/// Place of a vertex along the outline; `k` may count on past its last vertex.
double arcAt(const Piece& piece, int k) {
    const std::size_t size = piece.boundary.size();
    double arc = 0;
    for (int i = 0; i < k; ++i) {
        const auto at = static_cast<std::size_t>(i) % size;
        arc += (piece.mesh.V.row(piece.boundary[(at + 1) % size]) -
                piece.mesh.V.row(piece.boundary[at]))
                   .norm();
    }
    return arc;
}

}  // namespace

DrawnFacts drawnFacts(const Garment& garment, const PieceResults& results) {
    DrawnFacts facts;
    for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
        const PieceResult* shown = shownOf(garment, results, i);
        if (!shown) {
            continue;
        }
        facts.exactStrain = std::max(facts.exactStrain, largestStrain(exactOf(*shown)));
        facts.strain = std::max(facts.strain, largestStrain(*shown));
        if (shown->flat->line) {
            facts.drawn = true;
            facts.farthest = std::max(facts.farthest, shown->flat->line->farthest);
        }
    }
    return facts;
}

LineFacts lineFacts(const Garment& garment, const PieceResults& results,
                    const LineSettings& lines) {
    LineFacts facts;
    static_cast<DrawnFacts&>(facts) = drawnFacts(garment, results);
    facts.segments = findSegments(garment, exactResults(garment, results), lines);
    facts.ends = findSeamEnds(garment, facts.segments, lines);
    judgeEnds(garment, results, facts);
    return facts;
}

std::optional<SegmentAt> segmentAt(const Garment& garment, const LineFacts& facts,
                                   const Feature& mark) {
    const Piece& piece = *garment.pieces[static_cast<std::size_t>(mark.piece)];
    if (mark.kind == Feature::Kind::Run) {
        return mostOf(facts, mark.piece, arcAt(piece, mark.first),
                      arcAt(piece, mark.first + mark.count));
    }
    const auto at = boundaryIndex(piece, mark.vertex);
    return at ? mostOf(facts, mark.piece, arcAt(piece, *at), arcAt(piece, *at + 1)) : std::nullopt;
}

std::optional<SegmentAt> segmentOfSeam(const LineFacts& facts, const Seam& seam) {
    const auto [from, to] = std::minmax(seam.left.start, seam.left.end);
    return seam.left.loop == 0 ? mostOf(facts, seam.left.piece, from, to) : std::nullopt;
}

std::optional<SegmentAt> partnerOf(const Garment& garment, const LineFacts& facts,
                                   const SegmentAt& one) {
    const Segment& segment = facts.at(one);
    if (segment.seam < 0) {
        return std::nullopt;
    }
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(segment.seam)];
    const SeamSide& there = segment.isRight ? seam.left : seam.right;
    if (there.piece < 0 || there.loop != 0 || seam.matches.empty()) {
        return std::nullopt;
    }
    const SeamSide& here = segment.isRight ? seam.right : seam.left;
    const double perimeter = perimeterOf(facts.segments[static_cast<std::size_t>(one.piece)]);
    double middle = (segment.at.start + segment.at.end) / 2;
    const double low = std::min(here.start, here.end);
    middle += perimeter * std::ceil((low - middle) / perimeter);  // counted as the seam does
    const double place = placeAcross(seam, middle, segment.isRight);
    return mostOf(facts, there.piece, place - kSamePlace, place + kSamePlace);
}

std::optional<SegmentAt> mirrorOf(const Garment& garment, const LineFacts& facts,
                                  const Symmetry& symmetry, const SegmentAt& one) {
    const Segment& segment = facts.at(one);
    const auto p = static_cast<std::size_t>(one.piece);
    if (segment.seam < 0 || p >= symmetry.segments.size()) {
        return std::nullopt;
    }
    const MirrorSegments& all = symmetry.segments;
    const auto found = std::ranges::find_if(all[p], [&segment](const MirrorSegment& side) {
        return side.seam == segment.seam && side.isRight == segment.isRight;
    });
    const int other = symmetry.pieces.counterpart[p];
    if (found == all[p].end() || other < 0) {
        return std::nullopt;
    }
    const int pair = symmetry.pairs[p][static_cast<std::size_t>(found - all[p].begin())];
    if (pair < 0) {
        return std::nullopt;
    }
    const MirrorSegment& image =
        all[static_cast<std::size_t>(other)][static_cast<std::size_t>(pair)];
    if (image.seam < 0 || image.seam >= static_cast<int>(garment.seams.seams.size())) {
        return std::nullopt;
    }
    const SeamSide &here = sideOf(garment, *found), &there = sideOf(garment, image);
    const double perimeter = perimeterOf(facts.segments[p]);
    const double middle = (segment.at.start + segment.at.end) / 2;
    double past = middle - std::min(here.start, here.end);
    past -= perimeter * std::floor(past / perimeter);
    // Outlines that mirror each other run in opposite senses.
    const double share = 1 - std::clamp(past / here.length(), 0.0, 1.0);
    const double place = std::min(there.start, there.end) + share * there.length();
    return mostOf(facts, other, place - kSamePlace, place + kSamePlace);
}

const TurnPoint* turnPointOf(const Piece& piece, const OutlineSegments& segments, int at) {
    const double place = arcAt(piece, at), perimeter = perimeterOf(segments);
    const auto found = std::ranges::find_if(segments.turnPoints, [&](const TurnPoint& point) {
        return std::abs(std::remainder(point.at - place, perimeter)) < kSamePlace;
    });
    return found == segments.turnPoints.end() ? nullptr : &*found;
}

std::optional<int> boundaryIndex(const Piece& piece, int vertex) {
    const auto found = std::ranges::find(piece.boundary, vertex);
    return found == piece.boundary.end()
               ? std::nullopt
               : std::optional(static_cast<int>(found - piece.boundary.begin()));
}

}  // namespace toile::app
