// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's maps next to ours. CGAL's parameterisation is GPL, its Surface_mesh too: only this file,
// of an optional benchmark, knows them.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/version.h>

#include "core/quality/measures.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/report/bars.h"

namespace toile::bench {
namespace {

namespace parameterization = CGAL::Surface_mesh_parameterization;

// As in the examples of CGAL's manual.
using Kernel = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = SurfaceMesh::Vertex_index;
using FlatPoints = SurfaceMesh::Property_map<Vertex, Kernel::Point_2>;
using Border = parameterization::Two_vertices_parameterizer_3<SurfaceMesh>;
using Lscm = parameterization::LSCM_parameterizer_3<SurfaceMesh, Border>;
using Arap = parameterization::ARAP_parameterizer_3<SurfaceMesh, Border>;

constexpr unsigned kIterations = 50;
constexpr double kNoTolerance = 0;  // then ARAP does all its iterations
constexpr double kLambda = 1000;    // CGAL's default weight of rigidity

SurfaceMesh surfaceMesh(const MeshArrays& mesh) {
    SurfaceMesh result;
    const auto vertices = static_cast<SurfaceMesh::size_type>(mesh.V.rows());
    const auto faces = static_cast<SurfaceMesh::size_type>(mesh.F.rows());
    result.reserve(vertices, vertices + faces, faces);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        result.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
    }
    const auto vertex = [](int v) { return Vertex(static_cast<SurfaceMesh::size_type>(v)); };
    for (int f = 0; f < mesh.F.rows(); ++f) {
        result.add_face(vertex(mesh.F(f, 0)), vertex(mesh.F(f, 1)), vertex(mesh.F(f, 2)));
    }
    return result;
}

/// The result scaled so that its outline is as long as in 3D.
Points2 scaled(const Piece& piece, const FlatPoints& points) {
    Points2 Q(piece.mesh.V.rows(), 2);
    for (int v = 0; v < Q.rows(); ++v) {
        const Kernel::Point_2& p = points[Vertex(static_cast<SurfaceMesh::size_type>(v))];
        Q.row(v) << p.x(), p.y();
    }
    const double wanted = boundaryLengths3d(piece.mesh.V, piece.boundary).sum();
    Q *= wanted / boundaryLengths2d(Q, piece.boundary).sum();
    const Eigen::VectorXd areas = triangleAreas2d(Q, piece.mesh.F);
    if (areas.sum() < 0) {
        Q.col(0) *= -1;  // it came out mirrored
    }
    return Q;
}

/// While it lives, what CGAL prints on its way goes nowhere.
class Silence {
public:
    Silence() : out_(std::cout.rdbuf(nowhere_.rdbuf())), err_(std::cerr.rdbuf(nowhere_.rdbuf())) {}
    ~Silence() {
        std::cout.rdbuf(out_);
        std::cerr.rdbuf(err_);
    }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

private:
    std::ostringstream nowhere_;
    std::streambuf* out_;
    std::streambuf* err_;
};

/// How far boundary edges are from their 3D length, root mean square over the outline.
double outlineStrain(const Piece& piece, const Points2& Q) {
    const Eigen::ArrayXd wanted = boundaryLengths3d(piece.mesh.V, piece.boundary).array();
    const Eigen::ArrayXd found = boundaryLengths2d(Q, piece.boundary).array();
    return std::sqrt((wanted * (found / wanted - 1).square()).sum() / wanted.sum());
}

/// @param makeParameterizer  as CGAL's default, or with stated options
template <class MakeParameterizer>
void measurePeer(benchmark::State& state, const std::string& name,
                 const MakeParameterizer& makeParameterizer) {
    const Piece& piece = *piecesOf(name).front();
    SurfaceMesh mesh = surfaceMesh(piece.mesh);
    const FlatPoints points =
        mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv", Kernel::Point_2(0, 0)).first;
    for (auto _ : state) {
        const Silence silence;
        const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
        auto parameterizer = makeParameterizer();
        if (parameterization::parameterize(mesh, parameterizer, border, points) !=
            parameterization::OK) {
            state.SkipWithError("CGAL could not flatten it");
            return;
        }
    }
    const Points2 Q = scaled(piece, points);
    const Eigen::VectorXd areas = triangleAreas2d(Q, piece.mesh.F);
    const Eigen::VectorXd worn = triangleAreas3d(piece.mesh);
    state.counters["triangles"] = static_cast<double>(piece.mesh.F.rows());
    state.counters["flips"] = flippedTriangles(areas, worn);
    state.counters["strayed"] = outlineStrain(piece, Q);
    const auto energy = symmetricDirichlet(singularValues(piece.mesh, Q), worn, areas);
    if (energy && std::isfinite(*energy)) {
        state.counters["energy"] = *energy;
    }
}

void add(const std::string& what, const std::string& piece, int repetitions) {
    const bool lscm = what == "cgalLscm";
    auto* added = benchmark::RegisterBenchmark(
        (what + "/" + piece).c_str(), [piece, lscm](benchmark::State& state) {
            if (lscm) {
                measurePeer(state, piece, [] { return Lscm(); });
            } else {
                measurePeer(state, piece, [] {
                    return Arap(Border(), Arap::Solver_traits(), kLambda, kIterations,
                                kNoTolerance);
                });
            }
        });
    measured(added, repetitions);
}

}  // namespace

void registerPeers(const Scope& scope) {
    benchmark::AddCustomContext("CGAL", CGAL_VERSION_STR);
    for (const std::string surface : kSurfaces) {
        add("cgalLscm", surface + "/3000", 5);
        add("cgalArap", surface + "/3000", scope.quick ? 1 : 3);
        if (!scope.quick) {
            add("cgalLscm", surface + "/45000", 3);
            add("cgalArap", surface + "/45000", 2);
            if (scope.slowPeers) {
                add("cgalLscm", surface + "/500000", 2);
            }
        }
    }
}

}  // namespace toile::bench
