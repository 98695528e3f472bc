// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 position;
layout(location = 4) in float piece;

uniform mat4 viewProjection;
uniform float depthShift;  // towards the eye, in depth units: lines lie on the cloth, not in it

flat out int lineFlags;
out float lineAlong;  // dashes are drawn on the sheet only

void main() {
    lineFlags = int(pieceColourAndFlags(piece).a + 0.5);
    lineAlong = 0.0;
    gl_Position = viewProjection * vec4(position, 1.0);
    gl_Position.z -= depthShift * gl_Position.w;
}
