// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/linalg/block_matrix.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::isometric {

/// The symmetric Dirichlet energy of a flattening [SS15],
///   E(Q) = sum_T A_T (|J_T|^2 + |J_T^-1|^2) / 4,
/// with J_T the map of triangle T from its shape in 3D to the plane and A_T its 3D area divided by
/// the total area. E is 1 if isometric, infinite if a triangle has no area or is flipped. Mesh and
/// Q have the same unit. Immutable; linear cost throughout.
class SymmetricDirichlet {
public:
    /// Precondition: no degenerate triangles. Keeps references to both.
    SymmetricDirichlet(const MeshArrays& mesh, const EdgeTable& table);

    double energy(const Points2& Q) const;
    /// Derivative by every coordinate, #V x 2. Precondition: the energy is finite.
    Points2 gradient(const Points2& Q) const;
    /// Adds the Hessian, made positive semidefinite per triangle. Of the four eigenvalues of a
    /// triangle only the twist's can be negative ([SGK19] section 4); it is raised to zero.
    /// @param edgeOf  number of each mesh edge in the matrix's pattern
    void addHessian(const Points2& Q, const std::vector<int>& edgeOf,
                    linalg::BlockMatrix& hessian) const;
    /// The largest step up to `limit` along P before the first triangle loses its area.
    double largestStep(const Points2& Q, const Points2& P, double limit) const;

    /// Moves single vertices, with the others fixed, to lower the strain of their own triangles,
    /// while a move lowers a vertex's part of the energy noticeably. Resolves local distortion that
    /// would otherwise shorten a step of the whole piece. No triangle flips.
    /// @param held  vertices that must stay  @param passes  maximum number
    /// @param progress  only checked for cancellation; then fewer vertices are moved
    void relax(Points2& Q, const std::vector<int>& held, int passes,
               const Progress& progress) const;

private:
    /// A triangle's shape in 3D: area, and derivatives of the three hat functions in its plane.
    struct Shape {
        double area;
        double b[3][2];
    };

    Eigen::Matrix2d jacobian(const Points2& Q, int f) const;
    /// The energy of a vertex's triangles as a function of its position, to second order.
    struct VertexModel {
        double energy = 0;
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
    };

    /// @param star  the triangles at the vertex
    double starEnergy(const Points2& Q, std::span<const int> star) const;
    VertexModel vertexModel(const Points2& Q, std::span<const int> star, int v) const;
    bool relaxVertex(Points2& Q, std::span<const int> star, int v) const;

    const MeshArrays& mesh_;
    const EdgeTable& table_;
    std::vector<Shape> shapes_;
};

}  // namespace toile::isometric
