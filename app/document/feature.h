// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::app {

/// Something of the garment that a pointer can be on and that can be lit up in both views.
struct Feature {
    enum class Kind {
        Piece,   ///< `piece`
        Seam,    ///< `seam`, or a free edge: both sides
        Run,     ///< of the outline of `piece`: `count` edges from edge `first`
        Vertex,  ///< `vertex` of `piece`, a corner of `face`
    };

    Kind kind = Kind::Piece;
    int piece = -1;
    int seam = -1;    ///< index into Garment::seams
    int first = -1;   ///< an edge of the outline: from Piece::boundary[first] to the next
    int count = 0;    ///< counts on past the outline's beginning
    int vertex = -1;  ///< of the piece's mesh
    int face = -1;    ///< one of the triangles around the vertex

    bool operator==(const Feature&) const = default;
};

}  // namespace toile::app
