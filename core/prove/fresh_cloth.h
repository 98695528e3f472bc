// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/garment/garment.h"
#include "core/prove/proof.h"
#include "core/sew/cloth.h"

namespace toile::prove {

/// A pattern as sewn cloth, at the position of the design.
struct FreshCloth {
    sew::Cloth cloth;
    /// Per piece of the garment and vertex of it: its place on the cloth's triangles; empty if the
    /// piece has no cloth.
    std::vector<std::vector<SurfacePoint>> placeOf;
    std::vector<ProvenSeam> seams;  ///< without their strain
    std::vector<Finding> faults;
    Wording source;
};

/// Errors: NoGeometry, NotReadBack, Cancelled.
Result<FreshCloth> freshCloth(const ExportSource& source, const ProofOrder& order,
                              const Progress& progress);

/// The surface of the designed garment: its pieces, joined along their seams
/// (`sew::cutAlongSeams`), all oriented like the first of those joined to each other.
/// Errors: NoGeometry.  Cost: that of joining. Pure.
Result<MeshArrays> designSurface(const Garment& garment);

}  // namespace toile::prove
