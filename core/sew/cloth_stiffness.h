// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::sew {

/// How cloth resists being deformed: the tangent moduli at rest of an orthotropic sheet.
struct ClothStiffness {
    double weft = 1000;     ///< force per width and strain along the weft, N/m
    double warp = 1000;     ///< along the warp, N/m
    double coupling = 300;  ///< of one in the other (C12), N/m; below the mean of the two
    double shear = 350;     ///< force per width and shear angle, N/m
    double bending = 1e-5;  ///< moment per width and curvature, N·m

    bool operator==(const ClothStiffness&) const = default;
};

/// A sheet that is alike in all directions. @param stretch  E h, N/m  @param poisson  in [0, 1)
constexpr ClothStiffness isotropicStiffness(double stretch, double poisson, double bending) {
    const double along = stretch / (1 - poisson * poisson);
    return {along, along, poisson * along, stretch / (2 * (1 + poisson)), bending};
}

/// What stands in where nothing is known of the fabric; not measured. Woven ones shear far more
/// easily than this; a sheet alike in all directions favours no grain.
inline constexpr ClothStiffness kUnstatedStiffness = isotropicStiffness(1000, 0.3, 1e-5);

}  // namespace toile::sew
