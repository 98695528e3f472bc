// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/mesh_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "core/assemble/corner_uv.h"
#include "core/base/statistics.h"
#include "core/cut/surface_paths.h"
#include "core/geometry/buckets.h"

namespace toile {
namespace {

constexpr double kStraight = 0.9, kSameLength = 0.12;
/// Lines with fewer edges are weak evidence.
constexpr int kFewEdges = 3;
constexpr double kFewFactor = 0.3;
/// Relative spread of edge lengths at which a line counts half.
constexpr double kEvenSpread = 0.03;
constexpr double kUsualQuantile = 0.9;
/// Worth of a flat line, and the limit of a bend in `bendsOf`.
constexpr double kFlatWorth = 0.3;
constexpr double kMaxBends = 3;
/// Bends below this, radians, count as rounding in the mesh's medians.
constexpr double kMinFold = 0.01, kMinDefect = 1e-3;
/// Likeliness of file borders: authors of meshes rarely put them where no seam is.
constexpr double kBorder = 0.95;
/// From this number of medians a bend counts.
constexpr double kUnusual = 3;
/// Factor from the median of |x| to the standard deviation of x, for a normal distribution.
constexpr double kToDeviation = 1.48;

/// Finds the edges that continue each other.
class Continuations {
public:
    explicit Continuations(const SurfaceLinks& links)
        : links_(links),
          lengths_(edgeLengths(links.mesh(), links.table().edges)),
          next_(static_cast<std::size_t>(links.edgeCount()), {-1, -1}) {
        const Edges& edges = links.table().edges;
        const geometry::Buckets<> edgesAt(links.vertexCount(), [&edges](const auto& add) {
            for (int e = 0; e < edges.rows(); ++e) {
                add(edges(e, 0), e);
                add(edges(e, 1), e);
            }
        });
        for (int v = 0; v < links.vertexCount(); ++v) {
            if (links.isInner(v)) {
                linkAround(v, edgesAt[v]);
            }
        }
    }

    /// The edge that continues this one beyond its first (0) or second (1) end, or -1.
    int next(int edge, int end) const { return next_[edge][end]; }

    int endAt(int edge, int vertex) const {
        return links_.table().edges(edge, 0) == vertex ? 0 : 1;
    }

    double length(int edge) const { return lengths_[edge]; }

private:
    Eigen::Vector3d away(int edge, int vertex) const {
        const auto ends = links_.table().edges.row(edge);
        const int other = ends[0] == vertex ? ends[1] : ends[0];
        return (links_.mesh().V.row(other) - links_.mesh().V.row(vertex)).transpose();
    }

    /// The straightest continuation of an edge at one of its ends, or -1.
    int best(int edge, int vertex, std::span<const int> around) const {
        const Eigen::Vector3d from = -away(edge, vertex);
        int found = -1;
        double most = kStraight;
        for (const int other : around) {
            const double length = lengths_[other], longer = std::max(length, lengths_[edge]);
            if (other == edge || std::abs(length - lengths_[edge]) > kSameLength * longer) {
                continue;
            }
            const double cosine = from.dot(away(other, vertex)) / (lengths_[edge] * length);
            if (cosine > most) {
                most = cosine;
                found = other;
            }
        }
        return found;
    }

    void linkAround(int vertex, std::span<const int> around) {
        for (const int edge : around) {
            const int other = best(edge, vertex, around);
            if (other >= 0 && best(other, vertex, around) == edge) {
                next_[edge][endAt(edge, vertex)] = other;
            }
        }
    }

