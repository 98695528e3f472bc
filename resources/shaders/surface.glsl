// SPDX-License-Identifier: GPL-3.0-or-later
// What both views paint on the cloth. Joined in front of garment.frag and pattern.frag.

// Overlay, as in app/document/view_state.h
const int kOverlayNone = 0;
const int kOverlayChecker = 1;

const int kPieceSelected = 1;
const int kPieceFlat = 2;

// Side of a checkerboard square, mm
const float kSquare = 10.0;

uniform int overlay;
uniform vec2 overlayRange;  // values at the two ends of the colour map
uniform sampler2D colourMap;

// Integral of a square wave of period 2 that is +1 in [0, 1) and -1 in [1, 2).
float waveIntegral(float x) {
    return 1.0 - abs(mod(x, 2.0) - 1.0);
}

// Mean of the square wave over a window of a pixel's width: exact antialiasing of a stripe.
float filteredWave(float x, float window) {
    return (waveIntegral(x + 0.5 * window) - waveIntegral(x - 0.5 * window)) / window;
}

// 0 or 1 on the squares, the mean 0.5 where squares are smaller than a pixel.
float checker(vec2 millimetres) {
    vec2 p = millimetres / kSquare;
    vec2 window = max(fwidth(p), vec2(1e-4));
    return 0.5 - 0.5 * filteredWave(p.x, window.x) * filteredWave(p.y, window.y);
}

// Colour of the cloth before light falls on it.
vec3 clothColour(vec3 piece, int flags, vec2 millimetres, vec3 values) {
    // Called outside of any branch: derivatives are undefined inside.
    float square = checker(millimetres);
    if ((flags & kPieceFlat) == 0) {
        return piece;
    }
    if (overlay == kOverlayNone) {
        return piece;
    }
    if (overlay == kOverlayChecker) {
        vec3 dark = piece * 0.86;
        vec3 light = mix(piece, vec3(1.0), 0.56);
        return mix(dark, light, square);
    }
    float value = overlay == 2 ? values.x : overlay == 3 ? values.y : values.z;
    float place = clamp((value - overlayRange.x) / (overlayRange.y - overlayRange.x), 0.0, 1.0);
    // From the middle of the first texel to the middle of the last.
    return texture(colourMap, vec2((place * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}
