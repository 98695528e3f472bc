// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/seam/seam_score.h"

#include <algorithm>
#include <cmath>

namespace toile::test {
namespace {

constexpr double kStep = 1;  // mm between the places that are compared

struct Place {
    int piece;
    double s;
};

using Partners = std::vector<Place>;

/// Lines in both directions, by the piece that they start from.
class Lookup {
public:
    Lookup(const std::vector<SewnLine>& lines, const BoundaryPlaces& places, std::size_t pieces)
        : places_(places), of_(pieces) {
        for (const SewnLine& l : lines) {
            of_[l.pieceA].push_back(l);
            of_[l.pieceB].push_back({l.pieceB, l.b0, l.b1, l.pieceA, l.a0, l.a1});
        }
    }

    Partners partners(const Place& at, double slack) const {
        Partners found;
        for (const SewnLine& l : of_[at.piece]) {
            const double length = l.a1 - l.a0;
            const double along = places_.way(at.piece, 0.5 * (l.a0 + l.a1), at.s) + 0.5 * length;
            const double t = length != 0 ? along / length : 0.5;
            if (t >= -slack / std::abs(length) && t <= 1 + slack / std::abs(length)) {
                found.push_back({l.pieceB, l.b0 + std::clamp(t, 0.0, 1.0) * (l.b1 - l.b0)});
            }
        }
        return found;
    }

private:
    const BoundaryPlaces& places_;
    std::vector<std::vector<SewnLine>> of_;
};

std::vector<SewnLine> linesOf(const Seam& seam) {
    std::vector<SewnLine> lines;
    for (std::size_t k = 1; k < seam.matches.size(); ++k) {
        const SeamMatch &p = seam.matches[k - 1], &q = seam.matches[k];
        lines.push_back({seam.left.piece, p.left, q.left, seam.right.piece, p.right, q.right});
    }
    return lines;
}

template <class Visit>
void along(const SewnLine& line, const Visit& visit) {
    const double length = std::abs(line.a1 - line.a0);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep)));
    for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        visit(Place{line.pieceA, line.a0 + t * (line.a1 - line.a0)},
              Place{line.pieceB, line.b0 + t * (line.b1 - line.b0)}, length / steps);
    }
}

}  // namespace

BoundaryPlaces::BoundaryPlaces(const Pieces& pieces) {
    for (const auto& piece : pieces) {
        double arc = 0;
        auto& arcs = arcs_.emplace_back();
        const std::size_t n = piece->boundary.size();
        for (std::size_t k = 0; k < n; ++k) {
            const int u = piece->boundary[k], v = piece->boundary[(k + 1) % n];
            arcs.emplace_back(piece->sourceVertex[u], arc);
            arc += (piece->mesh.V.row(v) - piece->mesh.V.row(u)).norm();
        }
        std::sort(arcs.begin(), arcs.end());
        lengths_.push_back(arc);
    }
}

double BoundaryPlaces::arcOf(int piece, int sourceVertex) const {
    const auto& arcs = arcs_[piece];
    const auto at = std::lower_bound(arcs.begin(), arcs.end(), std::pair(sourceVertex, -1.0));
    return at != arcs.end() && at->first == sourceVertex ? at->second : -1;
}

double BoundaryPlaces::way(int piece, double from, double to) const {
    return std::remainder(to - from, lengths_[piece]);
}

SeamScore score(const SeamGraph& graph, const std::vector<SewnLine>& known,
                const BoundaryPlaces& places, double tolerance) {
    std::vector<SewnLine> lines;
    for (const Seam& seam : graph.seams) {
        const auto of = linesOf(seam);
        lines.insert(lines.end(), of.begin(), of.end());
    }
    const std::size_t pieces = graph.seamsOfEdge.size();
    const Lookup truth(known, places, pieces), answer(lines, places, pieces);
    const auto among = [&](const Partners& partners, const Place& q) {
        return std::any_of(partners.begin(), partners.end(), [&](const Place& p) {
            return p.piece == q.piece && std::abs(places.way(p.piece, p.s, q.s)) < tolerance;
        });
    };
    SeamScore sum;
    for (const SewnLine& line : known) {
        along(line, [&](const Place& p, const Place& q, double length) {
            sum.known += length;
            sum.found += among(answer.partners(p, 0.5), q) ? length : 0;
        });
    }
    for (std::size_t p = 0; p < pieces; ++p) {
        const double length = places.length(static_cast<int>(p));
        along({static_cast<int>(p), 0, length, static_cast<int>(p), 0, 0},
              [&](const Place& at, const Place&, double step) {
                  const Partners wanted = truth.partners(at, 0);
                  const Partners got = answer.partners(at, 0.5);
                  sum.placesKnown += wanted.empty() ? 0 : step;
                  const bool hit = std::any_of(got.begin(), got.end(),
                                               [&](const Place& q) { return among(wanted, q); });
                  sum.placesFound += hit ? step : 0;
              });
    }
    for (const Seam& seam : graph.seams) {
        double right = 0, layered = 0;
        for (const SewnLine& line : linesOf(seam)) {
            along(line, [&](const Place& p, const Place& q, double length) {
                sum.claimed += length;
                const Partners direct = truth.partners(p, tolerance);
                if (among(direct, q)) {
                    right += length;
                    return;
                }
                Partners reached = direct;  // one to three layers further
                for (std::size_t from = 0, depth = 0; depth < 3; ++depth) {
                    const std::size_t to = reached.size();
                    for (; from < to; ++from) {
                        const Partners more = truth.partners(reached[from], tolerance);
                        reached.insert(reached.end(), more.begin(), more.end());
                    }
                }
                if (among(reached, q)) {
                    layered += length;
                }
            });
        }
        sum.right += right;
        sum.layered += layered;
        const double half = 0.5 * seam.length3d[0];
        if (seam.kind != SeamKind::Free && right < half) {
            (right + layered < half ? sum.wrong : sum.byLayer)
                .push_back(seam.name + " (" + std::to_string(seam.length3d[0]) + " mm)");
        }
    }
    return sum;
}

}  // namespace toile::test
