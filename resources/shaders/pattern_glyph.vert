// SPDX-License-Identifier: GPL-3.0-or-later
// A cross of the principal strains on the flat piece: the ends of its two strokes.
layout(location = 1) in vec2 flatPoint;
layout(location = 2) in vec2 flatAlong;  // direction of the larger stretch, unit
layout(location = 5) in vec2 strain;     // larger and smaller, percent
layout(location = 6) in float piece;

uniform mat4 viewProjection;
uniform float halfLength;  // mm, of a stroke at the end of the colour bar

out vec4 alongFrom, alongTo, acrossFrom, acrossTo;
flat out vec2 crossStrain;

vec4 onScreen(vec2 point) {
    return unlessHidden(piece, viewProjection * vec4(placed(piece, point), 0.0, 1.0));
}

void main() {
    vec2 a = flatAlong * halfLength * strokeShare(strain.x);
    vec2 b = vec2(-flatAlong.y, flatAlong.x) * halfLength * strokeShare(strain.y);
    alongFrom = onScreen(flatPoint - a);
    alongTo = onScreen(flatPoint + a);
    acrossFrom = onScreen(flatPoint - b);
    acrossTo = onScreen(flatPoint + b);
    crossStrain = strain;
}
