// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/fair_model.h"

namespace toile::fairing {

/// The iteration of `fairLine`: Newton steps on the Lagrangian, shortened until the merit of
/// objective and violation decreases, for increasing weights of fairness (`share` of lambda).
class FairSolver {
public:
    /// Keeps references.
    FairSolver(const FairModel& model, const Progress& progress)
        : model_(model), progress_(progress), state_(model.start()) {}

    /// Iterates at this weight until no direction changes by more than `done` (radians).
    /// @param limit  for `iterations()`, which counts over all weights
    /// @return false if it did not converge
    bool iterate(double share, double done, int limit);
    void beginAnew();
    /// Moves the state onto the constraints with a small change. False if it cannot.
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
    double share_ = 0;  ///< weight for which the multipliers were computed
    CyclicKkt kkt_;
    std::vector<KktStep> steps_;
    std::vector<KktRight> right_, trialRight_;
    std::vector<KktMove> moves_, corrections_;
    double taken_ = 0;  ///< fraction of the last moves that was taken
    int iterations_ = 0;
};

}  // namespace toile::fairing
