// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/prove/line_map.h"
#include "core/prove/proof.h"

namespace toile::prove {

/// The outline of a piece, or the rim of a hole in it, three times: on the garment, as it lies in
/// our pattern, and as the cloth has it at rest. Places are arc lengths on the garment
/// (`SeamSide`), over any number of turns.
class RestLoop {
public:
    /// @param space  of its vertices  @param drawn  measured by arc length on the garment
    /// @param rest   measured along itself  @param map  from `drawn` along itself to `rest`
    RestLoop(Points3 space, geometry::Line drawn, geometry::Line rest, LineMap map);

    double length() const { return drawn_.length(); }
    double apart(double a, double b) const { return space_.apart(a, b); }
    Eigen::RowVector3d spaceAt(double place) const { return space_.pointAt(place); }
    Eigen::RowVector2d drawnAt(double place) const { return drawn_.pointAt(place); }
    Eigen::RowVector2d restAt(double place) const { return rest_.pointAt(restPlace(place)); }
    /// Along the line at rest, from one place to a later one, mm.
    double restLength(double from, double to) const { return restPlace(to) - restPlace(from); }
    /// Its corners as it is drawn.
    const std::vector<double>& corners() const { return corners_; }
    /// Those of the garment's vertices on it, and its end.
    const std::vector<double>& vertices() const { return space_.arc().values(); }

private:
    double restPlace(double place) const { return map_.theirsAt(drawn_.placeOn(along_, place)); }

    geometry::SpaceLine space_;
    geometry::Line drawn_, along_, rest_;
    LineMap map_;
    std::vector<double> corners_;
};

/// A piece of the garment as cloth, before it is sewn.
struct RestPiece {
    Points2 flat;  ///< of the piece's vertices, as `RestLoop` draws them
    /// The outline; then per hole of the piece its rim, or nothing where the cloth is whole there.
    std::vector<std::optional<RestLoop>> loops;
    std::vector<Points2> others{};  ///< holes of the cloth that the piece has not, clockwise
    double warp = 0;                ///< its direction there, radians from x
};

struct RestPattern {
    std::vector<std::optional<RestPiece>> pieces;  ///< one per piece; nothing: it has no cloth
    std::vector<ProofFault> faults;                ///< of whole pieces
    Wording source;
};

/// The pattern that is proved, piece by piece beside ours. A pair that the file draws once serves
/// both; a piece that lies mirrored is turned over.
/// Errors: NoGeometry (nothing of it is the garment's), those of `readPattern`.
Result<RestPattern> restPattern(const ExportSource& source, const ProofOrder& order);

}  // namespace toile::prove
