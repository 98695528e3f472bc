// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/linalg/cholmod_state.h"
#include "core/linalg/divided_factor.h"
#include "core/linalg/factor_view.h"
#include "core/linalg/sparse_cholesky.h"

// For the sources of this folder only, as it shows CHOLMOD.
namespace toile {

/// The factor, whole or divided.
struct SparseCholesky::State {
    CholmodState plain;
    std::unique_ptr<DividedFactor> divided;  ///< takes the place of the plain one where it is there

    /// Nothing where there is no factor yet, or one of a kind that cannot be read.
    std::optional<FactorView> view() const;
    /// Operations of the factorisation.
    double work() const { return divided ? divided->work() : plain.common.fl; }
};

}  // namespace toile
