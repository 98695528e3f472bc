// SPDX-License-Identifier: GPL-3.0-or-later
// How long the cutting line of an outline takes: `allowance/line/POINTS`; and all that makes
// outlines a pattern (segments, allowances, notches, labels, grain lines) and its drawing:
// `allowance/pattern/PIECES`, with the milliseconds that a piece takes.
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/progress.h"
#include "core/formats/drawing/drawing.h"
#include "core/pattern/piece_allowance.h"
#include "core/toile/pipeline.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"

namespace toile::bench {
namespace {

constexpr double kWidth = 600, kHeight = 800;  // mm

/// Four bent sides with waves in them, as of a garment's piece.
Points2 bentOutline(int pointsOfASide) {
    const Eigen::RowVector2d corners[] = {{0, 0}, {kWidth, 0}, {kWidth, kHeight}, {0, kHeight}};
    Points2 points(4 * pointsOfASide, 2);
    for (int side = 0; side < 4; ++side) {
        const Eigen::RowVector2d from = corners[side], way = corners[(side + 1) % 4] - from;
        for (int k = 0; k < pointsOfASide; ++k) {
            const double share = static_cast<double>(k) / pointsOfASide;
            const double bow = 0.04 * std::sin(std::numbers::pi * share) +
                               0.02 * std::sin(6 * std::numbers::pi * share);
            const Eigen::RowVector2d across(-way.y(), way.x());
            points.row(side * pointsOfASide + k) = from + share * way + bow * across;
        }
    }
    return points;
}

void measureCuttingLine(benchmark::State& state, int pointsOfASide) {
    const Points2 seamLine = bentOutline(pointsOfASide);
    const std::vector<AllowanceStretch> stretches{
        {0, 30, CornerRule::MirrorSecond},
        {pointsOfASide, 10, CornerRule::MirrorFirst},
        {2 * pointsOfASide, 10},
        {3 * pointsOfASide, 15, CornerRule::RightAngleFirst}};
    for (auto _ : state) {
        const Points2 cut = cuttingLine(seamLine, stretches);
        state.counters["points"] = static_cast<double>(cut.rows());
    }
}

void measurePattern(benchmark::State& state, const std::string& name) {
    const auto file = name.find('/') != std::string::npos ? fileOf(name) : sharedFile(name);
    Progress progress;
    const auto garment = loadGarment({file}, {}, progress);
    if (!garment) {
        state.SkipWithError("its file is not there");
        return;
    }
    const LineSettings lines = withPattern({});
    const PieceResults results = flattenGarment(*garment, {Method::Curvature}, progress, 0, lines);
    const auto symmetry = symmetryOf(*garment, lines);
    const Stopwatch watch;
    for (auto _ : state) {
        Pattern pattern = makePattern(*garment, results, lines, symmetry);
        for (PatternPiece& piece : pattern.pieces) {
            piece.grain = kGrainUpwards;
        }
        const LaidOutPattern laid = cutAndPlace(std::move(pattern));
        benchmark::DoNotOptimize(draw(laid.pattern, laid.marker));
    }
    const double pieces = static_cast<double>(garment->pieces.size() * state.iterations());
    state.counters["ms_a_piece"] = 1000 * watch.seconds() / pieces;
}

}  // namespace

void registerAllowances(const Scope& scope) {
    for (const int points : {300, 3000}) {
        auto* added = benchmark::RegisterBenchmark(
            ("allowance/line/" + std::to_string(points)).c_str(),
            [points](benchmark::State& state) { measureCuttingLine(state, points / 4); });
        measured(added, scope.quick ? 3 : 5);
    }
    for (const std::string name : {"panel/45000", "dress"}) {
        auto* added = benchmark::RegisterBenchmark(
            ("allowance/pattern/" + name).c_str(),
            [name](benchmark::State& state) { measurePattern(state, name); });
        measured(added, 3);
    }
}

}  // namespace toile::bench
