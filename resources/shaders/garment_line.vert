// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 flatPoint;
layout(location = 4) in float piece;
layout(location = 7) in float tint;
layout(location = 8) in vec3 sewnPosition;
layout(location = 10) in vec3 sewnValues;  // gap, strain, whether it is sewn

uniform mat4 viewProjection;
uniform float sewnWay;     // 0: as designed, 1: as sewn
uniform float depthShift;  // towards the eye, in clip space: lines lie on the cloth, not in it

flat out int lineFlags;
flat out int lineTint;
out float lineAlong;  // dashes are drawn on the sheet only

void main() {
    lineFlags = int(pieceColourAndFlags(piece).a + 0.5);
    lineTint = int(floor(tint + 0.5));
    lineAlong = 0.0;
    vec3 worn = mix(position, sewnPosition, sewnWay * sewnValues.z);
    gl_Position = viewProjection * vec4(morphedPoint(piece, lineFlags, worn, flatPoint), 1.0);
    gl_Position.z -= depthShift;
    gl_Position = unlessHidden(piece, gl_Position);
}
