// SPDX-License-Identifier: GPL-3.0-or-later
// The most memory that the program holds at a time, from an OBJ file of a million triangles to
// SVG, DXF, OBJ and JSON.
#include <cstdio>
#include <optional>
#include <string>

#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/report/bars.h"

namespace toile::bench {
namespace {

std::string quoted(const std::string& argument) {
    return "'" + argument + "' ";
}

/// MiB; nothing where the program fails.
std::optional<double> peakOf(const std::string& piece, const std::string& method) {
    std::string command = quoted(TOILE_PEAK_MEMORY) + quoted(TOILE_PROGRAM) + "flatten " +
                          quoted(fileOf(piece).string()) + "--method " + method;
    for (const char* ending : {"svg", "dxf", "obj", "json"}) {
        command +=
            " -o " + quoted((temporaryFolder() / ("memory." + std::string(ending))).string());
    }
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) {
        return std::nullopt;
    }
    double peak = 0;
    const bool printed = std::fscanf(pipe, "%lf", &peak) == 1;
    return pclose(pipe) == 0 && printed ? std::optional(peak) : std::nullopt;
}

void measureMemory(benchmark::State& state, const std::string& piece, const std::string& method) {
    fileOf(piece);  // written before the clock starts
    for (auto _ : state) {
        const auto peak = peakOf(piece, method);
        if (!peak) {
            state.SkipWithError("the program failed");
            return;
        }
        state.counters["peakMiB"] = *peak;
    }
}

}  // namespace

void registerMemory(const Scope& scope) {
    const std::string size = scope.quick ? "45000" : "1000000";
    for (const std::string surface : kSurfaces) {
        for (const std::string method : {"curvature", "isometric"}) {
            const std::string piece = surface + "/" + size;
            auto* added = benchmark::RegisterBenchmark(
                ("memory/" + piece + "/" + method).c_str(),
                [piece, method](benchmark::State& state) { measureMemory(state, piece, method); });
            added->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(1);
        }
    }
}

}  // namespace toile::bench
