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

/// A place on the garment that a person points at.
struct ClothPoint {
    /// What the pointer was drawn to.
    enum class On {
        Cloth,   ///< nothing: just where it is
        Rim,     ///< an edge of the piece
        Corner,  ///< a corner of its outline
        Own,     ///< a place pointed at before
    };

    int piece = -1;   ///< index into the garment's pieces
    SurfacePoint at;  ///< on its mesh
    On on = On::Cloth;
    int own = -1;  ///< which place, where drawn to one

    bool isOnRim() const { return on == On::Rim || on == On::Corner; }
};

inline bool samePlace(const SurfacePoint& a, const SurfacePoint& b) {
    return a.face == b.face && a.barycentric == b.barycentric;
}

/// The rim of a piece, disk or not.
struct PieceRim {
    std::vector<int> uses;      ///< 3 * face + k, the side from corner k to corner k + 1
    std::set<int> corners;      ///< vertices where the outline turns sharply (`outlineCorners`)
    std::vector<char> isOnRim;  ///< per vertex
};

PieceRim rimOf(const Piece& piece);

/// Finds the place on the cloth that a pointer means: places pointed at before, corners and the
/// rim draw it within some pixels, also from beside the cloth. Rims are kept from one question to
/// the next. Cost: that of `hitAt`, and the rim of the piece; of all pieces beside the cloth.
class ClothSnapper {
public:
    /// @param own  places pointed at before
    std::optional<ClothPoint> find(const ToolView& view, const Garment& garment, const QPointF& at,
                                   std::span<const ClothPoint> own);
    const PieceRim& rim(const std::shared_ptr<const Piece>& piece);
    /// Forgets the rims of pieces that are not in the garment; null: all.
    void keep(const Garment* garment);

private:
    std::map<std::shared_ptr<const Piece>, PieceRim> rims_;
};

}  // namespace toile::app
