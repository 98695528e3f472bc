// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

#include "core/linalg/sparse_cholesky.h"

// For the sources of this folder only: no header outside shows CHOLMOD.
namespace toile {

/// CHOLMOD's workspace and the factor made with it.
struct SparseCholesky::State {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;

    State();
    ~State();
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

/// CHOLMOD's view of our arrays; it reads them and keeps nothing.
cholmod_sparse viewOf(const SymmetricMatrix& matrix);

}  // namespace toile
