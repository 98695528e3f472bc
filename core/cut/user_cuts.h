// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/id.h"
#include "core/base/result.h"
#include "core/cut/cut_along.h"
#include "core/cut/surface_paths.h"
#include "core/cut/surface_point.h"

namespace toile {

/// A seam drawn by the user: points in space near the surface. It survives a change of the mesh,
/// since the points are projected onto the surface each time.
struct UserCut {
    enum class Kind {
        Path,  ///< from the first point to the last
        Loop,  ///< back to the first point; three points or more
        Dart,  ///< from the rim to an inner point: the end closer to the rim is moved onto it
    };

    std::string name;
    Kind kind = Kind::Path;
    std::vector<Eigen::Vector3d> points;  ///< mm
    bool alongEdges = false;              ///< between the nearest vertices, along edges
    CutId id{};                           ///< unchanged if points or name change; see `giveIds`
    CutId mirrors{};                      ///< the cut that this one mirrors
    std::string evidence{};  ///< reasons if Toile proposed it; empty: drawn by the user

    bool operator==(const UserCut&) const = default;
};

inline Subject subjectOf(const UserCut& cut) {
    return Subject::cut(cut.name, cut.id);
}

/// Gives every cut without an id a unique one, based on its kind and its points.
void giveIds(std::vector<UserCut>& cuts);

/// The path of a cut between two of its points: see `geodesicPath`, or `edgePath` between the
/// closest vertices. @errors  a cut error if they are not connected; Cancelled
Result<PathPolyline> pathOfCut(const SurfaceLinks& links, const SurfacePoint& from,
                               const SurfacePoint& to, bool alongEdges,
                               const Progress& progress = Progress());

/// The cut's points on the surface, as many as it has. An end of a path within a tenth of a
/// triangle from the rim is moved to it, as is the end of a dart that is closer to it.
/// @errors  a cut error about the cut: too few points, one that is not finite, no rim
/// Cost: one query each, and for a dart all triangles. Pure.
Result<std::vector<SurfacePoint>> pointsOfCut(const SurfaceLinks& links,
                                              const NearestSurface& nearest, const UserCut& cut);

/// The cut's curve on the surface, through its points.
/// @errors  as before; a cut error if the points are not connected; Cancelled
Result<PathPolyline> traceUserCut(const SurfaceLinks& links, const NearestSurface& nearest,
                                  const UserCut& cut, const Progress& progress = Progress());

/// A seam of the garment's own division that the user has removed, joining the cloth on its two
/// sides. Identified by points along it, so that it survives a change of the mesh.
struct UserJoin {
    std::string name;
    /// mm, from one end of the seam to the other, two or more. A seam that is a closed line repeats
    /// its first point at the end and has enough points in between to define its direction.
    std::vector<Eigen::Vector3d> points;

    bool operator==(const UserJoin&) const = default;
};

}  // namespace toile
