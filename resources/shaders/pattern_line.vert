// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec2 flatPoint;
layout(location = 2) in float piece;

uniform mat4 viewProjection;

flat out int lineFlags;

void main() {
    lineFlags = int(pieceColourAndFlags(piece).a + 0.5);
    gl_Position = viewProjection * vec4(flatPoint + pieceOffset(piece), 0.0, 1.0);
}
