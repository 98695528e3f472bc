// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/floor.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <Eigen/Geometry>
#include <cholmod.h>
#include <omp.h>

#include "core/base/progress.h"

#ifdef __ELF__
// Present where OpenBLAS stands in for the BLAS; declared weak because it need not.
extern "C" void openblas_set_num_threads(int count) __attribute__((weak));
#else
static void (*const openblas_set_num_threads)(int) = nullptr;
#endif

namespace toile::bench {
namespace {

/// While it lives, CHOLMOD and the BLAS use the threads they like.
class ThreadsOf {
public:
    explicit ThreadsOf(bool bounded) { set(bounded); }
    ~ThreadsOf() { set(true); }
    ThreadsOf(const ThreadsOf&) = delete;
    ThreadsOf& operator=(const ThreadsOf&) = delete;

private:
    static void set(bool bounded) {
        omp_set_max_active_levels(bounded ? 0 : 1);
        if (openblas_set_num_threads != nullptr) {
            openblas_set_num_threads(bounded ? 1 : omp_get_num_procs());
        }
    }
};

/// Supernodes of up to so many columns are merged where so large a part of the result is zeros:
/// measured to suit triangle meshes.
constexpr std::size_t kRelaxedColumns[] = {8, 24, 64};
constexpr double kRelaxedZeros[] = {0.8, 0.2, 0.1};

/// CHOLMOD's workspace and what is made with it.
struct Cholmod {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;

    explicit Cholmod(const FloorCandidate& candidate) {
        cholmod_start(&common);
        common.print = 0;
        common.nmethods = 1;
        common.method[0].ordering = candidate.ordering;
        common.supernodal = candidate.supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
        if (candidate.relaxed) {
            std::ranges::copy(kRelaxedColumns, common.nrelax);
            std::ranges::copy(kRelaxedZeros, common.zrelax);
        }
    }
    ~Cholmod() {
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;

    void check(bool fine) const {
        if (common.status == CHOLMOD_NOT_POSDEF) {
            throw std::runtime_error("the matrix is not positive definite");
        }
        if (!fine || common.status < CHOLMOD_OK) {
            throw std::runtime_error("CHOLMOD failed");
        }
    }
};

/// Half the cotangents of the angles opposite to each edge, summed.
std::vector<double> edgeWeights(const Piece& piece) {
    const MeshArrays& mesh = piece.mesh;
    std::vector<double> weight(static_cast<std::size_t>(piece.table.edges.rows()), 0.0);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const std::array<Eigen::Vector3d, 3> p{mesh.V.row(mesh.F(f, 0)).transpose(),
                                               mesh.V.row(mesh.F(f, 1)).transpose(),
                                               mesh.V.row(mesh.F(f, 2)).transpose()};
        const double fourAreas = 2 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d& opposite = p[(k + 2) % 3];
            weight[piece.table.faceEdges(f, static_cast<int>(k))] +=
                (p[k] - opposite).dot(p[(k + 1) % 3] - opposite) / fourAreas;
        }
    }
    return weight;
}

cholmod_sparse viewOf(linalg::SymmetricMatrix& system) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(system.size);
    view.nzmax = system.row.size();
    view.p = system.columnStart.data();
    view.i = system.row.data();
    view.x = system.value.data();
    view.stype = -1;  // lower triangle stored
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    return view;
}

void solve(Cholmod& cholmod, int size, std::size_t columns) {
    cholmod_dense* right =
        cholmod_ones(static_cast<std::size_t>(size), columns, CHOLMOD_REAL, &cholmod.common);
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, cholmod.factor, right, &cholmod.common);
    cholmod.check(x != nullptr);
    cholmod_free_dense(&x, &cholmod.common);
    cholmod_free_dense(&right, &cholmod.common);
}

}  // namespace

linalg::SymmetricMatrix assembleFloor(const Piece& piece) {
    const Edges& edges = piece.table.edges;
    const std::vector<double> weight = edgeWeights(piece);
    std::vector<int> unknown(static_cast<std::size_t>(piece.mesh.V.rows()), 0);
    for (const int v : piece.boundary) {
        unknown[v] = -1;
    }
    int size = 0;
    for (int& u : unknown) {
        u = u < 0 ? -1 : size++;
    }
    std::vector<double> diagonal(static_cast<std::size_t>(size), 0.0);
    linalg::SymmetricMatrix system;
    system.size = size;
    system.columnStart.assign(static_cast<std::size_t>(size) + 1, 1);
    system.columnStart[0] = 0;
    for (int e = 0; e < edges.rows(); ++e) {
        const int i = unknown[edges(e, 0)], j = unknown[edges(e, 1)];
        if (i >= 0) {
            diagonal[i] += weight[e];
        }
        if (j >= 0) {
            diagonal[j] += weight[e];
        }
        if (i >= 0 && j >= 0) {
            ++system.columnStart[i + 1];
        }
    }
    for (int i = 0; i < size; ++i) {
        system.columnStart[i + 1] += system.columnStart[i];
    }
    const auto entries = static_cast<std::size_t>(system.columnStart.back());
    system.row.resize(entries);
    system.value.resize(entries);
    std::vector<int> next(system.columnStart.begin(), system.columnStart.end() - 1);
    for (int i = 0; i < size; ++i) {
        system.row[next[i]] = i;
        system.value[next[i]++] = diagonal[i];
    }
    for (int e = 0; e < edges.rows(); ++e) {  // sorted, so rows come out ascending
        const int i = unknown[edges(e, 0)], j = unknown[edges(e, 1)];
        if (i >= 0 && j >= 0) {
            system.row[next[i]] = j;
            system.value[next[i]++] = -weight[e];
        }
    }
    return system;
}

std::span<const FloorCandidate> floorCandidates() {
    constexpr int kSimplicialUpTo = 100000;
    static const std::vector<FloorCandidate> candidates{
        {"amd-simplicial", CHOLMOD_AMD, false, false, false, kSimplicialUpTo},
        {"amd-supernodal", CHOLMOD_AMD, true},
        {"amd-relaxed", CHOLMOD_AMD, true, true},
        {"metis-relaxed", CHOLMOD_METIS, true, true, true},
    };
    return candidates;
}

FloorTimes runFloor(const Piece& piece, const FloorCandidate& candidate) {
    const ThreadsOf threads(candidate.boundedThreads);
    FloorTimes times;
    const Stopwatch assembling;
    linalg::SymmetricMatrix system = assembleFloor(piece);
    cholmod_sparse matrix = viewOf(system);
    times.assemble = assembling.seconds();
    if (system.size == 0) {
        return times;  // a strip whose vertices all lie on the outline
    }

    const Stopwatch analysing;
    Cholmod cholmod(candidate);
    cholmod.factor = cholmod_analyze(&matrix, &cholmod.common);
    cholmod.check(cholmod.factor != nullptr);
    times.analyse = analysing.seconds();

    const Stopwatch factorising;
    cholmod.check(cholmod_factorize(&matrix, cholmod.factor, &cholmod.common) != 0);
    times.factorise = factorising.seconds();

    const Stopwatch solving;
    solve(cholmod, system.size, 1);
    solve(cholmod, system.size, 2);
    times.solve = solving.seconds();
    return times;
}

}  // namespace toile::bench
