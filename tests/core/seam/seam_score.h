// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/garment/piece.h"
#include "core/garment/seam.h"

namespace toile::test {

/// A known sewn line: a stretch of one outline and the stretch that lies on it. Places are arc
/// lengths, b0 faces a0; signed differences give the direction on either outline.
struct SewnLine {
    int pieceA = 0;
    double a0 = 0, a1 = 0;
    int pieceB = 0;
    double b0 = 0, b1 = 0;
};

/// Arc length of each boundary vertex of a piece by its index in the file; -1 where it is none.
class BoundaryPlaces {
public:
    explicit BoundaryPlaces(const Pieces& pieces);

    double arcOf(int piece, int sourceVertex) const;
    double length(int piece) const { return lengths_[piece]; }
    /// The signed shortest path from one place to another.
    double way(int piece, double from, double to) const;

private:
    std::vector<std::vector<std::pair<int, double>>> arcs_;  ///< sorted by source vertex
    std::vector<double> lengths_;
};

/// How well a graph agrees with known sewn lines, by length in mm.
struct SeamScore {
    double known = 0;        ///< length of the known lines
    double found = 0;        ///< of them, the length that the graph has, with the right partner
    double placesKnown = 0;  ///< length of outline that is sewn to anything
    double placesFound = 0;  ///< of it, the length for which the graph knows a right partner
    double claimed = 0;      ///< length of the graph's seams
    double right = 0;        ///< of it, the length that is known
    double layered = 0;  ///< of it, the length whose sides are sewn by way of a layer between them
    std::vector<std::string> byLayer;  ///< seams of which less than half is right, but layered
    std::vector<std::string> wrong;    ///< seams of which less than half is right or layered

    double recall() const { return found / known; }
    double placeRecall() const { return placesFound / placesKnown; }
    double precision() const { return right / claimed; }
    double layeredPrecision() const { return (right + layered) / claimed; }
};

/// @param tolerance  how far along the outline a partner may be off, mm
SeamScore score(const SeamGraph& graph, const std::vector<SewnLine>& known,
                const BoundaryPlaces& places, double tolerance);

}  // namespace toile::test
