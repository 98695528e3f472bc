// SPDX-License-Identifier: GPL-3.0-or-later
// How long it takes to make an outline fair: `fair/line/MILLIMETRES`, in steps of at most 2 mm.
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "core/geometry/segment.h"
#include "core/pattern/fair_outline.h"
#include "tests/bench/benchmarks.h"

namespace toile::bench {
namespace {

using Eigen::Vector2d;

constexpr double kEdge = 10;       // mm: of the mesh
constexpr double kWrinkles = 0.3;  // mm
constexpr int kStepsPerEdge = 5;
constexpr unsigned kSeed = 20051;

/// One side of four, from corner to corner in waves, `share` of the way along.
Vector2d onSide(const Vector2d& from, const Vector2d& to, double share) {
    const double bow =
        0.04 * std::sin(std::numbers::pi * share) + 0.01 * std::sin(3 * std::numbers::pi * share);
    return from + share * (to - from) + bow * geometry::leftOf(Vector2d(to - from));
}

/// An outline like that of a garment's piece: four corners, bent sides, and what the mesh makes of
/// them: edges of about 10 mm whose ends are a little off.
FairProblem wrinkledOutline(double perimeter) {
    const double width = 0.2 * perimeter, height = 0.3 * perimeter;
    const Vector2d corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> off(-kWrinkles, kWrinkles);
    std::vector<Vector2d> ends;
    std::vector<int> nodes;
    for (int side = 0; side < 4; ++side) {
        const Vector2d from = corners[side], to = corners[(side + 1) % 4];
        const int edges = static_cast<int>(std::ceil((to - from).norm() / kEdge));
        nodes.push_back(kStepsPerEdge * static_cast<int>(ends.size()));
        for (int k = 0; k < edges; ++k) {
            const double x = off(random), y = off(random);
            ends.push_back(onSide(from, to, static_cast<double>(k) / edges) + Vector2d(x, y));
        }
    }
    const int edges = static_cast<int>(ends.size()), n = kStepsPerEdge * edges;
    FairProblem problem;
    problem.reference.resize(n, 2);
    problem.steps.resize(n);
    problem.tolerance = Eigen::VectorXd::Ones(n);
    for (int j = 0; j < n; ++j) {
        const Vector2d from = ends[j / kStepsPerEdge];
        const Vector2d way = ends[(j / kStepsPerEdge + 1) % edges] - from;
        problem.reference.row(j) = from + way * (j % kStepsPerEdge) / kStepsPerEdge;
        problem.steps[j] = way.norm() / kStepsPerEdge;
    }
    for (const int node : nodes) {
        const Vector2d at = problem.reference.row(node);
        const Vector2d before = at - problem.reference.row((node + n - 1) % n).transpose();
        const Vector2d after = problem.reference.row(node + 1).transpose() - at;
        problem.corners.push_back({node, geometry::turnBetween(before, after)});
    }
    return problem;
}

void measureLine(benchmark::State& state, double perimeter) {
    const FairProblem problem = wrinkledOutline(perimeter);
    for (auto _ : state) {
        const auto line = fairLine(problem, Progress());
        if (!line || !line->converged) {
            state.SkipWithError("the line did not become fair");
            return;
        }
        state.counters["iterations"] = line->iterations;
    }
    state.counters["nodes"] = static_cast<double>(problem.steps.size());
}

}  // namespace

void registerFairing(const Scope& scope) {
    for (const int perimeter : {500, 1500, 3000}) {
        auto* added = benchmark::RegisterBenchmark(
            ("fair/line/" + std::to_string(perimeter)).c_str(),
            [perimeter](benchmark::State& state) { measureLine(state, perimeter); });
        measured(added, scope.quick ? 3 : 5);
    }
}

}  // namespace toile::bench
