// SPDX-License-Identifier: GPL-3.0-or-later
// How long it takes to read a garment of 218 000 triangles with its UV map. To reach: Toile's
// reader in at most twice the time of a plain scan of the numbers, and faster than OpenMesh's.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <benchmark/benchmark.h>

#include "core/io/soup.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/panel_file.h"
#include "tests/bench/plain_scan.h"

namespace toile::bench {
namespace {

const PanelFile& panel() {
    static const PanelFile file;
    return file;
}

void countTriangles(benchmark::State& state, std::size_t triangles) {
    if (triangles != 217800) {
        state.SkipWithError("the file was not read as it was written");
    }
    state.counters["triangles/s"] = benchmark::Counter(
        static_cast<double>(triangles), benchmark::Counter::kIsIterationInvariantRate);
}

void plainScan(benchmark::State& state) {
    std::size_t triangles = 0;
    for (auto _ : state) {
        const PlainNumbers numbers = scanPlainly(panel().path());
        triangles = numbers.indices.size() / 6;
        benchmark::DoNotOptimize(numbers);
    }
    countTriangles(state, triangles);
}

void toileReader(benchmark::State& state) {
    std::size_t triangles = 0;
    for (auto _ : state) {
        Progress progress;
        const Result<PolygonSoup> soup = readSoup(panel().path(), progress);
        triangles = soup ? static_cast<std::size_t>(soup.value().faceCount()) : 0;
        benchmark::DoNotOptimize(soup);
    }
    countTriangles(state, triangles);
}

void openMeshReader(benchmark::State& state) {
    omerr().disable();  // it misses the material file, at every round
    std::size_t triangles = 0;
    for (auto _ : state) {
        OpenMesh::TriMesh_ArrayKernelT<> mesh;
        mesh.request_vertex_texcoords2D();
        mesh.request_halfedge_texcoords2D();
        OpenMesh::IO::Options options(OpenMesh::IO::Options::VertexTexCoord |
                                      OpenMesh::IO::Options::FaceTexCoord);
        const bool read = OpenMesh::IO::read_mesh(mesh, panel().path().string(), options);
        triangles = read ? mesh.n_faces() : 0;
        benchmark::DoNotOptimize(mesh);
    }
    countTriangles(state, triangles);
}

}  // namespace

void registerReading(const Scope& scope) {
    const int repetitions = scope.quick ? 5 : 9;
    measured(benchmark::RegisterBenchmark("plainScan", plainScan), repetitions);
    measured(benchmark::RegisterBenchmark("toileReader", toileReader), repetitions);
    measured(benchmark::RegisterBenchmark("openMeshReader", openMeshReader), repetitions);
}

}  // namespace toile::bench
