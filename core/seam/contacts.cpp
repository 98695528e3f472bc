// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/contacts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <Eigen/Geometry>

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/segment.h"

namespace toile::seam {
namespace {

// Layers on one line that are paired with each other; no garment has more.
constexpr std::size_t kMaxLayers = 8;

/// A boundary edge, identified by its positions in the source file.
struct FileEdge {
    std::array<int, 3> key;  ///< file, smaller and larger source position
    int edge;
    bool upwards;  ///< from the smaller to the larger position

    bool operator<(const FileEdge& other) const {
        return std::tie(key, edge, upwards) < std::tie(other.key, other.edge, other.upwards);
    }
};

std::vector<FileEdge> fileEdges(const Pieces& pieces, const Outlines& outlines) {
    std::vector<FileEdge> found;
    for (std::size_t o = 0; o < outlines.list.size(); ++o) {
        const Outline& outline = outlines.list[o];
        const Piece& piece = *pieces[outline.piece];
        const int n = outline.size();
        if (piece.sourceVertex.size() != static_cast<std::size_t>(piece.mesh.V.rows())) {
            continue;
        }
        for (int k = 0; k < n; ++k) {
            const int u = piece.sourceVertex[outline.vertices[k]];
            const int v = piece.sourceVertex[outline.vertices[(k + 1) % n]];
            if (u >= 0 && v >= 0 && u != v) {
                found.push_back({{piece.file, std::min(u, v), std::max(u, v)},
                                 outlines.firstEdge[o] + k,
                                 u < v});
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

std::vector<Contact> sharedContacts(const Pieces& pieces, const Outlines& outlines,
                                    std::vector<char>& settled) {
    const std::vector<FileEdge> edges = fileEdges(pieces, outlines);
    std::vector<Contact> contacts;
    for (std::size_t from = 0, to = 0; from < edges.size(); from = to) {
        while (to < edges.size() && edges[to].key == edges[from].key) {
            ++to;
        }
        for (std::size_t i = from; i < to && to - from > 1; ++i) {
            settled[edges[i].edge] = 1;
            for (std::size_t j = i + 1; j < std::min(to, i + 1 + kMaxLayers); ++j) {
                const bool parallel = edges[i].upwards == edges[j].upwards;
                const double la = outlines.lengthOf(edges[i].edge);
                const double lb = outlines.lengthOf(edges[j].edge);
                contacts.push_back({edges[i].edge, edges[j].edge, 0, la, parallel ? 0 : lb,
                                    parallel ? lb : 0, 0, 0, parallel, to - from == 2});
            }
        }
    }
    return contacts;
}

namespace {

// A seam's gap never exceeds this fraction of the garment's diagonal, however coarse the mesh.
constexpr double kGapOfGarment = 0.004;
// Cosine of the largest angle between edges that count as parallel: the turn at a tight curve.
constexpr double kSameLine = 0.5;
// Facing stretches shorter than this fraction of the shorter edge are end effects at corners.
constexpr double kMinOverlap = 0.01;
// Ends of a facing stretch this close to a vertex, relative to the edge, are snapped to it.
constexpr double kAtEnd = 1e-7;
// Below this fraction of the edge length two sides coincide, and their order is meaningless.
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
    s.from = outline.line.point(k);
    s.length = outlines.lengthOf(edge);
    s.along = (outline.line.point(k + 1).transpose() - s.from) / s.length;
    s.inward = outline.inward.row(k);
    s.spacing = outline.spacing[k];
    return s;
}

double snapped(double s, double length) {
    return s < kAtEnd * length ? 0 : s > (1 - kAtEnd) * length ? length : s;
}

/// True if the cloth itself lies between the two edges, as between two sides of a strip or a tip.
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
    if (high - low < kMinOverlap * std::min(a.length, b.length)) {
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
    std::vector<double> radius;  // of each edge; two radii add up to at most the tolerance
    for (const Outline& outline : outlines.list) {
        for (const double spacing : outline.spacing) {
            radius.push_back(std::min(0.5 * gap * spacing, most));
        }
    }
    NearbyEdges nearby = nearbyEdges(outlines, settled, radius);
    crowded = std::move(nearby.crowded);
    std::vector<Contact> contacts;
    for (const auto& [a, b] : nearby.pairs) {
        if (const auto contact = contactOf(outlines, a, b, gap)) {
            contacts.push_back(*contact);
        }
    }
    return contacts;
}

namespace {

// A contact whose gap is a local edge length weighs about this many times less.
constexpr double kGapePenalty = 100;

/// Two pieces, and the outline length that indicates equal winding (negative: opposite winding).
struct Balance {
    int left, right;
    double alike;
};

/// 1 if the cloth of both edges lies on the same side of them, as in layers; -1 if it lies on
/// opposite sides.
double sidesAgree(const Outlines& outlines, const Contact& c) {
    return outlines.of(c.a)
        .inward.row(outlines.local(c.a))
        .dot(outlines.of(c.b).inward.row(outlines.local(c.b)));
}

/// How strongly a contact indicates the winding of its pieces, in mm. Wider gaps weigh less.
/// Parallel edges with the cloth on the same side are stacked layers and weigh nothing; the cloth
/// of a piece wound against its neighbour lies on the opposite side.
double weightOf(const Outlines& outlines, const Contact& c) {
    const double gape = 0.5 * (c.gap0 + c.gap1) / outlines.of(c.a).spacing[outlines.local(c.a)];
    const double weight = (c.a1 - c.a0) / (1 + kGapePenalty * gape);
    return c.parallel ? weight * 0.5 * (1 - sidesAgree(outlines, c)) : weight;
}

std::vector<Balance> balances(const Outlines& outlines, const std::vector<Contact>& contacts) {
    std::map<std::pair<int, int>, double> sums;
    for (const Contact& c : contacts) {
        const std::pair<int, int> pieces{outlines.pieceOf(c.a), outlines.pieceOf(c.b)};
        if (pieces.first != pieces.second) {
            sums[pieces] += (c.parallel ? -1 : 1) * weightOf(outlines, c);
        }
    }
    std::vector<Balance> list;
    list.reserve(sums.size());
    for (const auto& [pieces, sum] : sums) {
        list.push_back({pieces.first, pieces.second, sum});
    }
    std::ranges::stable_sort(list, {}, [](const Balance& b) { return -std::abs(b.alike); });
    return list;
}

}  // namespace

void keepConsistentWinding(const Outlines& outlines, std::vector<Contact>& contacts) {
    // Each piece as wound (2p) and flipped (2p + 1): nodes in one set have consistent winding.
    geometry::DisjointSets sets(2 * static_cast<int>(outlines.list.size()));
    const auto areAlike = [&sets](int p, int q) { return sets.root(2 * p) == sets.root(2 * q); };
    const auto areAgainst = [&sets](int p, int q) {
        return sets.root(2 * p) == sets.root(2 * q + 1);
    };
    for (const Balance& b : balances(outlines, contacts)) {
        if (!areAlike(b.left, b.right) && !areAgainst(b.left, b.right)) {
            const int turn = b.alike < 0 ? 1 : 0;
            sets.join(2 * b.left, 2 * b.right + turn);
            sets.join(2 * b.left + 1, 2 * b.right + 1 - turn);
        }
    }
    std::erase_if(contacts, [&](const Contact& c) {
        return !c.certain && c.parallel != areAgainst(outlines.pieceOf(c.a), outlines.pieceOf(c.b));
    });
    std::ranges::sort(contacts, {}, [](const Contact& c) { return std::pair(c.a, c.b); });
}

namespace {

/// Seams that are known from shared or coincident vertices, so that proximity need not guess.
class KnownSeams {
public:
    KnownSeams(const Pieces& pieces, const Outlines& outlines)
        : pieces_(pieces),
          outlines_(outlines),
          groups_(static_cast<int>(pieces.size())),
          isWelded_(pieces.size(), 0) {}

    /// @param shared      contacts of edges that are identical in their file
    /// @param coincident  contacts of edges whose ends coincide
    void learn(const std::vector<Contact>& shared, const std::vector<Contact>& coincident) {
        for (const auto* contacts : {&shared, &coincident}) {
            for (const Contact& c : *contacts) {
                if (isOfCut(c)) {
                    groups_.join(outlines_.pieceOf(c.a), outlines_.pieceOf(c.b));
                }
            }
        }
        for (const auto* contacts : {&shared, &coincident}) {
            for (const Contact& c : *contacts) {
                const auto [a, b] = groupsOf(c);
                if (isOfCut(c) || contacts == &coincident) {
                    touching_.emplace(a, b);
                    continue;
                }
                welded_.emplace(a, b);
                if (a != b) {
                    isWelded_[a] = isWelded_[b] = 1;
                }
            }
        }
    }

    bool contradict(const Contact& c) {
        const auto [a, b] = groupsOf(c);
        return (isWelded_[a] && isWelded_[b]) || welded_.count({a, b}) > 0 ||
               (touching_.count({a, b}) > 0 && sidesAgree(outlines_, c) > 0);
    }

private:
    std::pair<int, int> groupsOf(const Contact& c) {
        const int a = groups_.root(outlines_.pieceOf(c.a));
        const int b = groups_.root(outlines_.pieceOf(c.b));
        return {std::min(a, b), std::max(a, b)};
    }

    bool isOfCut(const Contact& c) const {
        const auto isCutEdge = [this](int edge) {
            const int tail = outlines_.of(edge).vertices[outlines_.local(edge)];
            const EdgeOrigin* origin = originAt(pieces_[outlines_.pieceOf(edge)]->origins, tail);
            return origin && origin->cut;
        };
        return isCutEdge(c.a) && isCutEdge(c.b);
    }

    const Pieces& pieces_;
    const Outlines& outlines_;
    geometry::DisjointSets groups_;  ///< pieces that were one before they were cut
    std::vector<char> isWelded_;     ///< per group: welded to another group
    std::set<std::pair<int, int>> welded_, touching_;  ///< groups that have edges in common
};

}  // namespace

void dropContradicted(const Pieces& pieces, const Outlines& outlines,
                      const std::vector<Contact>& shared, std::vector<Contact>& near) {
    const auto coincides = [&outlines](const Contact& c) {
        return std::max(c.gap0, c.gap1) <= kCoincidentShare * outlines.size;
    };
    std::vector<Contact> coincident;
    for (const Contact& c : near) {
        const double lengthB = outlines.lengthOf(c.b);
        const bool isWhole = c.a0 == 0 && c.a1 == outlines.lengthOf(c.a) &&
                             std::min(c.b0, c.b1) == 0 && std::max(c.b0, c.b1) == lengthB;
        const bool isLayer = c.parallel && sidesAgree(outlines, c) > 0;
        if (coincides(c) && isWhole && !isLayer) {
            coincident.push_back(c);
        }
    }
    KnownSeams seams(pieces, outlines);
    seams.learn(shared, coincident);
    std::erase_if(near, [&](const Contact& c) { return !coincides(c) && seams.contradict(c); });
}

namespace {

// Cells with no more edges than this are paired without further splitting.
constexpr std::size_t kFewEdges = 16;
// Largest mean number of cells per edge: splitting a cell does not separate edges that lie along
// each other, or meet in one point.
constexpr double kMaxCopiesPerEdge = 16;
// More edges than this, inseparable, are a crowd: 64 corners in one point, or 128 layers.
constexpr std::size_t kCrowd = 128;
// Largest number of halvings of the garment's size: one part in 1e7.
constexpr int kMaxDepth = 24;
// Fraction of the garment's size that rounding may take from an edge's radius.
constexpr double kRounding = 1e-9;

struct Stretch {
    Eigen::Vector3d from, to;
    double radius;
};

struct Cell {
    Eigen::Vector3d low;
    double side;
    int depth = 0;
    double copies = 1;  ///< mean number of entries per edge so far

    Cell child(int octant, double copiesThere) const {
        const double half = 0.5 * side;
        const Eigen::Vector3d step(octant & 1, octant >> 1 & 1, octant >> 2);
        return {low + half * step, half, depth + 1, copiesThere};
    }

    /// Whether the edge comes within its radius of the cell, along each axis.
    bool isReachedBy(const Stretch& edge) const {
        const Eigen::Vector3d below = low.array() - edge.radius;
        const Eigen::Vector3d above = low.array() + side + edge.radius;
        const Eigen::Vector3d way = edge.to - edge.from;
        const geometry::ShareInBox share = geometry::shareInBox(edge.from, way, below, above);
        return share.first <= share.last;
    }
};

class PairSearch {
public:
    explicit PairSearch(std::vector<Stretch> stretches) : stretches_(std::move(stretches)) {}

    void search(const std::vector<int>& edges, const Cell& cell) {
        if (edges.size() <= kFewEdges) {
            pairAll(edges);
            return;
        }
        std::vector<unsigned char> octants(edges.size(), 0);  // bits of reached octants
        double entries = 0;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (int octant = 0; octant < 8; ++octant) {
                const bool reached = cell.child(octant, 0).isReachedBy(
                    stretches_[static_cast<std::size_t>(edges[i])]);
                octants[i] |= static_cast<unsigned char>(reached ? 1 << octant : 0);
            }
            entries += std::popcount(octants[i]);
        }
        const double copies = cell.copies * entries / static_cast<double>(edges.size());
        if (copies > kMaxCopiesPerEdge || cell.depth == kMaxDepth) {
            endAt(edges, cell);
            return;
        }
        std::vector<int> there;
        for (int octant = 0; octant < 8; ++octant) {
            there.clear();
            for (std::size_t i = 0; i < edges.size(); ++i) {
                if (octants[i] >> octant & 1) {
                    there.push_back(edges[i]);
                }
            }
            search(there, cell.child(octant, copies));
        }
    }

    NearbyEdges take() {
        sortOut();
        return std::move(found_);
    }

private:
    void endAt(const std::vector<int>& edges, const Cell& cell) {
        if (edges.size() <= kCrowd) {
            pairAll(edges);
        } else {
            found_.crowded.push_back({cell.low + Eigen::Vector3d::Constant(0.5 * cell.side),
                                      static_cast<int>(edges.size())});
        }
    }

    void pairAll(const std::vector<int>& edges) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t k = i + 1; k < edges.size(); ++k) {
                found_.pairs.emplace_back(edges[i], edges[k]);
            }
        }
        if (found_.pairs.size() > 2 * different_ + stretches_.size()) {
            sortOut();
        }
    }

    /// Removes duplicates: edges that lie along each other have many cells in common.
    void sortOut() {
        std::sort(found_.pairs.begin(), found_.pairs.end());
        found_.pairs.erase(std::unique(found_.pairs.begin(), found_.pairs.end()),
                           found_.pairs.end());
        different_ = found_.pairs.size();
    }

    std::vector<Stretch> stretches_;
    NearbyEdges found_;
    std::size_t different_ = 0;  ///< number of pairs after the last removal of duplicates
};

}  // namespace

NearbyEdges nearbyEdges(const Outlines& outlines, const std::vector<char>& skip,
                        const std::vector<double>& radius) {
    std::vector<Stretch> stretches;
    std::vector<int> edges;
    Eigen::AlignedBox3d box;
    for (int edge = 0; edge < outlines.edgeCount(); ++edge) {
        const Outline& outline = outlines.of(edge);
        const int k = outlines.local(edge);
        stretches.push_back({outline.line.point(k), outline.line.point(k + 1),
                             radius[edge] + kRounding * outlines.size});
        if (!skip[edge]) {
            edges.push_back(edge);
            box.extend(stretches.back().from).extend(stretches.back().to);
        }
    }
    if (edges.empty()) {
        return {};
    }
    // The nearest points of two edges lie between them, so within their box.
    PairSearch pairs(std::move(stretches));
    pairs.search(edges, {box.min(), box.sizes().maxCoeff()});
    return pairs.take();
}

}  // namespace toile::seam
