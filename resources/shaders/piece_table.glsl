// SPDX-License-Identifier: GPL-3.0-or-later
// Per piece: colour, flags and place on the sheet, as laid down by app/render/piece_table.h.
// Joined in front of the vertex shaders.

const int kPieceTableWidth = 2048;

uniform sampler2D pieceTable;

vec4 pieceTexel(float piece, int which) {
    int index = 2 * int(piece + 0.5) + which;
    return texelFetch(pieceTable, ivec2(index % kPieceTableWidth, index / kPieceTableWidth), 0);
}

vec4 pieceColourAndFlags(float piece) {
    return pieceTexel(piece, 0);
}

vec2 pieceOffset(float piece) {
    return pieceTexel(piece, 1).xy;
}
