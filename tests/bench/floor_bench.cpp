// SPDX-License-Identifier: GPL-3.0-or-later
// What no method of one linear system can go below (floor.h).
#include <algorithm>
#include <stdexcept>

#include <cholmod.h>

#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/floor.h"
#include "tests/bench/report/bars.h"

namespace toile::bench {
namespace {

/// How often what is known to lose far behind is repeated.
constexpr int kLoserRepetitions = 2;

void measureFloor(benchmark::State& state, const std::string& name,
                  const FloorCandidate& candidate) {
    const Pieces& pieces = piecesOf(name);
    if (pieces.empty()) {
        state.SkipWithError("its file is not there");
        return;
    }
    try {
        for (auto _ : state) {
            for (const auto& piece : pieces) {
                benchmark::DoNotOptimize(runFloor(*piece, candidate));
            }
        }
    } catch (const std::runtime_error& error) {
        state.SkipWithError(error.what());
    }
    state.counters["triangles"] = triangleCount(pieces);
}

benchmark::internal::Benchmark* add(const std::string& name, const std::string& piece,
                                    const FloorCandidate& candidate, int repetitions) {
    auto* added = benchmark::RegisterBenchmark(
        name.c_str(),
        [piece, candidate](benchmark::State& state) { measureFloor(state, piece, candidate); });
    return measured(added, repetitions);
}

}  // namespace

void registerFloorOf(const std::string& piece, int repetitions, bool losers) {
    const std::size_t slash = piece.find('/');
    const int triangles = slash == piece.npos ? 0 : std::stoi(piece.substr(slash + 1));
    for (const FloorCandidate& candidate : floorCandidates()) {
        if (triangles <= candidate.largest && (losers || !candidate.loses)) {
            add("floor/" + piece + "/" + candidate.name, piece, candidate,
                candidate.loses ? std::min(repetitions, kLoserRepetitions) : repetitions);
        }
    }
}

void registerFloor(const Scope& scope) {
    for (const std::string surface : kSurfaces) {
        for (const std::string size : kSizes) {
            if (scope.allows(size)) {
                const std::string piece = surface + "/" + size;
                registerFloorOf(piece, repetitionsFor(piece, scope), true);
            }
        }
    }
    for (const std::string& garment : sharedGarments()) {
        registerFloorOf(garment, repetitionsFor(garment, scope), true);
    }
    const std::string largest = scope.quick ? "panel/45000" : "panel/1000000";
    FloorCandidate trapped{"", CHOLMOD_AMD, true};
    add("trap/" + largest + "/threads-bounded", largest, trapped, 3)->UseRealTime();
    trapped.boundedThreads = false;
    add("trap/" + largest + "/threads-as-delivered", largest, trapped, 3)->UseRealTime();
}

}  // namespace toile::bench
