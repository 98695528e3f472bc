// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/conformal_interior.h"

#include <array>
#include <cstddef>
#include <utility>

#include "core/garment/piece.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/intrinsic_delaunay.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Faces of a mesh as a separate mesh. Vertices keep their order, so that sorted edges stay sorted.
struct Part {
    MeshArrays mesh;
    EdgeTable table;
    std::vector<int> vertex;  ///< vertex of the whole mesh, per vertex of the part
    std::vector<int> face;    ///< likewise
};

Part partAround(const MeshArrays& mesh, const std::vector<int>& faces, int rings) {
    std::vector<char> isIn(static_cast<std::size_t>(mesh.F.rows()), 0);
    for (const int f : faces) {
        isIn[f] = 1;
    }
    std::vector<int> local(static_cast<std::size_t>(mesh.V.rows()), -1);
    const auto touchVertices = [&] {
        for (int f = 0; f < mesh.F.rows(); ++f) {
            if (isIn[f] != 0) {
                local[mesh.F(f, 0)] = local[mesh.F(f, 1)] = local[mesh.F(f, 2)] = 0;
            }
        }
    };
    for (int ring = 0; ring < rings; ++ring) {
        touchVertices();
        for (int f = 0; f < mesh.F.rows(); ++f) {
            const bool isTouched =
                local[mesh.F(f, 0)] == 0 || local[mesh.F(f, 1)] == 0 || local[mesh.F(f, 2)] == 0;
            isIn[f] = isTouched ? 1 : 0;
        }
    }
    touchVertices();

    Part part;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (local[v] == 0) {
            local[v] = static_cast<int>(part.vertex.size());
            part.vertex.push_back(v);
        }
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
        if (isIn[f] != 0) {
            part.face.push_back(f);
        }
    }
    part.mesh.V = mesh.V(part.vertex, Eigen::all);
    part.mesh.F =
        mesh.F(part.face, Eigen::all).unaryExpr([&local](int v) -> int { return local[v]; });
    part.table = buildEdgeTable(part.mesh.F, static_cast<int>(part.vertex.size()));
    return part;
}

/// The rest of the mesh's weights without the part; edges used only by the part are removed.
WeightedEdges without(const Part& part, const EdgeTable& table, const Eigen::VectorXd& own) {
    std::vector<int> uses(static_cast<std::size_t>(table.edges.rows()), 0);
    Eigen::VectorXd weights = own;
    const Eigen::VectorXd inPart = cotangentWeights(part.mesh, part.table);
    for (std::size_t f = 0; f < part.face.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int e = table.faceEdges(part.face[f], k);
            if (uses[e]++ == 0) {
                weights[e] -= inPart[part.table.faceEdges(static_cast<Eigen::Index>(f), k)];
            }
        }
    }
    WeightedEdges rest{table.edges, std::move(weights)};
    Eigen::Index count = 0;
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (uses[e] < std::ssize(table.usesOf(e))) {
            rest.edges.row(count) = rest.edges.row(e);
            rest.weights[count++] = rest.weights[e];
        }
    }
    rest.edges.conservativeResize(count, 2);
    rest.weights.conservativeResize(count);
    return rest;
}

/// The sum of two sorted graphs.
WeightedEdges sum(const WeightedEdges& a, const WeightedEdges& b) {
    WeightedEdges both{Edges(a.edges.rows() + b.edges.rows(), 2),
                       Eigen::VectorXd(a.edges.rows() + b.edges.rows())};
    const auto ends = [](const WeightedEdges& graph, Eigen::Index e) {
        return std::array<int, 2>{graph.edges(e, 0), graph.edges(e, 1)};
    };
    Eigen::Index i = 0;
    Eigen::Index j = 0;
    Eigen::Index count = 0;
    while (i < a.edges.rows() || j < b.edges.rows()) {
        const bool takesA = j == b.edges.rows() || (i < a.edges.rows() && ends(a, i) <= ends(b, j));
        const bool takesB = i == a.edges.rows() || (j < b.edges.rows() && ends(b, j) <= ends(a, i));
        both.edges.row(count) = takesA ? a.edges.row(i) : b.edges.row(j);
        both.weights[count++] = (takesA ? a.weights[i] : 0) + (takesB ? b.weights[j] : 0);
        i += takesA ? 1 : 0;
        j += takesB ? 1 : 0;
    }
    both.edges.conservativeResize(count, 2);
    both.weights.conservativeResize(count);
    return both;
}

