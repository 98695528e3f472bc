// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sew/cloth.h"

namespace toile::sew {

/// A start for fine cloth from where coarse cloth of the same pattern has settled: each vertex
/// moves as the nearest place of the coarse one has, both seen where `Cloth::X` has them. To be
/// settled on from there with `SettleOptions::heldFirst` false: most of the way is gone at a
/// fraction of the cost.
/// @param X  of the coarse cloth's vertices, mm
/// Precondition: the coarse cloth has triangles. Cost: n log n. Pure.
Points3 carriedOver(const Cloth& coarse, const Points3& X, const Cloth& fine);

}  // namespace toile::sew
