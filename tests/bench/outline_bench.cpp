// SPDX-License-Identifier: GPL-3.0-or-later
// Every stage of the pipeline over the length of the outline: `outline/STAGE/VERTICES`. The pieces
// are strips, whose vertices all lie on the outline, so that a stage that is more than linear in it
// shows as soon as it can: the time per vertex is to stay what it is.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/check/ready_to_cut.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/isometric/outline_terms.h"
#include "core/formats/export_file.h"
#include "core/quality/measures.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/report/bars.h"
#include "tests/core/support/laid_rows.h"

namespace toile::bench {
namespace {

constexpr double kEdge = 5;  // mm

template <class T>
T orFail(Result<T> result) {
    if (!result) {
        throw std::runtime_error(sentence(result.error()));
    }
    return std::move(*result);
}

void orFail(const Result<void>& result) {
    if (!result) {
        throw std::runtime_error(sentence(result.error()));
    }
}

/// A line along the strips, `k` edges from its beginning: in waves, so that no side is straight.
Eigen::Vector3d onStrip(double k, double across) {
    return {kEdge * k, across + 4 * std::sin(0.02 * k), 6 * std::sin(0.05 * k + 0.02 * across)};
}

/// Two strips of one row of squares, sewn to each other along a side, as an OBJ file. Each has so
/// many vertices, all on its outline.
std::string stripsText(int vertices) {
    const int columns = vertices / 2 - 1;
    std::string text;
    for (const int strip : {0, 1}) {
        text += "o strip" + std::to_string(strip + 1) + "\n";
        for (const int side : {0, 1}) {
            for (int k = 0; k <= columns; ++k) {
                const Eigen::Vector3d p = onStrip(k, 3 * kEdge * (strip + side));
                text += 'v';
                for (const double x : p) {
                    text += ' ';
                    appendFixed(text, x, 6);
                }
                text += '\n';
            }
        }
        const int first = 1 + strip * 2 * (columns + 1);
        for (int k = 0; k < columns; ++k) {
            const int a = first + k, b = a + columns + 1;
            const std::array<int, 6> corners = k % 2 == 0
                                                   ? std::array{a, a + 1, b + 1, a, b + 1, b}
                                                   : std::array{a, a + 1, b, a + 1, b + 1, b};
            for (int c = 0; c < 6; ++c) {
                text += (c % 3 == 0 ? "f " : " ") + std::to_string(corners[c]);
                text += c % 3 == 2 ? "\n" : "";
            }
        }
    }
    return text;
}

/// A flat ring of one row of squares, whose inner rim has as many vertices as its outline: the hole
/// stays open.
MeshArrays ringMesh(int vertices) {
    const int around = vertices / 2;
    MeshArrays mesh{Points3(2 * around, 3), Triangles(2 * around, 3)};
    for (int k = 0; k < around; ++k) {
        const double angle = 2 * std::numbers::pi * k / around;
        const double radius = kEdge * around / (2 * std::numbers::pi);
        for (const int rim : {0, 1}) {
            const double r = radius + (rim == 0 ? 0 : -2 * kEdge);
            mesh.V.row(2 * k + rim) << r * std::cos(angle), r * std::sin(angle), 0;
        }
        const int a = 2 * k, b = 2 * ((k + 1) % around);
        mesh.F.row(2 * k) << a, b, b + 1;
        mesh.F.row(2 * k + 1) << a, b + 1, a + 1;
    }
    return mesh;
}

/// All that the stages work on.
struct Strips {
    std::filesystem::path file;
    std::shared_ptr<const Garment> garment;
    PieceResults results;
    Piece ring;

