// SPDX-License-Identifier: GPL-3.0-or-later
in vec2 place;

uniform vec3 topColour;
uniform vec3 bottomColour;
uniform vec3 gridColour;
uniform float gridStrength;    // 0: no grid
uniform vec2 gridOrigin;       // mm at the lower left pixel, less whole major steps
uniform float unitsPerPixel;   // mm
uniform float majorStep;       // mm; minor lines are a tenth of it
uniform float minorStrength;

out vec4 colour;

// 1 on lines of about a pixel's width every `step` mm.
float lines(vec2 p, float step) {
    vec2 toLine = abs(fract(p / step + 0.5) - 0.5) * step / unitsPerPixel;
    vec2 cover = clamp(1.0 - toLine, 0.0, 1.0);
    return max(cover.x, cover.y);
}

void main() {
    vec3 ground = mix(bottomColour, topColour, place.y);
    float grid = 0.0;
    if (gridStrength > 0.0) {
        vec2 p = gridOrigin + gl_FragCoord.xy * unitsPerPixel;
        grid = max(lines(p, majorStep), lines(p, majorStep / 10.0) * minorStrength);
    }
    colour = vec4(mix(ground, gridColour, grid * gridStrength), 1.0);
}
