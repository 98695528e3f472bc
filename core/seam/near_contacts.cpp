// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "core/seam/contacts.h"

namespace toile {
namespace {

// A seam is never wider than this part of the garment's diagonal, however coarse the mesh.
constexpr double kGapOfGarment = 0.004;
// Cosine between two edges that still count as one line: the turn of one edge on a tight curve.
constexpr double kSameLine = 0.5;
// Facing stretches below this part of the shorter edge are end effects of a polyline's corners.
constexpr double kLeastOverlap = 0.01;
// Ends of a facing stretch this near to a vertex, relative to the edge, are the vertex.
constexpr double kAtVertex = 1e-7;
// Below this fraction of the edge length two sides coincide, and which side is which says nothing.
constexpr double kTouching = 1e-3;

struct Segment {
    Eigen::Vector3d from, along;  ///< along is a unit vector
    Eigen::Vector3d inward;
    double length, spacing;
    Eigen::Vector3d at(double s) const { return from + s * along; }
};

Segment segmentOf(const Outlines& outlines, int edge) {
    const Outline& outline = outlines.of(edge);
    const int k = outlines.local(edge);
    Segment s;
    s.from = outline.P.row(k);
    s.length = outline.arc[k + 1] - outline.arc[k];
    s.along = (outline.P.row((k + 1) % outline.size()).transpose() - s.from) / s.length;
    s.inward = outline.inward.row(k);
    s.spacing = outline.spacing[k];
    return s;
}

double snapped(double s, double length) {
    return s < kAtVertex * length ? 0 : s > (1 - kAtVertex) * length ? length : s;
}

/// True where the cloth itself lies between the two edges: the two sides of a strip or a tip.
bool acrossTheCloth(const Segment& a, const Segment& b, const Eigen::Vector3d& gap) {
    const double width = gap.norm();
    return width > kTouching * a.spacing && gap.dot(a.inward) > 0.5 * width &&
           gap.dot(b.inward) < -0.5 * width;
}

std::optional<Contact> contactOf(const Outlines& outlines, int ea, int eb, double tolerance) {
    const Segment a = segmentOf(outlines, ea), b = segmentOf(outlines, eb);
    const bool samePiece = outlines.pieceOf(ea) == outlines.pieceOf(eb);
    const double cosine = a.along.dot(b.along);
    const bool parallel = cosine > 0;
    if (std::abs(cosine) < kSameLine || (parallel && samePiece)) {
        return {};
    }
    // Both edges are measured along the line between their directions.
    const double sign = parallel ? 1 : -1;
    const Eigen::Vector3d line = (a.along + sign * b.along).normalized();
    const double slopeA = a.along.dot(line), slopeB = b.along.dot(line);
    const double offset = (b.from - a.from).dot(line);
    const double endA = slopeA * a.length, endB = offset + slopeB * b.length;
    const double low = std::max(0.0, std::min(offset, endB));
    const double high = std::min(endA, std::max(offset, endB));
    if (high - low < kLeastOverlap * std::min(a.length, b.length)) {
        return {};
    }
    Contact c{.a = ea, .b = eb};
    c.a0 = snapped(low / slopeA, a.length);
    c.a1 = snapped(high / slopeA, a.length);
    c.b0 = snapped((low - offset) / slopeB, b.length);
    c.b1 = snapped((high - offset) / slopeB, b.length);
    const Eigen::Vector3d gap0 = b.at(c.b0) - a.at(c.a0), gap1 = b.at(c.b1) - a.at(c.a1);
    c.gap0 = gap0.norm();
    c.gap1 = gap1.norm();
    c.parallel = parallel;
    const double allowed = tolerance * 0.5 * (a.spacing + b.spacing);
    if (0.5 * (c.gap0 + c.gap1) > std::min(allowed, kGapOfGarment * outlines.size) ||
        (samePiece && acrossTheCloth(a, b, 0.5 * (gap0 + gap1)))) {
        return {};
    }
    return c;
}

}  // namespace

std::vector<Contact> nearContacts(const Outlines& outlines, double gap,
                                  const std::vector<char>& settled,
                                  std::vector<CrowdedPlace>& crowded) {
    const double most = kGapOfGarment * outlines.size;
    std::vector<double> reach;  // so that two edges together reach as far as their tolerance
    for (const Outline& outline : outlines.list) {
        for (const double spacing : outline.spacing) {
            reach.push_back(std::min(0.5 * gap * spacing, most));
        }
    }
    NearbyEdges nearby = nearbyEdges(outlines, settled, reach);
    crowded = std::move(nearby.crowded);
    std::vector<Contact> contacts;
    for (const auto& [a, b] : nearby.pairs) {
        if (const auto contact = contactOf(outlines, a, b, gap)) {
            contacts.push_back(*contact);
        }
    }
    return contacts;
}

}  // namespace toile
