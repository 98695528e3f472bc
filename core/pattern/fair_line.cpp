// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/fair_line.h"

#include <cmath>

#include "core/pattern/fair_solver.h"

namespace toile {
namespace {

using fairing::FairModel;
using fairing::FairSolver;
using fairing::LineState;

/// Fraction of lambda per stage; the weight lambda^6 grows eightfold from stage to stage.
constexpr double kShares[] = {0.08838834764831845, 0.125, 0.17677669529663687, 0.25,
                              0.35355339059327373, 0.5,   0.70710678118654752, 1};
constexpr int kStages = 8;
constexpr int kDirectStage = 4;        // first stage to try, usually enough for garments
constexpr int kDirectIterations = 20;  // limit for it; if exceeded, start at stage 0
constexpr double kStageDone = 0.03;    // radians: largest change of a direction
constexpr double kDone = 1e-4;         // of the last stage, where convergence is quadratic
constexpr double kClosed = 1e-10;      // of the perimeter

bool isFinite(const FairProblem& problem) {
    bool finite = problem.reference.allFinite() && problem.steps.allFinite() &&
                  problem.tolerance.allFinite() && std::isfinite(problem.smoothing);
    for (const FairProblem::Corner& corner : problem.corners) {
        finite = finite && std::isfinite(corner.turn);
    }
    return finite;
}

/// Writes the line along a state's directions. False if it does not close or leaves the tolerance.
bool writeLine(const FairProblem& problem, const FairModel& model, const LineState& state,
               FairLine& line) {
    double gap = 0;
    line.points = model.walked(state, gap);
    line.directions = state.phi;
    const Eigen::ArrayXd away = (line.points - problem.reference).rowwise().norm();
    line.farthest = away.maxCoeff();
    return gap <= kClosed && (away < problem.tolerance.array()).all();
}

/// Fallback if the tolerance has no room for the lengths and turns: meets only these.
void writeExact(const FairProblem& problem, const Progress& progress, FairLine& line) {
    FairProblem loose = problem;
    loose.tolerance.setConstant(problem.steps.sum());
    const FairModel model(loose);
    FairSolver solver(model, progress);
    LineState state = model.start();
    solver.restore(state);
    writeLine(problem, model, state, line);
}

/// Runs all stages; false if one fails. `settled` is the state after the last converged stage.
bool climb(FairSolver& solver, LineState& settled) {
    int stage = kDirectStage;
    if (solver.iterate(kShares[stage], kStageDone, kDirectIterations)) {
        settled = solver.state();
        ++stage;
    } else {
        solver.beginAnew();
        stage = 0;
    }
    for (; stage < kStages; ++stage) {
        const double done = stage + 1 < kStages ? kStageDone : kDone;
        if (!solver.iterate(kShares[stage], done, kMaxFairIterations)) {
            return false;
        }
        settled = solver.state();
    }
    return true;
}

}  // namespace

Result<FairLine> fairLine(const FairProblem& problem, const Progress& progress) {
    if (!isFinite(problem)) {
        return Error{ErrorCode::NotFinite};
    }
    const FairModel model(problem);
    FairSolver solver(model, progress);
    LineState settled = model.start();
    FairLine line;
    line.converged = climb(solver, settled);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    line.iterations = solver.iterations();
    for (LineState state : {solver.state(), settled, model.start()}) {
        if (solver.restore(state) && writeLine(problem, model, state, line)) {
            return line;
        }
        line.converged = false;
    }
    writeExact(problem, progress, line);
    return line;
}

}  // namespace toile
