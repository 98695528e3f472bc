// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 flatPoint;
layout(location = 3) in vec4 values;
layout(location = 4) in float piece;
layout(location = 5) in vec3 metric;
layout(location = 8) in vec3 sewnPosition;
layout(location = 9) in vec3 sewnNormal;
layout(location = 10) in vec3 sewnValues;  // gap, strain, whether it is sewn

uniform mat4 viewProjection;
uniform mat3 normalToView;
uniform float sewnWay;  // 0: as designed, 1: as sewn

out vec3 viewNormal;
out vec3 wornNormal;
out vec2 millimetres;
out vec4 vertexValues;
out vec3 vertexMetric;
out vec3 vertexSewn;
flat out vec2 grain;
flat out vec2 ownRange;
flat out vec3 pieceColour;
flat out int pieceFlags;

void main() {
    vec4 entry = pieceColourAndFlags(piece);
    float way = sewnWay * sewnValues.z;
    vec3 worn = mix(position, sewnPosition, way);
    viewNormal =
        normalToView * morphedNormal(piece, int(entry.a + 0.5), mix(normal, sewnNormal, way));
    wornNormal = normal;
    millimetres = flatPoint;
    vertexValues = values;
    vertexMetric = metric;
    vertexSewn = sewnValues;
    grain = pieceGrain(piece);
    ownRange = pieceRange(piece);
    pieceColour = entry.rgb;
    pieceFlags = int(entry.a + 0.5);
    gl_Position =
        viewProjection * vec4(morphedPoint(piece, pieceFlags, worn, flatPoint), 1.0);
    gl_Position = unlessHidden(piece, gl_Position);
}