/// Rings of triangles around flipped ones that also get other weights. With three rings fewer
/// pieces become free of flips; with one or none more flips remain.
constexpr int kRings = 2;

/// The triangles counted by `flippedTriangles` (quality/measures.h).
std::vector<int> flippedIn(const Points2& Q, const Piece& piece) {
    const Eigen::VectorXd areas = triangleAreas2d(Q, piece.mesh.F);
    std::vector<int> flipped;
    for (int f = 0; f < areas.size(); ++f) {
        if (areas[f] <= 0) {
            flipped.push_back(f);
        }
    }
    return flipped;
}

/// True for errors that other weights may avoid.
bool isOfTheWeights(const Error& error) {
    return error.code == ErrorCode::NotFinite || error.code == ErrorCode::FactorisationFailed;
}

}  // namespace

Result<IntrinsicDelaunay> delaunayAround(const MeshArrays& mesh, const EdgeTable& table,
                                         const Eigen::VectorXd& own, const std::vector<int>& faces,
                                         int rings, const Progress& progress) {
    const Part part = partAround(mesh, faces, rings);
    auto turned = intrinsicDelaunay(part.mesh, part.table, progress);
    if (!turned) {
        return turned.error();
    }
    if (turned->flips == 0) {
        return IntrinsicDelaunay{{table.edges, own}};
    }
    turned->graph.edges =
        turned->graph.edges.unaryExpr([&part](int v) -> int { return part.vertex[v]; });
    turned->graph = sum(without(part, table, own), turned->graph);
    return turned;
}

Result<ConformalInterior> ConformalInterior::make(const Piece& piece, const Progress& progress) {
    ConformalInterior interior(piece);
    auto system =
        InteriorSystem::make({piece.table.edges, cotangentWeights(piece.mesh, piece.table)},
                             piece.mesh.V, piece.boundary, progress);
    if (!system && system.error().code == ErrorCode::FactorisationFailed) {
        auto other = interior.withDelaunayWeights({}, progress);
        if (!other && other.error().code == ErrorCode::FactorisationFailed) {
            return system.error();
        }
        return other;
    }
    if (!system) {
        return system.error();
    }
    interior.system_ = std::move(*system);
    return interior;
}

/// Changes weights around these faces; everywhere if `faces` is empty. Also fails if no edge has to
/// be flipped, because the weights would be the mesh's own.
Result<ConformalInterior> ConformalInterior::withDelaunayWeights(const std::vector<int>& faces,
                                                                 const Progress& progress) const {
    auto delaunay = faces.empty()
                        ? intrinsicDelaunay(piece_->mesh, piece_->table, progress)
                        : delaunayAround(piece_->mesh, piece_->table, system_.graph().weights,
                                         faces, kRings, progress);
    if (!delaunay) {
        return delaunay.error();
    }
    if (delaunay->flips == 0) {
        return Error{ErrorCode::FactorisationFailed, {}, "the mesh is Delaunay"};
    }
    auto system = InteriorSystem::make(std::move(delaunay->graph), piece_->mesh.V, piece_->boundary,
                                       progress);
    if (!system) {
        return system.error();
    }
    ConformalInterior interior(*piece_);
    interior.system_ = std::move(*system);
    interior.delaunayFlips_ = delaunay->flips;
    return interior;
}

Result<Eigen::MatrixXd> ConformalInterior::solve(const Eigen::MatrixXd& b,
                                                 const Progress& progress) {
    auto values = system_.solve(b);
    if (values || !isOfTheWeights(values.error()) || delaunayFlips_ > 0) {
        return values;
    }
    auto other = withDelaunayWeights({}, progress);
    if (!other) {
        return isOfTheWeights(other.error()) ? values.error() : other.error();
    }
    *this = std::move(*other);
    return system_.solve(b);
}

Result<Points2> ConformalInterior::place(const Points2& outline, const Progress& progress) {
    auto extended = system_.extend(outline);
    if (delaunayFlips_ > 0 || (!extended && !isOfTheWeights(extended.error()))) {
        return extended;
    }
    const std::vector<int> flipped = extended ? flippedIn(*extended, *piece_) : std::vector<int>();
    if (extended && flipped.empty()) {
        return extended;
    }
    auto other = withDelaunayWeights(flipped, progress);
    if (!other) {
        return other.error().code == ErrorCode::Cancelled ? other.error() : extended;
    }
    auto better = other->system_.extend(outline);
    if (better && (!extended || flippedIn(*better, *piece_).size() < flipped.size())) {
        *this = std::move(*other);
        return better;
    }
    return extended;
}

}  // namespace toile
