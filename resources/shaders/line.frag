// SPDX-License-Identifier: GPL-3.0-or-later
noperspective in float millimetresAlong;
flat in float lineStrength;
flat in int tintOfLine;  // place in the palette, or negative: a free edge

uniform vec4 lineColour;
uniform float dashLength;  // mm of a dash and the gap after it; 0: a solid line

// As in app/render/render_style.h
const int kSeamColours = 10;

uniform bool tinted;
uniform vec3 seamPalette[kSeamColours];
uniform vec3 freeColour;

const float kDashShare = 0.55;

out vec4 colour;

void main() {
    if (dashLength > 0.0 && mod(millimetresAlong, dashLength) > kDashShare * dashLength) {
        discard;
    }
    colour = lineColour;
    colour.a *= lineStrength;
    if (tinted) {
        colour.rgb =
            tintOfLine < 0 ? freeColour : seamPalette[min(tintOfLine, kSeamColours - 1)];
    }
}
