// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/cut/surface_links.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile {

/// Strain of flat cloth; 1 is 100 %.
struct StrainFigures {
    double mean = 0;  ///< over the area
    double most = 0;  ///< exceeded by a thousandth of the area, to ignore single triangles

    bool operator==(const StrainFigures&) const = default;
};

/// From signed strains and their areas, none negative. O(n log n). Pure.
StrainFigures strainFigures(std::vector<std::pair<double, double>> strainsAndAreas);

/// Flat scale of a surface.
struct FlatScale {
    Eigen::VectorXd log;       ///< per vertex: logarithm of flat length by worn length
    Eigen::VectorXd absorbed;  ///< per vertex, radians: the curvature taken in at a separated one,
                               ///< which is the angle by which a cut opens there
    StrainFigures strain;
};

/// Predicts the strain that remains if a surface is cut along some lines, without flattening. A
/// flat metric exp(2u) times the worn one must cancel the curvature K (angle defects): L u = -K
/// with the cotangent Laplacian L. With u = 0 along rims and cuts these keep their lengths
/// ([BCGB08] section 3.2, [SC17] section 4). A conformal map with fixed boundary lengths does
/// exactly this; `isometric` has less strain, but in the same places. Each query takes one
/// factorisation of size #V; the elimination order is found once.
class StrainModel {
public:
    /// Linear.
    explicit StrainModel(const SurfaceLinks& links);

    /// @param parted  per vertex, whether a rim or a cut passes there; rims are not added
    /// @return nothing if a component of the surface has no such vertex, or memory is short
    std::optional<FlatScale> solve(std::vector<char> parted);

    /// Per vertex: on a rim.
    const std::vector<char>& rims() const { return rims_; }
    const std::vector<double>& areas() const { return areas_; }  ///< per vertex, sums to the area

private:
    linalg::SymmetricMatrix laplacian_;
    linalg::SparseCholesky factor_;
    Eigen::VectorXd curvature_;
    std::vector<char> rims_;
    std::vector<double> areas_;
    bool isOrdered_ = false;
};

}  // namespace toile
