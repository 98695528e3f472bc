// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

#include "core/linalg/sparse_cholesky.h"

// For the sources of this folder only: no header outside shows CHOLMOD.
namespace toile {

/// CHOLMOD's workspace and the factor made with it.
struct CholmodState {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;

    CholmodState();
    ~CholmodState();
    CholmodState(const CholmodState&) = delete;
    CholmodState& operator=(const CholmodState&) = delete;

    /// Errors: OutOfMemory.
    Result<void> analyse(const SymmetricMatrix& pattern);
    /// Errors: FactorisationFailed (not positive definite), OutOfMemory.
    Result<void> factorise(const SymmetricMatrix& matrix);
    /// About what the factor takes in memory.
    std::size_t bytes() const;
};

/// CHOLMOD opens four OpenMP threads per large supernode, whatever the machine has. Pieces are
/// solved side by side already: no parallel regions, on the calling thread, from now on.
void boundThreads();

/// CHOLMOD's view of our arrays; it reads them and keeps nothing.
cholmod_sparse viewOf(const SymmetricMatrix& matrix);

}  // namespace toile
