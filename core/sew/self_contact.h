// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/sew/cloth.h"
#include "core/sew/space_matrix.h"

namespace toile::sew {

/// How cloth keeps off itself: every vertex v is pushed away from every triangle T that is nearer
/// than the thickness h,
///   W = sum_{v, T} A_v k max(h - d(v, T), 0)² / 2,
/// d the distance of the vertex from the nearest point of the triangle. Steps are cut to `freeWay`
/// ([LKJ21]): so no vertex that is further than h / 1000 from a triangle comes to the other side of
/// it, whichever that was at first. Edges may cross edges.
/// Left alone is what belongs together where the cloth was designed (`Cloth::X`): triangles with a
/// corner within two rings, or three times h along the cloth and its seams, of the vertex, or of a
/// triangle that it lies on there, nearer than h, as a facing lies on its piece.
/// N, mm. The same bytes for any number of threads. Immutable; thread-safe.
class SelfContact {
public:
    /// A triangle that a vertex is near.
    struct Touch {
        int vertex, face;
        Eigen::Vector3d weights;  ///< of the triangle's corners, at its nearest point
        Eigen::Vector3d away;     ///< from there to the vertex, a unit vector
        double distance;          ///< mm
    };

    /// @param thickness  h, mm, above 0
    /// Keeps a reference to the cloth. Cost: n log n, and by vertex what lies within three times h.
    /// Cancelled: ends soon, and is of no use.
    SelfContact(const Cloth& cloth, double thickness, int threads, const Progress& progress = {});

    double thickness() const { return thickness_; }
    /// All that are nearer than `within`, mm: by vertices, and by faces of each. Cost: n log n.
    std::vector<Touch> touchesAt(const Points3& X, double within) const;
    /// The part of a step that can be gone, in (0, 1]: what is further apart than a thousandth of
    /// the thickness comes no nearer on it than a tenth of its distance, or that thousandth. What
    /// is nearer already is let go, so that nothing gets stuck. Cost: n log n, and more the longer
    /// the step is.
    double freeWay(const Points3& X, const Points3& step) const;

    /// @param stiffness  k, N/mm³
    double energy(const std::vector<Touch>& touches, double stiffness) const;
    void addGradient(const std::vector<Touch>& touches, double stiffness, Points3& g) const;
    /// Gauss and Newton's part of the second derivative; the rest of it is negative.
    void addHessian(const std::vector<Touch>& touches, double stiffness, SpaceMatrix& H) const;
    /// The vertices that act on each other.
    void addPairs(const std::vector<Touch>& touches, std::vector<std::pair<int, int>>& pairs) const;

private:
    bool belongTogether(int vertex, int face) const;
    std::vector<Touch> touchesAt(const Points3& X, double within, const Progress& progress) const;

    const Cloth& cloth_;
    double thickness_;
    int threads_;
    Eigen::VectorXd areas_;
    std::vector<std::vector<int>> kin_;  ///< per vertex, ascending: those it belongs together with
};

}  // namespace toile::sew
