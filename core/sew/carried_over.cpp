// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/carried_over.h"

#include "core/cut/surface_point.h"

namespace toile::sew {

Points3 carriedOver(const Cloth& coarse, const Points3& X, const Cloth& fine) {
    const MeshArrays form = coarse.surface();
    const NearestSurface nearest(form);
    Points3 start = fine.X;
    for (Eigen::Index v = 0; v < start.rows(); ++v) {
        const SurfacePoint place = nearest.find(fine.X.row(v).transpose());
        for (int k = 0; k < 3; ++k) {
            const int corner = coarse.F(place.face, k);
            start.row(v) += place.barycentric[k] * (X.row(corner) - coarse.X.row(corner));
        }
    }
    return start;
}

}  // namespace toile::sew
