// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prove/rest_pattern.h"

// For the sources of this folder only.
namespace toile::prove {

/// The points along one loop while they are placed. Numbers are those of the points as they were
/// made, until `putInOrder`.
class LoopStations {
public:
    /// Of the edge: nearer to each other two points are one.
    static constexpr double kOnePoint = 0.2;
    /// Of the edge: nearer to another no vertex becomes a point.
    static constexpr double kCrowded = 0.5;

    /// @param edge  mm between points, about  Keeps a reference to the loop
    LoopStations(const RestLoop& loop, double edge) : loop_(loop), edge_(edge) {}

    const RestLoop& loop() const { return loop_; }
    const std::vector<double>& places() const { return places_; }

    /// A side of a seam ends there.
    void addEnd(double place) { ends_.push_back(place); }
    /// The number of the point at a place, there already or new.
    int at(double place);
    /// A side whose points are all sewn: no others come between them.
    void cover(const SeamSide& side);
    /// Whether a place is strictly within a side that is covered.
    bool isCovered(double place) const;

    /// Of a side's inside, as it counts places: points that are there, corners and ends of others.
    std::vector<double> neededWithin(const SeamSide& side) const;
    /// The garment's vertices there.
    std::vector<double> verticesWithin(const SeamSide& side) const;

    /// Evenly, with corners, ends and, if asked for, vertices; three points at least.
    void fill(bool atVertices);
    /// Sorts the places. @return per point its new number
    std::vector<int> putInOrder();

private:
    double apart(double a, double b) const;
    std::vector<double> within(const std::vector<double>& places, const SeamSide& side) const;

    struct Range {
        double low, high;
    };

    const RestLoop& loop_;
    double edge_;
    std::vector<double> places_, ends_;
    std::vector<Range> covered_;
};

}  // namespace toile::prove
