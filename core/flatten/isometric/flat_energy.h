// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/piece_cloth.h"
#include "core/linalg/block_matrix.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

// For the sources of this folder only.
namespace toile::isometric {

/// The roots of a t² + b t + c, without cancellation. NaN if there are none; if there is only one,
/// the other is infinite or NaN.
inline std::array<double, 2> quadraticRoots(double a, double b, double c) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
    return {q / a, c / q};
}

/// An energy of a flattening that the isometric descent lowers: a sum over the triangles of area,
/// divided by the total area, times a density of the map J from the triangle's shape in 3D to the
/// plane. It is 1 if isometric and infinite if a triangle has no area or is flipped. Strain e in
/// both directions costs about 2 e^2 (`isNear`). Mesh and Q have the same unit. Each virtual call
/// covers a mesh or the triangles at a vertex. Immutable; linear cost throughout.
class FlatEnergy {
public:
    virtual ~FlatEnergy() = default;

    virtual double energy(const Points2& Q) const = 0;
    /// Derivative by every coordinate, #V x 2. Precondition: the energy is finite.
    virtual Points2 gradient(const Points2& Q) const = 0;
    /// Adds the Hessian, made positive semidefinite per triangle.
    /// @param edgeOf  number of each mesh edge in the matrix's pattern
    virtual void addHessian(const Points2& Q, const std::vector<int>& edgeOf,
                            linalg::BlockMatrix& hessian) const = 0;

    /// The largest step up to `limit` along P before the first triangle loses its area.
    double largestStep(const Points2& Q, const Points2& P, double limit) const;

    /// Moves single vertices, with the others fixed, to lower the strain of their own triangles,
    /// while a move lowers a vertex's part of the energy noticeably. Resolves local distortion that
    /// would otherwise shorten a step of the whole piece. No triangle flips.
    /// @param held  vertices that must stay  @param passes  maximum number
    /// @param progress  only checked for cancellation; then fewer vertices are moved
    void relax(Points2& Q, const std::vector<int>& held, int passes,
               const Progress& progress) const;

protected:
    using Matrix4 = Eigen::Matrix<double, 4, 4>;

    /// A triangle's shape in 3D: area, and derivatives of the three hat functions in its plane. The
    /// plane's x axis runs from the first corner to the second.
    struct Shape {
        double area;
        double b[3][2];
    };

    /// The energy of a vertex's triangles as a function of its position, to second order.
    struct VertexModel {
        double energy = 0;
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
    };

    /// Precondition: no degenerate triangles. Keeps references to both.
    FlatEnergy(const MeshArrays& mesh, const EdgeTable& table);

    /// @param star  the triangles at the vertex
    virtual double starEnergy(const Points2& Q, std::span<const int> star) const = 0;
    virtual VertexModel vertexModel(const Points2& Q, std::span<const int> star, int v) const = 0;

    Eigen::Matrix2d jacobian(const Points2& Q, int f) const {
        const Shape& shape = shapes_[f];
        // Differences to the first corner keep the precision of a piece far from the origin.
        const Eigen::RowVector2d e1 = Q.row(mesh_.F(f, 1)) - Q.row(mesh_.F(f, 0));
        const Eigen::RowVector2d e2 = Q.row(mesh_.F(f, 2)) - Q.row(mesh_.F(f, 0));
        Eigen::Matrix2d J;
        for (int axis = 0; axis < 2; ++axis) {
            J(axis, 0) = e1[axis] * shape.b[1][0] + e2[axis] * shape.b[2][0];
            J(axis, 1) = e1[axis] * shape.b[1][1] + e2[axis] * shape.b[2][1];
        }
        return J;
    }

    /// Adds a triangle's part of the gradient. @param P  its derivative by J
    void addForces(int f, const Eigen::Matrix2d& P, Points2& g) const {
        for (int k = 0; k < 3; ++k) {
            const double* b = shapes_[f].b[k];
            g(mesh_.F(f, k), 0) += P(0, 0) * b[0] + P(0, 1) * b[1];
            g(mesh_.F(f, k), 1) += P(1, 0) * b[0] + P(1, 1) * b[1];
        }
    }

    /// Adds a triangle's part of the Hessian. @param H  its second derivative by J's entries, row
    /// by row
    void addBlocks(int f, const Matrix4& H, const std::vector<int>& edgeOf,
                   linalg::BlockMatrix& hessian) const {
        // Corner k moves J by q b_k^T: columns of B_k pair the axis with b_k.
        Eigen::Matrix<double, 4, 2> HB[3];
        for (int k = 0; k < 3; ++k) {
            const double* b = shapes_[f].b[k];
            HB[k].col(0) = H.col(0) * b[0] + H.col(1) * b[1];
            HB[k].col(1) = H.col(2) * b[0] + H.col(3) * b[1];
        }
        const auto block = [&](int row, int column) {
            const double* b = shapes_[f].b[row];
            Eigen::Matrix2d M;
            M.row(0) = b[0] * HB[column].row(0) + b[1] * HB[column].row(1);
            M.row(1) = b[0] * HB[column].row(2) + b[1] * HB[column].row(3);
            return M;
        };
        for (int k = 0; k < 3; ++k) {
            hessian.addVertex(mesh_.F(f, k), block(k, k));
            const int next = (k + 1) % 3;
            const bool rises = mesh_.F(f, k) < mesh_.F(f, next);
            hessian.addEdge(edgeOf[table_.faceEdges(f, k)],
                            rises ? block(next, k) : block(k, next));
        }
    }

    const MeshArrays& mesh_;
    const EdgeTable& table_;
    std::vector<Shape> shapes_;

private:
    bool relaxVertex(Points2& Q, std::span<const int> star, int v) const;
};

/// A way to make an energy: a constant beside its class. `FlattenOptions::energy` names it.
struct EnergyKind {
    std::string_view name;
    bool readsCloth;  ///< the energy depends on `PieceCloth`
    /// @param mesh, table  stored by reference; no degenerate triangles
    /// @param cloth  only read during the call
    std::unique_ptr<FlatEnergy> (*make)(const MeshArrays& mesh, const EdgeTable& table,
                                        const PieceCloth& cloth);
};

/// The energy of one piece, for its mesh and for coarser meshes of it.
struct EnergyModel {
    const EnergyKind* kind = &kSymmetricDirichlet;
    PieceClothPointer cloth{};  ///< null if the kind does not read it, or nothing is known

    EnergyModel() = default;
    EnergyModel(const FlattenOptions& options, const PieceClothPointer& given)
        : kind(options.energy), cloth(options.energy->readsCloth ? given : nullptr) {}

    std::unique_ptr<FlatEnergy> make(const MeshArrays& mesh, const EdgeTable& table) const {
        return kind->make(mesh, table, cloth ? *cloth : PieceCloth{});
    }
    /// For a mesh of some of the vertices. @param kept  their numbers in the present mesh
    EnergyModel onVertices(const std::vector<int>& kept) const;

    bool operator==(const EnergyModel& other) const {
        return kind == other.kind && isSameCloth(cloth, other.cloth);
    }
};

}  // namespace toile::isometric
