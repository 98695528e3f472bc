// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec2 flatPoint;
layout(location = 1) in vec3 values;
layout(location = 2) in float piece;

uniform mat4 viewProjection;

out vec2 millimetres;
out vec3 vertexValues;
flat out vec3 pieceColour;
flat out int pieceFlags;

void main() {
    vec4 entry = pieceColourAndFlags(piece);
    millimetres = flatPoint;
    vertexValues = values;
    pieceColour = entry.rgb;
    pieceFlags = int(entry.a + 0.5);
    gl_Position = viewProjection * vec4(flatPoint + pieceOffset(piece), 0.0, 1.0);
}
