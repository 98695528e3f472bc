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

/// Where a body, or a part of it, comes out of a garment.
enum class OpeningKind { Neck, Waist, Hem, Cuff, Ankle, Armhole, Other };

struct BodyOpening {
    OpeningKind kind = OpeningKind::Other;
    RimLoop loop;
    Eigen::Vector3d centre{0, 0, 0};  ///< mean of the rim, by length
    int partner = -1;                 ///< the opening on the other side; -1 of middle ones
};

enum class BodyForm {
    Top,       ///< trunk with a neck or a waist, a hem, and two sleeves or armholes
    Trousers,  ///< a waist and two legs
    Skirt,     ///< a tube with a waist and a hem
    Unknown,
};

/// A garment as it is worn, read from its shape alone.
struct GarmentBody {
    MirrorPlane plane;            ///< between left and right; deviation may be unknown: infinite
    Eigen::Vector3d up{0, 1, 0};  ///< in the plane
    Eigen::Vector3d forward{0, 0, 1};  ///< unit, in the plane, at right angles to `up`; a guess
    BodyForm form = BodyForm::Unknown;
    std::vector<BodyOpening> openings;

    /// Signed distance from the mirror plane, mm.
    double across(const Eigen::Vector3d& p) const { return plane.normal.dot(p) - plane.offset; }
    double height(const Eigen::Vector3d& p) const { return up.dot(p); }
    /// Whether the wearer's left is where `across` is above 0.
    bool isLeftAcross() const { return up.cross(forward).dot(plane.normal) > 0; }
    /// The first opening of a kind, or null.
    const BodyOpening* find(OpeningKind kind) const;
    /// Both openings of a kind: of the side with `across` below 0, and the other.
    std::optional<std::array<const BodyOpening*, 2>> pair(OpeningKind kind) const;
};

/// Reads the body of one connected surface. Rims longer than 80 mm are openings: middle ones, which
/// the plane divides, and pairs. The highest middle one is neck or waist, the lowest the hem,
/// unless two below the garment's middle are legs. The front is where the neck is lowest, which is
/// wrong where a back is low.
/// @param piece  mm, y up; oriented, manifold
/// @param isFrontSwapped  a person says that the front is on the other side than is guessed
/// @return none where there is no mirror plane
/// Cost: that of `findMirrorPlane`. Deterministic. Pure.
std::optional<GarmentBody> readBody(const std::shared_ptr<const Piece>& piece,
                                    const Progress& progress = {}, bool isFrontSwapped = false);

}  // namespace toile
