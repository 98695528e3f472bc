// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/assemble/cut_pieces.h"
#include "core/base/progress.h"
#include "core/cut/surface_paths.h"
#include "core/garment/piece.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/tailor/tailor_cuts.h"

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

/// Amount that a dart takes in at the rim.
struct DartIntake {
    double width = 0;  ///< mm
    double angle = 0;  ///< radians

    bool operator==(const DartIntake&) const = default;
};

struct AdvisedCut {
    TailorCut what;
    Wording evidence{};
    double length = 0;                      ///< mm
    bool isNeeded = true;                   ///< part of the sufficient set
    StrainFigures predicted{};              ///< with this and all earlier cuts
    std::optional<StrainFigures> solved{};  ///< the same after flattening, if it was done
    std::optional<DartIntake> intake{};     ///< for darts
};

struct AdviceOptions {
    bool isFrontSwapped = false;  ///< the front is opposite to the guess
    /// Mean strain below which no cut is worth its length. None: tailors' usual seams, and darts
    /// only if strain exceeds that of any cloth.
    std::optional<double> enoughStrain{};
    std::vector<char> borders{};  ///< per edge, from `fileBorders`; may be empty

    bool operator==(const AdviceOptions&) const = default;
};

/// Cuts for one piece, the greatest gain for their length first, and their effect.
struct CutAdvice {
    bool isWorn = false;     ///< the piece was recognised as a worn garment
    StrainFigures before{};  ///< predicted for the shortest cuts that open the piece
    std::vector<AdvisedCut> cuts{};
    /// Name of a part that results from these cuts: "front"; empty if unknown.
    std::function<std::string(const Piece&)> nameOf{};
};

/// Marks the cuts that are needed to reach a mean strain, symmetrically on both sides of a garment.
/// None: worn garments need their usual seams, other forms enough to leave 1.5 %. Linear.
void markNeeded(CutAdvice& advice, const std::optional<double>& enough);

/// Proposes cuts for one piece: tailors' cuts for worn garments (`tailorCuts`), cuts along ridges
/// and the mirror plane for solids to cover, and darts where strain remains.
/// @param own  cuts that are made in any case; proposals end on them and do not repeat them
/// Cost: that of `tailorCuts`, and a sparse factorisation for each cut looked at. Deterministic.
/// Pure.
CutAdvice adviseCuts(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& own,
                     const AdviceOptions& options, const Progress& progress = {});

}  // namespace toile
