// SPDX-License-Identifier: GPL-3.0-or-later
// From file to files in one process, and where the time goes.
#include <algorithm>
#include <ctime>
#include <map>
#include <stdexcept>

#include "core/formats/export_file.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/quality/piece_quality.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/floor.h"
#include "tests/bench/report/bars.h"
#include "tests/core/support/laid_rows.h"

namespace toile::bench {
namespace {

namespace fs = std::filesystem;
using Seconds = std::map<std::string, double>;

/// The pipeline, walked once.
struct Walk {
    Garment garment;
    PieceResults results;
    double load = 0, flatten = 0, write = 0;  ///< seconds of processor time
};

/// Processor time of all threads, which what else the machine does leaves alone.
template <class Work>
double secondsOf(const Work& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

template <class T>
T orThrow(Result<T> result) {
    if (!result) {
        throw std::runtime_error(sentence(result.error()));
    }
    return std::move(*result);
}

void orThrow(const Result<void>& result) {
    if (!result) {
        throw std::runtime_error(sentence(result.error()));
    }
}

Walk walk(const fs::path& file, const FlattenOptions& options) {
    Walk done;
    Progress progress;
    done.load = secondsOf([&] { done.garment = orThrow(loadGarment({file}, {}, progress)); });
    done.flatten =
        secondsOf([&] { done.results = flattenGarment(done.garment, options, progress); });
    done.write = secondsOf([&] {
        for (const char* ending : {"svg", "dxf", "obj", "json"}) {
            const fs::path path = temporaryFolder() / (std::string("end_to_end.") + ending);
            if (!exportFile(path,
                            {done.garment, done.results, inRows(done.garment, done.results)})) {
                throw std::runtime_error("cannot write " + path.string());
            }
        }
    });
    return done;
}

/// The stages of the pipeline. What cannot be timed from outside is done once more alone, and taken
/// off the stage it is part of.
Seconds stagesOf(const fs::path& file, const Walk& walk) {
    const double read = std::min(walk.load, secondsOf([&] {
                                     Progress progress;
                                     benchmark::DoNotOptimize(readSoup(file, progress));
                                 }));
    const double seams =
        std::min(walk.load - read,
                 secondsOf([&] { benchmark::DoNotOptimize(findSeams(walk.garment.pieces)); }));
    const double measuring =
        std::min(walk.flatten, secondsOf([&] {
                     for (const auto& result : walk.results) {
                         benchmark::DoNotOptimize(measure(*result->piece, result->flat->Q));
                     }
                 }));
    return {{"read", read},         {"pieces", walk.load - read - seams},
            {"seams", seams},       {"solve", walk.flatten - measuring},
            {"measure", measuring}, {"write", walk.write}};
}

/// What `curvature` does in one piece. The factorisation is the solver's own, done with the same
/// matrix once more.
Seconds solveStagesOf(const Piece& piece, const FlatPiece& flat) {
    linalg::SymmetricMatrix matrix;
    Seconds stages;
    stages["assemble"] = secondsOf([&] { matrix = assembleFloor(piece); });
    linalg::SparseCholesky cholesky;
    stages["order"] = secondsOf([&] { orThrow(cholesky.analyse(matrix)); });
    stages["factorise"] = secondsOf([&] { orThrow(cholesky.refactorise(matrix)); });
    stages["substitute"] = secondsOf([&] {
        benchmark::DoNotOptimize(cholesky.solve(Eigen::MatrixXd::Ones(matrix.size, 1)));
        benchmark::DoNotOptimize(cholesky.solve(Eigen::MatrixXd::Ones(matrix.size, 2)));
    });
    stages["boundary"] = flat.boundarySeconds;
    return stages;
}

void measureEndToEnd(benchmark::State& state, const fs::path& file, Method method) {
    if (!fs::exists(file)) {
        state.SkipWithError("its file is not there");
        return;
    }
    FlattenOptions options;
    options.method = method;
    Walk done;
    for (auto _ : state) {
        done = walk(file, options);
    }
    const bool allFlat = std::ranges::all_of(
        done.results, [](const auto& result) { return result->flat.has_value(); });
    if (!allFlat) {
        state.SkipWithError("a piece could not be flattened");
        return;
    }
    Seconds stages = stagesOf(file, done);
    if (method == Method::Curvature && done.results.size() == 1) {
        const PieceResult& result = *done.results.front();
        stages.merge(solveStagesOf(*result.piece, *result.flat));
    }
    for (const auto& [stage, seconds] : stages) {
        state.counters[stage] = seconds;
    }
}

void add(const std::string& garment, bool shared, Method method, int repetitions) {
    const std::string name = "endToEnd/" + garment + "/" + std::string(toile::name(method));
    auto* added = benchmark::RegisterBenchmark(
        name.c_str(), [garment, shared, method](benchmark::State& state) {
            measureEndToEnd(state, shared ? sharedFile(garment) : fileOf(garment), method);
        });
    measured(added, repetitions)->UseRealTime();
}

}  // namespace

void registerEndToEnd(const Scope& scope) {
    for (const std::string& garment : sharedGarments()) {
        add(garment, true, Method::Isometric, scope.quick ? 1 : 3);
        add(garment, true, Method::Curvature, 3);
    }
    for (const std::string surface : kSurfaces) {
        for (const std::string size : {"45000", "1000000"}) {
            if (scope.allows(size)) {
                add(surface + "/" + size, false, Method::Curvature, 3);
            }
        }
        add(surface + "/45000", false, Method::Isometric, scope.quick ? 1 : 2);
    }
}

}  // namespace toile::bench
