// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to propose tailors' cuts for a shirt of one skin of 46 592 triangles,
// `tailor/cuts`, and to say what each is worth, `tailor/advice`.
#include "core/tailor/cut_advice.h"
#include "core/tailor/tailor_cuts.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile::bench {
namespace {

/// Each triangle becomes four.
MeshArrays finer(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    MeshArrays made;
    made.V.resize(mesh.V.rows() + table.edges.rows(), 3);
    made.V.topRows(mesh.V.rows()) = mesh.V;
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        made.V.row(mesh.V.rows() + e) =
            (mesh.V.row(table.edges(e, 0)) + mesh.V.row(table.edges(e, 1))) / 2;
    }
    made.F.resize(4 * mesh.F.rows(), 3);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const auto middle = [&](int k) {
            return static_cast<int>(mesh.V.rows()) + table.faceEdges(f, k);
        };
        for (int k = 0; k < 3; ++k) {
            made.F.row(4 * f + k) << mesh.F(f, k), middle(k), middle((k + 2) % 3);
        }
        made.F.row(4 * f + 3) << middle(0), middle(1), middle(2);
    }
    return made;
}

const std::shared_ptr<const Piece>& shirt() {
    static const auto made = test::wornPiece(finer(finer(test::wornShirt())));
    return made;
}

void measureCuts(benchmark::State& state) {
    std::size_t cuts = 0;
    for (auto _ : state) {
        cuts = tailorCuts(shirt()).size();
    }
    state.counters["triangles"] = static_cast<double>(shirt()->mesh.F.rows());
    state.counters["cuts"] = static_cast<double>(cuts);
}

void measureAdvice(benchmark::State& state) {
    std::size_t cuts = 0;
    for (auto _ : state) {
        cuts = adviseCuts(shirt(), {}, {}).cuts.size();
    }
    state.counters["triangles"] = static_cast<double>(shirt()->mesh.F.rows());
    state.counters["cuts"] = static_cast<double>(cuts);
}

}  // namespace

void registerTailor() {
    measured(benchmark::RegisterBenchmark("tailor/cuts", measureCuts), 3)->UseRealTime();
    measured(benchmark::RegisterBenchmark("tailor/advice", measureAdvice), 3)->UseRealTime();
}

}  // namespace toile::bench
