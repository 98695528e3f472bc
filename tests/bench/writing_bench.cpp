// SPDX-License-Identifier: GPL-3.0-or-later
// How long it takes to write a flat garment of a million triangles, file system and all.
#include <map>
#include <stdexcept>
#include <string>

#include "core/formats/export_file.h"
#include "core/toile/pipeline.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/core/support/laid_rows.h"

namespace toile::bench {
namespace {

/// A garment as read, and flat.
struct FlatGarment {
    Garment garment;
    PieceResults results;
};

const FlatGarment& flatGarment(const std::string& piece) {
    static std::map<std::string, FlatGarment> kept;
    const auto found = kept.find(piece);
    if (found != kept.end()) {
        return found->second;
    }
    Progress progress;
    auto garment = loadGarment({fileOf(piece)}, {}, progress);
    if (!garment) {
        throw std::runtime_error(sentence(garment.error()));
    }
    FlattenOptions options;
    options.method = Method::Curvature;
    FlatGarment flat{std::move(*garment), {}};
    flat.results = flattenGarment(flat.garment, options, progress);
    return kept.emplace(piece, std::move(flat)).first->second;
}

void measureWriting(benchmark::State& state, const std::string& piece, const std::string& format) {
    const FlatGarment& flat = flatGarment(piece);
    const auto path = temporaryFolder() / ("written." + format);
    for (auto _ : state) {
        if (!exportFile(path, {flat.garment, flat.results, inRows(flat.garment, flat.results)})) {
            state.SkipWithError("the file cannot be written");
            return;
        }
    }
    state.counters["MB"] = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
}

}  // namespace

void registerWriting(const Scope& scope) {
    const std::string piece = scope.quick ? "panel/45000" : "panel/1000000";
    for (const std::string format : {"obj", "svg", "dxf", "json"}) {
        auto* added = benchmark::RegisterBenchmark(
            ("write/" + piece + "/" + format).c_str(),
            [piece, format](benchmark::State& state) { measureWriting(state, piece, format); });
        measured(added, 5)->UseRealTime();
    }
}

}  // namespace toile::bench
