// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "app/views/tool.h"
#include "core/cut/surface_point.h"
#include "core/garment/garment.h"

namespace toile::app {

/// A place on the garment under the pointer.
struct ClothPoint {
    /// What the pointer snapped to.
    enum class On {
        Cloth,   ///< nothing: the exact place
        Rim,     ///< an edge of the piece
        Corner,  ///< a corner of its outline
        Own,     ///< an earlier place of the same tool
    };

    int piece = -1;   ///< index into the garment's pieces
    SurfacePoint at;  ///< on its mesh
    On on = On::Cloth;
    int own = -1;  ///< index of the earlier place, if snapped to one

    bool isOnRim() const { return on == On::Rim || on == On::Corner; }
};

inline bool samePlace(const SurfacePoint& a, const SurfacePoint& b) {
    return a.face == b.face && a.barycentric == b.barycentric;
}

/// The boundary edges of a piece, disk or not.
struct PieceRim {
    std::vector<int> uses;      ///< 3 * face + k, the side from corner k to corner k + 1
    std::set<int> corners;      ///< vertices where the outline turns sharply (`outlineCorners`)
    std::vector<char> isOnRim;  ///< per vertex
};

PieceRim rimOf(const Piece& piece);

/// Finds the place on the cloth that the pointer means. Snaps to earlier places, corners and rims
/// within some pixels, even from beside the cloth. Caches the rims. Cost: that of `hitAt` plus the
/// piece's rim; beside the cloth, the rims of all pieces.
class ClothSnapper {
public:
    /// @param own  earlier places of the tool
    std::optional<ClothPoint> find(const ToolView& view, const Garment& garment, const QPointF& at,
                                   std::span<const ClothPoint> own);
    const PieceRim& rim(const std::shared_ptr<const Piece>& piece);
    /// Drops cached rims of pieces that are not in the garment; null: all.
    void keep(const Garment* garment);

private:
    std::map<std::shared_ptr<const Piece>, PieceRim> rims_;
};

}  // namespace toile::app
