// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <cholmod.h>

#include "core/linalg/sparse_cholesky.h"

namespace toile::linalg {

/// Requests large pages for memory that is about to be written: clearing and mapping small pages
/// takes a tenth of the time of a factorisation.
void useLargePages(double* numbers, std::size_t count);

/// Presents our arrays to CHOLMOD, which reads them and keeps no reference.
cholmod_sparse cholmodView(const SymmetricMatrix& matrix);

/// CHOLMOD's settings and working memory, for one thread at a time. Side effect: OpenMP regions on
/// the calling thread, and OpenBLAS, use one thread from then on.
struct CholmodWorkspace {
    cholmod_common common{};

    CholmodWorkspace();
    ~CholmodWorkspace();
    CholmodWorkspace(const CholmodWorkspace&) = delete;
    CholmodWorkspace& operator=(const CholmodWorkspace&) = delete;
};

}  // namespace toile::linalg
