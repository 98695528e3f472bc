// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/cut/surface_links.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile {

/// Strain of flat cloth, part of 1.
struct StrainFigures {
    double mean = 0;  ///< over the area
    double most = 0;  ///< what a thousandth of the area exceeds: single triangles are passed over

    bool operator==(const StrainFigures&) const = default;
};

/// Of strains of either sign, and the areas that have them, none negative. O(n log n). Pure.
StrainFigures strainFigures(std::vector<std::pair<double, double>> strainsAndAreas);

/// How a surface would lie flat.
struct FlatScale {
    Eigen::VectorXd log;       ///< per vertex: logarithm of flat by worn length
    Eigen::VectorXd absorbed;  ///< per vertex, radians: the curvature that a parted one takes in,
                               ///< which is by how much a cut opens there
    StrainFigures strain;
};

/// Foretells what strain remains where a surface is parted along some lines, before anything is
/// flattened. A flat metric exp(2u) times the worn one has to take back the curvature K, as angle
/// defects, by L u = -K with the cotangent Laplacian L; with u = 0 along rims and cuts these keep
/// their lengths ([BCGB08] section 3.2, [SC17] section 4). It is what a conformal map with kept
/// boundary lengths does exactly; `isometric` does better, but in the same places. One
/// factorisation of size #V for each question; the order of elimination is found once.
class StrainModel {
public:
    /// Linear.
    explicit StrainModel(const SurfaceLinks& links);

    /// @param parted  per vertex, whether a rim or a cut passes there; rims are not added
    /// @return none where a part of the surface has no such vertex, or memory is short
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
