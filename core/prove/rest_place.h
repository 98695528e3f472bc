// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/prove/fresh_mesh.h"

namespace toile::prove {

/// Where the points of a flat mesh lie in another plane in which some of them are given: each of
/// the rest in the middle of its neighbours, by cotangent weights, so that a plane's own motion and
/// stretch goes on between them ([DMA02]'s harmonic map).
/// @param given  the places of the first points  Errors: FactorisationFailed, OutOfMemory.
/// Cost: one factorisation. Pure.
Result<Points2> harmonicPlaces(const FreshMesh& mesh, const Points2& given);

}  // namespace toile::prove