    const SurfaceLinks& links_;
    std::vector<double> lengths_;
    std::vector<std::array<int, 2>> next_;
};

/// Bend of the surface per edge: its dihedral angle and the angle defect at its ends, each in units
/// of three times the mesh's own.
std::vector<double> bendsOf(const SurfaceLinks& links) {
    std::vector<double> defect(static_cast<std::size_t>(links.vertexCount()), 0), some;
    for (int v = 0; v < links.vertexCount(); ++v) {
        if (links.isInner(v)) {
            defect[v] = std::abs(2 * std::numbers::pi - links.angleAround(v));
            some.push_back(defect[v]);
        }
    }
    const double deviation = std::max(kToDeviation * quantileOf(some, 0.5), kMinDefect);
    some.clear();
    std::vector<double> fold(static_cast<std::size_t>(links.edgeCount()), 0);
    for (int e = 0; e < links.edgeCount(); ++e) {
        fold[e] = links.foldAngle(e);
        some.push_back(fold[e]);
    }
    const double usualFold = std::max(quantileOf(some, 0.5), kMinFold);
    const auto bend = [](double value, double usual) {
        return std::min(value / (kUnusual * usual), kMaxBends);
    };
    for (int e = 0; e < links.edgeCount(); ++e) {
        const auto ends = links.table().edges.row(e);
        fold[e] = bend(fold[e], usualFold) +
                  (bend(defect[ends[0]], deviation) + bend(defect[ends[1]], deviation)) / 2;
    }
    return fold;
}

struct Line {
    std::vector<int> edges, way;
    double bend = 0;    ///< mean
    double spread = 0;  ///< of the lengths, as a fraction of their mean
};

/// Builds lines by following continuations both ways from their lowest edge.
std::vector<Line> linesOf(const Continuations& continuations, const SurfaceLinks& links,
                          std::vector<int>& lineOf) {
    std::vector<Line> lines;
    lineOf.assign(static_cast<std::size_t>(links.edgeCount()), -1);
    for (int first = 0; first < links.edgeCount(); ++first) {
        if (lineOf[first] >= 0) {
            continue;
        }
        Line& line = lines.emplace_back();
        const int number = static_cast<int>(lines.size()) - 1;
        line.edges.push_back(first);
        lineOf[first] = number;
        for (const int forth : {0, 1}) {
            int edge = first, end = forth;
            std::vector<int> way{links.table().edges(edge, end)};
            while (true) {
                edge = continuations.next(edge, end);
                if (edge < 0 || lineOf[edge] >= 0) {
                    break;
                }
                lineOf[edge] = number;
                line.edges.push_back(edge);
                end = 1 - continuations.endAt(edge, way.back());
                way.push_back(links.table().edges(edge, end));
            }
            if (forth == 0) {
                std::ranges::reverse(way);
            }
            line.way.insert(line.way.end(), way.begin(), way.end());
        }
    }
    return lines;
}

void measureLine(Line& line, const Continuations& continuations, const std::vector<double>& bends) {
    const auto count = static_cast<double>(line.edges.size());
    double sum = 0, squares = 0;
    for (const int edge : line.edges) {
        const double length = continuations.length(edge);
        sum += length;
        squares += length * length;
        line.bend += bends[edge] / count;
    }
    const double mean = sum / count;
    line.spread = mean > 0 ? std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean : 0;
}

double likelinessOf(const Line& line, double usual) {
    const double uneven = line.spread / kEvenSpread;
    const double worth = static_cast<double>(line.edges.size()) / usual * (kFlatWorth + line.bend) *
                         2 / (1 + uneven * uneven);
    return worth / (1 + worth) *
           (line.edges.size() < static_cast<std::size_t>(kFewEdges) ? kFewFactor : 1);
}

}  // namespace

void MeshLines::addSure(const std::vector<char>& isSeam) {
    sure = static_cast<int>(ways.size());
    for (std::size_t e = 0; e < isSeam.size(); ++e) {
        lineOf[e] = isSeam[e] != 0 ? sure : lineOf[e];
    }
    ways.emplace_back();
    likeliness.push_back(1);
}

void MeshLines::addBorders(const SurfaceLinks& links, const std::vector<char>& isBorder) {
    firstBorder = static_cast<int>(ways.size());
    const Edges& edges = links.table().edges;
    const geometry::Buckets<> bordersAt(links.vertexCount(), [&](const auto& add) {
        for (int e = 0; e < links.edgeCount(); ++e) {
            if (isBorder[static_cast<std::size_t>(e)] != 0) {
                add(edges(e, 0), e);
                add(edges(e, 1), e);
            }
        }
    });
    const auto follow = [&](int vertex, int edge) {
        std::vector<int> way{vertex};
        while (edge >= 0 && lineOf[edge] < firstBorder) {
            lineOf[edge] = static_cast<int>(ways.size());
            way.push_back(edges(edge, edges(edge, 0) == way.back() ? 1 : 0));
            const std::span<const int> there = bordersAt[way.back()];
            edge = there.size() == 2 ? (there[0] == edge ? there[1] : there[0]) : -1;
        }
        ways.push_back(std::move(way));
        likeliness.push_back(kBorder);
    };
    for (const bool fromEnds : {true, false}) {  // the rest is closed
        for (int e = 0; e < links.edgeCount(); ++e) {
            for (int side = 0; side < 2 && isBorder[static_cast<std::size_t>(e)] != 0; ++side) {
                if (lineOf[e] < firstBorder &&
                    (!fromEnds || bordersAt[edges(e, side)].size() != 2)) {
                    follow(edges(e, side), e);
                }
            }
        }
    }
}

MeshLines findMeshLines(const SurfaceLinks& links) {
    const Continuations continuations(links);
    const std::vector<double> bends = bendsOf(links);
    MeshLines found;
    std::vector<Line> lines = linesOf(continuations, links, found.lineOf);
    std::vector<double> counts;
    for (Line& line : lines) {
        measureLine(line, continuations, bends);
        counts.insert(counts.end(), line.edges.size(), static_cast<double>(line.edges.size()));
        found.ways.push_back(std::move(line.way));
    }
    const double usual = std::max<double>(kFewEdges, quantileOf(counts, kUsualQuantile));
    found.usual = static_cast<int>(usual);
    for (const Line& line : lines) {
        found.likeliness.push_back(likelinessOf(line, usual));
    }
    return found;
}

}  // namespace toile

