// SPDX-License-Identifier: GPL-3.0-or-later
in vec2 place;

uniform vec3 topColour;
uniform vec3 bottomColour;
uniform vec3 gridColour;
uniform float gridStrength;    // 0: no grid
uniform vec2 gridOrigin;       // mm at the lower left pixel, less whole major steps
uniform float unitsPerPixel;   // mm
uniform float majorStep;       // mm
uniform float minorStep;       // mm, a whole part of it
uniform float minorStrength;
uniform vec2 sheetOrigin;      // device pixels from the lower left
uniform float axisWidth;       // device pixels, of the two lines through the sheet's origin

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
        grid = max(lines(p, majorStep), lines(p, minorStep) * minorStrength);
    }
    if (gridStrength > 0.0) {
        vec2 toAxis = abs(gl_FragCoord.xy - sheetOrigin);
        grid = max(grid, 1.6 * clamp(0.5 * axisWidth + 0.5 - min(toAxis.x, toAxis.y), 0.0, 1.0));
    }
    colour = vec4(mix(ground, gridColour, grid * gridStrength), 1.0);
}
