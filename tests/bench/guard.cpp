// SPDX-License-Identifier: GPL-3.0-or-later
// A short guard on speed for continuous integration: fails where a change makes a method about
// twice as slow as it is to be, next to what is measured beside it on the same machine. The bounds
// are generous and the lowest times of rounds in turns are compared, so that a busy machine does
// not fail it; docs/performance.md holds the code to the real ones.
#include <cstdio>
#include <vector>

#include "tests/bench/benchmarks.h"
#include "tests/bench/keeping_reporter.h"

namespace toile::bench {
namespace {

/// `isometric` next to `curvature`: below 5 on the panel and 9 on the head when this was written.
struct Guarded {
    const char* piece;
    double mostCurvatures;
};
constexpr Guarded kPieces[] = {{"panel/45000", 9}, {"head/45000", 16}};
constexpr int kRounds = 7, kIsometricRounds = 3;
constexpr double kMaxFloors = 1.8;  // `curvature` is to be below 1.35: doubled it fails
constexpr int kAttempts = 2;

bool holds(const std::string& what, double measured, double bound) {
    std::printf("%s: %.2f, at most %g: %s\n", what.c_str(), measured, bound,
                measured <= bound ? "kept" : "NOT kept");
    return measured <= bound;
}

bool holdsAll(const Measurements& run) {
    bool all = true;
    for (const Guarded& guarded : kPieces) {
        const std::string piece = guarded.piece;
        const auto floor = run.floorOf(piece);
        const auto curvature = run.lowest("curvature/" + piece);
        const auto isometric = run.lowest("isometric/" + piece);
        if (!floor || !curvature || !isometric) {
            std::printf("%s could not be measured\n", piece.c_str());
            return false;
        }
        all &= holds("curvature/" + piece + " / floor", *curvature / floor->measurement->lowest(),
                     kMaxFloors);
        all &= holds("isometric/" + piece + " / curvature/" + piece, *isometric / *curvature,
                     guarded.mostCurvatures);
    }
    return all;
}

}  // namespace
}  // namespace toile::bench

int main() {
    using namespace toile::bench;
    char name[] = "guard";
    char interleaving[] = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> arguments{name, interleaving, nullptr};
    int count = 2;
    benchmark::Initialize(&count, arguments.data());
    for (const Guarded& guarded : kPieces) {
        const std::string piece = guarded.piece;
        registerFloorOf(piece, kRounds, false);
        registerFlatteningOf("curvature", piece, kRounds);
        registerFlatteningOf("isometric", piece, kIsometricRounds);
    }
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        KeepingReporter reporter;
        benchmark::RunSpecifiedBenchmarks(&reporter);
        if (holdsAll(reporter.measurements())) {
            return 0;
        }
    }
    return 1;
}
