// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/base/progress.h"
#include "core/garment/piece.h"
#include "core/symmetry/mirror_plane.h"

namespace toile {

/// Openings of a garment for parts of the body.
enum class OpeningKind { Neck, Waist, Hem, Cuff, Ankle, Armhole, Other };

struct BodyOpening {
    OpeningKind kind = OpeningKind::Other;
    RimLoop loop;
    Eigen::Vector3d centre{0, 0, 0};  ///< mean of the rim, by length
    int partner = -1;                 ///< the opening on the other side; -1 for middle ones
};

enum class BodyForm {
    Top,       ///< trunk with a neck or a waist, a hem, and two sleeves or armholes
    Trousers,  ///< a waist and two legs
    Skirt,     ///< a tube with a waist and a hem
    Unknown,
};

/// A garment as worn, recognised from its shape alone.
struct GarmentBody {
    MirrorPlane plane;                 ///< between left and right; deviation is infinite if unknown
    Eigen::Vector3d up{0, 1, 0};       ///< in the plane
    Eigen::Vector3d forward{0, 0, 1};  ///< unit, in the plane, perpendicular to `up`; a guess
    BodyForm form = BodyForm::Unknown;
    std::vector<BodyOpening> openings;

    /// Signed distance from the mirror plane, mm.
    double across(const Eigen::Vector3d& p) const { return plane.normal.dot(p) - plane.offset; }
    double height(const Eigen::Vector3d& p) const { return up.dot(p); }
    /// Whether positive `across` is the wearer's left.
    bool isLeftAcross() const { return up.cross(forward).dot(plane.normal) > 0; }
    /// The first opening of a kind, or null.
    const BodyOpening* find(OpeningKind kind) const;
    /// Both openings of a kind: first the one with negative `across`.
    std::optional<std::array<const BodyOpening*, 2>> pair(OpeningKind kind) const;
};

/// Recognises the body of one connected surface. Rims longer than 80 mm are openings: middle ones,
/// which the plane divides, and pairs. The highest middle one is neck or waist, the lowest the hem,
/// unless two openings below the garment's middle are legs. The front is the side where the neck is
/// lower; this is wrong for garments with a low back.
/// @param piece  mm, y up; oriented, manifold
/// @param isFrontSwapped  the user says that the front is opposite to the guess
/// @return nothing without a mirror plane
/// Cost: that of `findMirrorPlane`. Deterministic. Pure.
std::optional<GarmentBody> readBody(const std::shared_ptr<const Piece>& piece,
                                    const Progress& progress = {}, bool isFrontSwapped = false);

}  // namespace toile