namespace toile::tailor {
namespace {

/// The vertex of each vertex of an opened mesh before its two sides were separated.
std::vector<int> closedAgain(const CutResult& cut, int sourceCount) {
    std::map<std::array<double, 4>, int> known;
    std::vector<int> closed;
    for (std::size_t v = 0; v < cut.place.size(); ++v) {
        int vertex = cut.sourceVertex[v];
        if (vertex < 0) {
            const SurfacePoint& at = cut.place[v];
            const int next = sourceCount + static_cast<int>(known.size());
            vertex = known
                         .try_emplace({static_cast<double>(at.face), at.barycentric[0],
                                       at.barycentric[1], at.barycentric[2]},
                                      next)
                         .first->second;
        }
        closed.push_back(vertex);
    }
    return closed;
}

}  // namespace

std::vector<char> MarkedMesh::marks() const {
    std::vector<char> marked(static_cast<std::size_t>(table.edges.rows()), 0);
    for (const std::vector<int>& way : ways) {
        for (std::size_t k = 1; k < way.size(); ++k) {
            marked[findEdge(table.edges, way[k - 1], way[k])] = 1;
        }
    }
    return marked;
}

std::set<int> MarkedMesh::vertices() const {
    std::set<int> all;
    for (const std::vector<int>& way : ways) {
        all.insert(way.begin(), way.end());
    }
    return all;
}

MarkedMesh markedMesh(const MeshArrays& mesh, const EdgeTable& table,
                      const std::vector<UserCut>& cuts, const Progress& progress) {
    MarkedMesh made{mesh, table, {}};
    if (cuts.empty()) {
        return made;
    }
    const SurfaceLinks links(mesh, table);
    const NearestSurface nearest(mesh);
    std::vector<PathPolyline> paths;
    for (const UserCut& cut : cuts) {
        if (auto path = traceUserCut(links, nearest, cut, progress)) {
            paths.push_back(std::move(*path));
        }
        if (progress.isCancelled()) {
            return made;
        }
    }
    const auto cut = cutAlong(mesh, paths, {.leavesOut = true}, progress);
    if (!cut) {
        return made;
    }
    const std::vector<int> closed = closedAgain(*cut, static_cast<int>(mesh.V.rows()));
    made.mesh.F = cut->mesh.F.unaryExpr([&closed](int v) { return closed[v]; });
    made.mesh.V.resize(*std::ranges::max_element(closed) + 1, 3);
    for (std::size_t v = 0; v < closed.size(); ++v) {
        made.mesh.V.row(closed[v]) = cut->mesh.V.row(static_cast<Eigen::Index>(v));
    }
    made.table = buildEdgeTable(made.mesh.F, static_cast<int>(made.mesh.V.rows()));
    for (const OpenedCut& opened : cut->cuts) {
        for (const CutRun& run : opened.runs) {
            std::vector<int>& way = made.ways.emplace_back();
            for (const int v : run.left) {
                way.push_back(closed[v]);
            }
        }
    }
    return made;
}

}  // namespace toile::tailor

namespace toile {
namespace {

/// Largest share of borders among the edges inside a piece. More are no seams.
constexpr double kMaxFileBorders = 0.2;

bool differs(const std::vector<int>& ofFace, int f, int g) {
    return !ofFace.empty() &&
           ofFace[static_cast<std::size_t>(f)] != ofFace[static_cast<std::size_t>(g)];
}

}  // namespace

std::vector<char> fileBorders(const Piece& piece, const PolygonSoup& soup) {
    const Edges& edges = piece.table.edges;
    std::vector<char> isBorder(static_cast<std::size_t>(edges.rows()), 0);
    CornerUvs uvs(soup);
    Eigen::Index inner = 0, borders = 0;
    for (Eigen::Index e = 0; e < edges.rows(); ++e) {
        const auto uses = piece.table.usesOf(e);
        if (uses.size() != 2) {
            continue;
        }
        ++inner;
        const int f = piece.sourceFace[static_cast<std::size_t>(uses[0] / 3)];
        const int g = piece.sourceFace[static_cast<std::size_t>(uses[1] / 3)];
        bool isOther = f != g && f >= 0 && g >= 0 &&
                       (differs(soup.faceMaterial, f, g) || differs(soup.faceGroup, f, g) ||
                        differs(soup.faceObject, f, g));
        for (int k = 0; k < 2 && !isOther && f != g && f >= 0 && g >= 0; ++k) {
            const int position = piece.sourceVertex[static_cast<std::size_t>(edges(e, k))];
            isOther = position >= 0 && uvs.at(f, position) != uvs.at(g, position);
        }
        isBorder[static_cast<std::size_t>(e)] = isOther ? 1 : 0;
        borders += isOther ? 1 : 0;
    }
    return borders > 0 &&
                   static_cast<double>(borders) < kMaxFileBorders * static_cast<double>(inner)
               ? isBorder
               : std::vector<char>{};
}

}  // namespace toile
