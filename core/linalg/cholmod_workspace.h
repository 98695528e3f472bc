// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <cholmod.h>

#include "core/linalg/sparse_cholesky.h"

namespace toile::linalg {

/// Asks for large pages under numbers that are about to be written: that the system hands out small
/// ones, each cleared first, is a tenth of the time of a factorisation.
void useLargePages(double* numbers, std::size_t count);

/// CHOLMOD's view of our arrays; it reads them and keeps nothing.
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
