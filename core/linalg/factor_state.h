// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/linalg/cholmod_state.h"
#include "core/linalg/factor_view.h"
#include "core/linalg/sparse_cholesky.h"

// For the sources of this folder only, as it shows CHOLMOD.
namespace toile {

struct SparseCholesky::State {
    CholmodState plain;

    /// Nothing where there is no factor yet, or one of a kind that cannot be read.
    std::optional<FactorView> view() const;
    /// Operations of the factorisation.
    double work() const { return plain.common.fl; }
};

}  // namespace toile
