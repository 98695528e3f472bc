// SPDX-License-Identifier: GPL-3.0-or-later
// A cross of the principal strains on the garment: the ends of its two strokes.
layout(location = 0) in vec3 position;
layout(location = 3) in vec3 along;   // direction of the larger stretch, unit
layout(location = 4) in vec3 across;  // of the smaller
layout(location = 5) in vec2 strain;  // of either, percent
layout(location = 6) in float piece;

uniform mat4 viewProjection;
uniform float halfLength;  // mm, of a stroke at the end of the colour bar
uniform float depthShift;  // towards the eye, in clip space

out vec4 alongFrom, alongTo, acrossFrom, acrossTo;
flat out vec2 crossStrain;

vec4 onScreen(vec3 point) {
    vec4 at = viewProjection * vec4(point, 1.0);
    at.z -= depthShift;
    return unlessHidden(piece, at);
}

void main() {
    vec3 a = along * halfLength * strokeShare(strain.x);
    vec3 b = across * halfLength * strokeShare(strain.y);
    alongFrom = onScreen(position - a);
    alongTo = onScreen(position + a);
    acrossFrom = onScreen(position - b);
    acrossTo = onScreen(position + b);
    crossStrain = strain;
}
