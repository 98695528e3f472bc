// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 flatPoint;
layout(location = 3) in vec4 values;
layout(location = 4) in float piece;
layout(location = 5) in vec3 metric;

uniform mat4 viewProjection;
uniform mat3 normalToView;

out vec3 viewNormal;
out vec3 wornNormal;
out vec2 millimetres;
out vec4 vertexValues;
out vec3 vertexMetric;
flat out vec2 grain;
flat out vec2 ownRange;
flat out vec3 pieceColour;
flat out int pieceFlags;

void main() {
    vec4 entry = pieceColourAndFlags(piece);
    viewNormal = normalToView * morphedNormal(piece, int(entry.a + 0.5), normal);
    wornNormal = normal;
    millimetres = flatPoint;
    vertexValues = values;
    vertexMetric = metric;
    grain = pieceGrain(piece);
    ownRange = pieceRange(piece);
    pieceColour = entry.rgb;
    pieceFlags = int(entry.a + 0.5);
    gl_Position =
        viewProjection * vec4(morphedPoint(piece, pieceFlags, position, flatPoint), 1.0);
    gl_Position = unlessHidden(piece, gl_Position);
}
