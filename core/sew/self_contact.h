// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/sew/cloth.h"
#include "core/sew/space_matrix.h"

namespace toile::sew {

/// Self-contact of cloth: every vertex v is repelled by every triangle T that is closer than the
/// thickness h,
///   W = sum_{v, T} A_v k max(h - d(v, T), 0)² / 2,
/// d the distance of the vertex from the nearest point of the triangle. Steps are limited to
/// `freeWay` ([LKJ21]), so that no vertex farther than h / 1000 from a triangle passes to its other
/// side, whatever side it started on. Edges may cross edges.
/// Excluded are triangles that are adjacent on the cloth as designed (`Cloth::X`): those with a
/// corner within two rings, or three times h along the cloth and its seams, of the vertex, or of a
/// triangle closer than h that it lies on there, like a facing on its piece.
/// N, mm. Results do not depend on the number of threads. Immutable; thread-safe.
class SelfContact {
public:
    /// A triangle near a vertex.
    struct Touch {
        int vertex, face;
        Eigen::Vector3d weights;  ///< of the triangle's corners, at its nearest point
        Eigen::Vector3d away;     ///< from there to the vertex, a unit vector
        double distance;          ///< mm
    };

    /// @param thickness  h, mm, above 0
    /// Keeps a reference to the cloth. Cost: n log n, plus per vertex its surroundings within three
    /// times h. After a cancel it returns soon and is unusable.
    SelfContact(const Cloth& cloth, double thickness, int threads, const Progress& progress = {});

    double thickness() const { return thickness_; }
    /// All contacts closer than `within`, mm: by vertex, then by face. Cost: n log n.
    std::vector<Touch> touchesAt(const Points3& X, double within) const;
    /// The fraction of a step that is free, in (0, 1]: contacts farther apart than a thousandth of
    /// the thickness keep at least a tenth of their distance, or that thousandth. Closer contacts
    /// are released so that layers do not stick. Cost: n log n, and more for longer steps.
    double freeWay(const Points3& X, const Points3& step) const;

    /// @param stiffness  k, N/mm³
    double energy(const std::vector<Touch>& touches, double stiffness) const;
    void addGradient(const std::vector<Touch>& touches, double stiffness, Points3& g) const;
    /// Adds the Gauss-Newton part of the second derivative; the rest is negative.
    void addHessian(const std::vector<Touch>& touches, double stiffness, SpaceMatrix& H) const;
    /// Adds the pairs of vertices that act on each other.
    void addPairs(const std::vector<Touch>& touches, std::vector<std::pair<int, int>>& pairs) const;

private:
    bool belongTogether(int vertex, int face) const;
    std::vector<Touch> touchesAt(const Points3& X, double within, const Progress& progress) const;

    const Cloth& cloth_;
    double thickness_;
    int threads_;
    Eigen::VectorXd areas_;
    std::vector<std::vector<int>> kin_;  ///< per vertex, ascending: vertices excluded from contact
};

}  // namespace toile::sew
