// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/cholmod_state.h"

#include <omp.h>

#include "core/linalg/blas_kernels.h"

namespace toile {

void boundThreads() {
    omp_set_max_active_levels(0);
    useOneBlasThread();
}

CholmodState::CholmodState() {
    boundThreads();
    cholmod_start(&common);
    common.print = 0;  // errors are values here, not text on a terminal
    common.error_handler = nullptr;
    // Minimum degree at all sizes: CHOLMOD would otherwise try METIS above a fill threshold, which
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
    common.final_ll = 1;  // L L^T: an indefinite matrix is refused, not factorised
}

CholmodState::~CholmodState() {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
}

Result<void> CholmodState::analyse(const SymmetricMatrix& pattern) {
    cholmod_free_factor(&factor, &common);
    cholmod_sparse view = viewOf(pattern);
    factor = cholmod_analyze(&view, &common);
    if (factor == nullptr) {
        return Error{ErrorCode::OutOfMemory, "", "ordering"};
    }
    return {};
}

Result<void> CholmodState::factorise(const SymmetricMatrix& matrix) {
    cholmod_sparse view = viewOf(matrix);
    cholmod_factorize(&view, factor, &common);
    if (common.status == CHOLMOD_NOT_POSDEF || factor->minor < factor->n) {
        return Error{ErrorCode::FactorisationFailed, "", "the matrix is not positive definite"};
    }
    if (common.status < CHOLMOD_OK) {
        return Error{ErrorCode::OutOfMemory, "", "factorising"};
    }
    return {};
}

std::size_t CholmodState::bytes() const {
    if (factor == nullptr) {
        return 0;
    }
    const std::size_t entries = factor->is_super != 0
                                    ? sizeof(double) * factor->xsize + sizeof(int) * factor->ssize
                                    : (sizeof(double) + sizeof(int)) * factor->nzmax;
    return entries + 4 * sizeof(int) * factor->n;
}

cholmod_sparse viewOf(const SymmetricMatrix& matrix) {
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

}  // namespace toile
