// SPDX-License-Identifier: GPL-3.0-or-later
// Per piece: colour, flags and place on the sheet, as laid down by app/render/piece_table.h.
// Joined in front of the vertex shaders.

const int kPieceTableWidth = 2048;
const int kTexelsPerPiece = 4;

uniform sampler2D pieceTable;

vec4 pieceTexel(float piece, int which) {
    int index = kTexelsPerPiece * int(piece + 0.5) + which;
    return texelFetch(pieceTable, ivec2(index % kPieceTableWidth, index / kPieceTableWidth), 0);
}

vec4 pieceColourAndFlags(float piece) {
    return pieceTexel(piece, 0);
}

const int kPieceHidden = 4;

// Where a point of a piece is drawn: before the eye where the piece is hidden, so that it is not.
vec4 unlessHidden(float piece, vec4 clipped) {
    int flags = int(pieceColourAndFlags(piece).a + 0.5);
    return (flags & kPieceHidden) != 0 ? vec4(0.0, 0.0, -2.0, 1.0) : clipped;
}

// A point of the flat piece at the piece's place on the sheet.
vec2 placed(float piece, vec2 flatPoint) {
    vec4 columns = pieceTexel(piece, 1);
    return mat2(columns.xy, columns.zw) * flatPoint + pieceTexel(piece, 2).xy;
}

// What the piece's own fabric allows of the overlay; equal ends: what the garment's does.
vec2 pieceRange(float piece) {
    return pieceTexel(piece, 3).xy;
}

// Direction of the warp in the piece's own flat coordinates.
vec2 pieceGrain(float piece) {
    return pieceTexel(piece, 2).zw;
}
