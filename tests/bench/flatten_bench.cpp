// SPDX-License-Identifier: GPL-3.0-or-later
// From pieces in memory to flat positions, and from arrays to pieces.
#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include "core/flatten/flatten.h"
#include "core/mesh/tri_mesh.h"
#include "core/quality/piece_quality.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/report/bars.h"

namespace toile::bench {
namespace {

/// Symmetric Dirichlet energy, the mean over the area; nothing where a triangle is flipped.
std::optional<double> meanEnergy(const Pieces& pieces, const std::vector<FlatPiece>& flats) {
    double energy = 0, area = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const PieceQuality quality = measure(*pieces[k], flats[k].Q);
        if (!quality.symmetricDirichlet) {
            return std::nullopt;
        }
        energy += quality.area3d * *quality.symmetricDirichlet;
        area += quality.area3d;
    }
    return energy / area;
}

void measureFlattening(benchmark::State& state, const std::string& name, Method method) {
    const Pieces& pieces = piecesOf(name);
    if (pieces.empty()) {
        state.SkipWithError("its file is not there");
        return;
    }
    FlattenOptions options;
    options.method = method;
    std::vector<FlatPiece> flats(pieces.size());
    for (auto _ : state) {
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            auto flat = flatten(*pieces[k], options, Progress());
            if (!flat) {
                state.SkipWithError(sentence(flat.error()).c_str());
                return;
            }
            flats[k] = std::move(*flat);
        }
    }
    state.counters["triangles"] = triangleCount(pieces);
    state.counters["steps"] =
        std::transform_reduce(flats.begin(), flats.end(), 0.0, std::plus<>(),
                              [](const FlatPiece& flat) { return flat.interiorIterations; });
    if (const auto energy = meanEnergy(pieces, flats)) {
        state.counters["energy"] = *energy;
    }
}

void measureBuilding(benchmark::State& state, const std::string& name) {
    const MeshArrays& mesh = piecesOf(name).front()->mesh;
    for (auto _ : state) {
        state.PauseTiming();
        MeshArrays copy = mesh;
        state.ResumeTiming();
        const Piece piece = makePiece(name, std::move(copy));
        benchmark::DoNotOptimize(buildTriMesh(piece.mesh, piece.table));
    }
    state.counters["triangles"] = static_cast<double>(mesh.F.rows());
}

/// `isometric` takes long.
int isometricRepetitions(const std::string& piece, const Scope& scope) {
    if (scope.quick) {
        return 2;
    }
    return piece.ends_with("/1000000") ? 1 : piece.ends_with("/500000") ? 2 : 5;
}

}  // namespace

void registerFlatteningOf(const std::string& method, const std::string& piece, int repetitions) {
    const Method parsed = parseMethod(method).value();
    auto* added = benchmark::RegisterBenchmark(
        (method + "/" + piece).c_str(),
        [piece, parsed](benchmark::State& state) { measureFlattening(state, piece, parsed); });
    measured(added, repetitions);
}

void registerFlattening(const Scope& scope) {
    std::vector<std::string> pieces = sharedGarments();
    for (const std::string surface : kSurfaces) {
        for (const std::string size : kSizes) {
            if (scope.allows(size)) {
                pieces.push_back(surface + "/" + size);
            }
        }
    }
    for (const std::string& piece : pieces) {
        const int repetitions = repetitionsFor(piece, scope);
        registerFlatteningOf("curvature", piece, repetitions);
        registerFlatteningOf("wang2005", piece, repetitions);
        registerFlatteningOf("isometric", piece,
                             std::min(isometricRepetitions(piece, scope), repetitions));
    }
}

void registerPieces(const Scope& scope) {
    for (const std::string surface : kSurfaces) {
        for (const std::string size : kSizes) {
            const std::string piece = surface + "/" + size;
            if (scope.allows(size)) {
                auto* added = benchmark::RegisterBenchmark(
                    ("buildPiece/" + piece).c_str(),
                    [piece](benchmark::State& state) { measureBuilding(state, piece); });
                measured(added, repetitionsFor(piece, scope));
            }
        }
    }
}

}  // namespace toile::bench
