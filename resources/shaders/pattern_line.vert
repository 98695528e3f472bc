// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 2) in vec2 flatPoint;
layout(location = 4) in float piece;
layout(location = 6) in float along;  // mm from the line's beginning
layout(location = 7) in float tint;

uniform mat4 viewProjection;

flat out int lineFlags;
flat out int lineTint;
out float lineAlong;

void main() {
    lineFlags = int(pieceColourAndFlags(piece).a + 0.5);
    lineTint = int(floor(tint + 0.5));
    lineAlong = along;
    gl_Position = viewProjection * vec4(placed(piece, flatPoint), 0.0, 1.0);
    gl_Position = unlessHidden(piece, gl_Position);
}
