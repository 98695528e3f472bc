// SPDX-License-Identifier: GPL-3.0-or-later
// What a small edit costs: `resolveX/mesh/triangles/method` flattens the edited version with what
// was kept of the one before, `coldX/...` flattens it as if there had been none.
#include <functional>
#include <map>
#include <string>
#include <tuple>

#include <benchmark/benchmark.h>

#include "core/flatten/flatten.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/benchmarks.h"
#include "tests/core/support/piece_edits.h"

namespace toile::bench {
namespace {

using PiecePointer = std::shared_ptr<const Piece>;

/// Lengths of the darts, in edges.
constexpr int kDart = 40;
constexpr int kTriangles = 45000;

struct Edit {
    std::string name;
    std::function<PiecePointer(const PiecePointer&)> before, after;  ///< from the original
};

PiecePointer asItIs(const PiecePointer& original) {
    return original;
}

PiecePointer withDart(const PiecePointer& original, int shift) {
    const int start = static_cast<int>(original->boundary.size()) * 13 / 16 + shift;
    return test::opened(*original, {test::dartAlongEdges(*original, start, kDart)});
}

/// Moved outwards by a third of an edge.
PiecePointer withDragged(const PiecePointer& original, int vertex) {
    const Points3& V = original->mesh.V;
    const double edge = (V.row(original->mesh.F(0, 0)) - V.row(original->mesh.F(0, 1))).norm();
    return test::dragged(*original, vertex, Eigen::RowVector3d(0.2, 0.1, 0.2) * edge);
}

const std::vector<Edit>& edits() {
    static const std::vector<Edit> kEdits = {
        {"Dart", asItIs, [](const PiecePointer& p) -> PiecePointer { return withDart(p, 0); }},
        {"MovedCut", [](const PiecePointer& p) -> PiecePointer { return withDart(p, 0); },
         [](const PiecePointer& p) -> PiecePointer { return withDart(p, 10); }},
        {"DraggedInside", asItIs,
         [](const PiecePointer& p) -> PiecePointer {
             return withDragged(p, test::deepestVertex(*p));
         }},
        {"DraggedRim", asItIs,
         [](const PiecePointer& p) -> PiecePointer {
             return withDragged(p, p->boundary[p->boundary.size() / 3]);
         }},
    };
    return kEdits;
}

struct Case {
    std::string mesh;
    int triangles;
    FlattenOptions options;
};

const PiecePointer& original(const Case& of) {
    static std::map<std::pair<std::string, int>, PiecePointer> made;
    PiecePointer& piece = made[{of.mesh, of.triangles}];
    if (!piece) {
        piece = test::originalPiece(of.mesh == "panel" ? panelMesh(of.triangles)
                                                       : headMesh(of.triangles));
    }
    return piece;
}

struct Versions {
    PiecePointer before, after;
};

const Versions& versions(const Case& of, const Edit& edit) {
    static std::map<std::tuple<std::string, int, std::string>, Versions> made;
    Versions& both = made[{of.mesh, of.triangles, edit.name}];
    if (!both.before) {
        both = {edit.before(original(of)), edit.after(original(of))};
    }
    return both;
}

void resolve(benchmark::State& state, const Case& of, const Edit& edit) {
    const Versions& both = versions(of, edit);
    PieceFlattener knowing;
    if (!knowing.flatten(both.before, of.options, Progress())) {
        state.SkipWithError("the version before the edit was not flattened");
    }
    for (auto _ : state) {
        PieceFlattener next = knowing;
        const auto flat = next.flatten(both.after, of.options, Progress());
        if (!flat) {
            state.SkipWithError("the edited version was not flattened");
        } else {
            state.counters["steps"] = flat->interiorIterations;
        }
    }
    state.counters["keptMiB"] = static_cast<double>(knowing.keptBytes()) / (1 << 20);
}

void cold(benchmark::State& state, const Case& of, const Edit& edit) {
    const Versions& both = versions(of, edit);
    for (auto _ : state) {
        const auto flat = flatten(*both.after, of.options, Progress());
        if (!flat) {
            state.SkipWithError("the edited version was not flattened");
        } else {
            state.counters["steps"] = flat->interiorIterations;
        }
    }
}

void registerBoth(const Case& of, const Edit& edit, int repetitions) {
    const std::string rest = edit.name + "/" + of.mesh + "/" + std::to_string(of.triangles) + "/" +
                             std::string(name(of.options.method));
    for (const auto& [kind, run] : {std::pair("resolve", &resolve), std::pair("cold", &cold)}) {
        measured(benchmark::RegisterBenchmark(
                     (kind + rest).c_str(),
                     [run = run, of, &edit](benchmark::State& state) { run(state, of, edit); }),
                 repetitions);
    }
}

}  // namespace

void registerResolve(const Scope& scope) {
    for (const char* mesh : {"panel", "head"}) {
        for (const Method method : {Method::Curvature, Method::Isometric}) {
            for (const Edit& edit : edits()) {
                Case of{mesh, kTriangles, {}};
                of.options.method = method;
                registerBoth(of, edit, scope.quick ? 1 : 3);
            }
        }
    }
}

}  // namespace toile::bench
