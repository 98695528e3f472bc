// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/prove/line_map.h"
#include "core/prove/proof.h"

namespace toile::prove {

/// The outline of a piece, or the rim of a hole in it, in three states: on the garment, drawn in
/// our pattern, and in the cloth at rest. Places are arc lengths on the garment (`SeamSide`), over
/// any number of turns.
class RestLoop {
public:
    /// @param space  its vertices  @param drawn  measured by arc length on the garment
    /// @param rest   measured along itself  @param map  from `drawn` along itself to `rest`
    RestLoop(Points3 space, geometry::Line drawn, geometry::Line rest, LineMap map);

    double length() const { return drawn_.length(); }
    double apart(double a, double b) const { return space_.apart(a, b); }
    Eigen::RowVector3d spaceAt(double place) const { return space_.pointAt(place); }
    Eigen::RowVector2d drawnAt(double place) const { return drawn_.pointAt(place); }
    Eigen::RowVector2d restAt(double place) const { return rest_.pointAt(restPlace(place)); }
    /// Length along the line at rest, from one place to a later one, mm.
    double restLength(double from, double to) const { return restPlace(to) - restPlace(from); }
    /// Corners of the drawn line.
    const std::vector<double>& corners() const { return corners_; }
    /// Places of the garment's vertices on it, and its end.
    const std::vector<double>& vertices() const { return space_.arc().values(); }

private:
    double restPlace(double place) const { return map_.theirsAt(drawn_.placeOn(along_, place)); }

    geometry::SpaceLine space_;
    geometry::Line drawn_, along_, rest_;
    LineMap map_;
    std::vector<double> corners_;
};

/// A piece of the garment as cloth before sewing.
struct RestPiece {
    Points2 flat;  ///< of the piece's vertices, as `RestLoop` draws them
    /// The outline; then per hole of the piece its rim, or nothing if the cloth has no hole there.
    std::vector<std::optional<RestLoop>> loops;
    std::vector<Points2> others{};  ///< holes of the cloth that the piece lacks, clockwise
    double warp = 0;                ///< its direction in the cloth, radians from x
};

struct RestPattern {
    std::vector<std::optional<RestPiece>> pieces;  ///< one per piece; nothing: it has no cloth
    std::vector<Finding> faults;                   ///< of whole pieces
    Wording source;
};

/// The pattern to prove, matched to our pieces. A pair that the file draws once serves both; a
/// mirrored piece is turned over.
/// Errors: NoGeometry (no piece is the garment's), those of `readPattern`.
Result<RestPattern> restPattern(const ExportSource& source, const ProofOrder& order);

}  // namespace toile::prove