    const Piece& piece() const { return *garment->pieces.front(); }
    const Points2& Q() const { return results.front()->flat->Q; }
    Eigen::VectorXd lengths() const { return boundaryLengths3d(piece().mesh.V, piece().boundary); }
    BoundaryProblem problem() const {
        return {lengths() / lengths().sum(), boundaryAngles3d(piece().mesh, piece().boundary)};
    }
};

const Strips& stripsOf(int vertices) {
    static std::map<int, Strips> kept;
    Strips& strips = kept[vertices];
    if (!strips.garment) {
        strips.file = temporaryFolder() / ("strips" + std::to_string(vertices) + ".obj");
        orFail(writeFile(strips.file, stripsText(vertices)));
        Progress progress;
        strips.garment = std::make_shared<const Garment>(
            orFail(loadGarment({strips.file}, {LengthUnit::Millimetre}, progress)));
        FlattenOptions options;
        options.method = Method::Curvature;
        strips.results = flattenGarment(*strips.garment, options, progress);
        strips.ring = makePiece("ring", ringMesh(vertices));
    }
    return strips;
}

/// A motion of an edge's length here and there, however long the strips.
Points2 unevenStep(const Strips& strips) {
    Points2 P = Points2::Zero(strips.Q().rows(), 2);
    for (Eigen::Index v = 0; v < P.rows(); ++v) {
        P(v, 1) = kEdge * std::sin(static_cast<double>(v));
    }
    return P;
}

void flattenBy(const Piece& piece, Method method) {
    FlattenOptions options;
    options.method = method;
    const FlatPiece flat = orFail(flatten(piece, options, Progress()));
    benchmark::DoNotOptimize(flat.Q.data());
}

void exportAs(const Strips& strips, const std::string& format) {
    orFail(exportFile(temporaryFolder() / ("strips." + format),
                      {*strips.garment, strips.results, inRows(*strips.garment, strips.results)}));
}

/// What the stages are, by their names in kOutlineStages.
const std::map<std::string, std::function<void(const Strips&)>> kStages = {
    {"load",
     [](const Strips& s) {
         Progress progress;
         benchmark::DoNotOptimize(loadGarment({s.file}, {LengthUnit::Millimetre}, progress));
     }},
    {"seams", [](const Strips& s) { benchmark::DoNotOptimize(findSeams(s.garment->pieces)); }},
    {"circle", [](const Strips& s) { benchmark::DoNotOptimize(circleOutline(s.lengths())); }},
    {"newton",
     [](const Strips& s) {
         benchmark::DoNotOptimize(solveBoundaryNewton(s.problem(), Progress()));
     }},
    {"slcp",
     [](const Strips& s) { benchmark::DoNotOptimize(solveBoundarySlcp(s.problem(), Progress())); }},
    {"bending",
     [](const Strips& s) {
         const EdgeLoops loops(s.piece().boundary);
         const isometric::OutlineBending bending(
             loops, boundaryAngles3d(s.piece().mesh, loops.vertices()), s.lengths(), 0.02);
         Points2 gradient = Points2::Zero(s.Q().rows(), 2);
         bending.addGradient(s.Q(), gradient);
         benchmark::DoNotOptimize(bending.energy(s.Q()));
     }},
    {"barrier",
     [](const Strips& s) {
         const isometric::OutlineBarrier barrier(s.piece().boundary, s.lengths());
         benchmark::DoNotOptimize(barrier.contacts(s.Q()));
         benchmark::DoNotOptimize(barrier.largestStep(s.Q(), unevenStep(s), 1));
     }},
    {"lengths",
     [](const Strips& s) {
         Points2 Q = s.Q() + 1e-3 * unevenStep(s);
         benchmark::DoNotOptimize(LengthConstraints(s.piece().boundary, s.lengths()).restore(Q));
     }},
    {"curvature", [](const Strips& s) { flattenBy(s.piece(), Method::Curvature); }},
    {"isometric", [](const Strips& s) { flattenBy(s.piece(), Method::Isometric); }},
    {"rims", [](const Strips& s) { flattenBy(s.ring, Method::Isometric); }},
    {"crossings",
     [](const Strips& s) {
         benchmark::DoNotOptimize(outlineCrossings(s.Q(), s.piece().boundary));
     }},
    {"measure", [](const Strips& s) { benchmark::DoNotOptimize(measure(s.piece(), s.Q())); }},
    {"sheet", [](const Strips& s) { benchmark::DoNotOptimize(inRows(*s.garment, s.results)); }},
    {"check",
     [](const Strips& s) {
         CutPlan plan;
         plan.garment = s.garment;
         plan.results = s.results;
         plan.options.method = Method::Curvature;
         benchmark::DoNotOptimize(readyToCut(plan));
     }},
    {"svg", [](const Strips& s) { exportAs(s, "svg"); }},
    {"dxf", [](const Strips& s) { exportAs(s, "dxf"); }},
    {"obj", [](const Strips& s) { exportAs(s, "obj"); }},
    {"json", [](const Strips& s) { exportAs(s, "json"); }},
};

void measureStage(benchmark::State& state, const std::string& stage, int vertices) {
    const Strips& strips = stripsOf(vertices);
    const auto& run = kStages.at(stage);
    for (auto _ : state) {
        run(strips);
    }
    state.counters["vertices"] = static_cast<double>(strips.piece().boundary.size());
}

}  // namespace

void registerOutline(const Scope& scope) {
    for (const std::string stage : kOutlineStages) {
        for (const std::string vertices : kOutlineSizes) {
            if (scope.allows(vertices)) {
                auto* added = benchmark::RegisterBenchmark(
                    ("outline/" + stage + "/" + vertices).c_str(),
                    [stage, count = std::stoi(vertices)](benchmark::State& state) {
                        measureStage(state, stage, count);
                    });
                measured(added, 3);
            }
        }
    }
}

}  // namespace toile::bench
