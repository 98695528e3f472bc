// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/cholmod_workspace.h"

#include <memory>

#include <omp.h>
#ifdef __linux__
#include <sys/mman.h>
#endif

#include "core/linalg/blas_call.h"

namespace toile::linalg {
void useLargePages(double* numbers, std::size_t count) {
#ifdef __linux__
    constexpr std::size_t kPage = std::size_t{2} << 20U;
    void* first = numbers;
    std::size_t bytes = sizeof(double) * count;
    if (first && std::align(kPage, kPage, first, bytes)) {
        madvise(first, bytes / kPage * kPage, MADV_HUGEPAGE);
    }
#else
    static_cast<void>(numbers);
    static_cast<void>(count);
#endif
}

cholmod_sparse cholmodView(const SymmetricMatrix& matrix) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(matrix.size);
    view.nzmax = matrix.row.size();
    view.p = const_cast<int*>(matrix.columnStart.data());
    view.i = const_cast<int*>(matrix.row.data());
    view.x = const_cast<double*>(matrix.value.data());
    view.stype = -1;  // lower triangle stored
    view.itype = CHOLMOD_INT;
    view.xtype = matrix.value.empty() ? CHOLMOD_PATTERN : CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

CholmodWorkspace::CholmodWorkspace() {
    // CHOLMOD opens four OpenMP threads per large supernode, whatever the machine has. Pieces are
    // solved in parallel already, so allow no parallel regions on the calling thread.
    omp_set_max_active_levels(0);
    useOneBlasThread();
    cholmod_start(&common);
    common.print = 0;  // errors are returned as values, not printed
    common.error_handler = nullptr;
    // Minimum degree, or a given order: otherwise CHOLMOD tries METIS above a fill threshold, which
    // never pays for a few solves (the floor's table in docs/performance.md).
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
    // Larger blocks than by default, with more zeros in them: a tenth less time on meshes of
    // 45 000 to a million triangles.
    common.supernodal = CHOLMOD_AUTO;
    common.nrelax[0] = 8;
    common.nrelax[1] = 24;
    common.nrelax[2] = 64;
    common.zrelax[0] = 0.8;
    common.zrelax[1] = 0.2;
    common.zrelax[2] = 0.1;
    common.final_ll = 1;  // L L^T: rejects indefinite matrices
}

CholmodWorkspace::~CholmodWorkspace() {
    cholmod_finish(&common);
}

}  // namespace toile::linalg
