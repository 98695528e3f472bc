// SPDX-License-Identifier: GPL-3.0-or-later
noperspective in float millimetresAlong;

uniform vec4 lineColour;
uniform float dashLength;  // mm of a dash and the gap after it; 0: a solid line

const float kDashShare = 0.55;

out vec4 colour;

void main() {
    if (dashLength > 0.0 && mod(millimetresAlong, dashLength) > kDashShare * dashLength) {
        discard;
    }
    colour = lineColour;
}
