// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/fair_model.h"

namespace toile::fairing {

/// The iteration of `fairLine`: Newton steps on the Lagrangian, shortened until objective and
/// violation together decrease, at one weight of fairness (`share` of lambda) after another.
class FairSolver {
public:
    /// Keeps references.
    FairSolver(const FairModel& model, const Progress& progress)
        : model_(model), progress_(progress), state_(model.start()) {}

    /// Goes on at this weight until no direction changes by more than `done` (radians).
    /// @param limit  of iterations, counted from the beginning of all
    /// @return false where it came to no end
    bool iterate(double share, double done, int limit);
    void beginAnew();
    /// Meets the constraints, and leaves the rest as near as may be. False where it cannot.
    bool restore(LineState& state);

    const LineState& state() const { return state_; }
    int iterations() const { return iterations_; }

private:
    bool findMoves(double share, bool convex);
    bool take(double share);
    void accept(LineState trial, double taken);
    void correct(LineState& state);

    const FairModel& model_;
    const Progress& progress_;
    LineState state_;
    double share_ = 0;  ///< at which the multipliers of the state were found
    CyclicKkt kkt_;
    std::vector<KktStep> steps_;
    std::vector<KktRight> right_, trialRight_;
    std::vector<KktMove> moves_, corrections_;
    double taken_ = 0;  ///< share of the last moves
    int iterations_ = 0;
};

}  // namespace toile::fairing
