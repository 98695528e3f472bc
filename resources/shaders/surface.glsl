// SPDX-License-Identifier: GPL-3.0-or-later
// What both views paint on the cloth. Joined in front of garment.frag and pattern.frag. The numbers
// are worked out as in app/render/overlay_values.cpp. loadProgram declares kOverlayNone, kOverlayChecker
// and so on, from the table in app/document/overlay.h.

const int kPieceSelected = 1;
const int kPieceFlat = 2;

// How much lighter the cloth of a selected piece is: its hue says which piece it is
const float kSelectedLight = 0.3;

// Hatching, in logical pixels, and how much of the colour it leaves
const float kHatchPeriod = 7.0;
const float kHatchWidth = 1.3;
const float kHatchStrength = 0.6;

// Of a table of triangles: two texels each, in rows of this many
const int kFaceTableWidth = 2048;

uniform int overlay;
uniform float squareSide;     // of the checkerboard, mm
uniform vec2 overlayRange;    // values at the two ends of the colour map
uniform bool isProved;        // sewn cloth has been measured
uniform bool overlayLimited;  // the ends are the fabric's limits: hatching beyond the piece's
uniform bool triangleTable;   // the triangles' own values are in faceTable
uniform bool perTriangle;     // colours are of them, too
uniform float pixelRatio;
uniform sampler2D colourMap;
uniform sampler2D faceTable;

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
    vec2 p = millimetres / squareSide;
    vec2 window = max(fwidth(p), vec2(1e-4));
    return 0.5 - 0.5 * filteredWave(p.x, window.x) * filteredWave(p.y, window.y);
}

// True where colours stand for something that is read: light and selection leave them alone.
bool isRead() {
    return overlay > kOverlayChecker;
}

bool isTwoSided(vec2 range) {
    return range.x < 0.0 && range.y > 0.0;
}

// How near a value is to the end on its side: 1 at the end, more beyond it.
float severity(float value, vec2 range) {
    if (isTwoSided(range)) {
        return value < 0.0 ? value / range.x : value / range.y;
    }
    return (value - range.x) / (range.y - range.x);
}

// Colour of a value. Where there are two sides 0 is in the middle of the map, and either end is full
// colour.
vec3 valueColour(float value) {
    float place = severity(value, overlayRange);
    if (isTwoSided(overlayRange)) {
        place = 0.5 + (value < 0.0 ? -0.5 : 0.5) * place;
    }
    // From the middle of the first texel to the middle of the last.
    return texture(colourMap, vec2((clamp(place, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

float worse(float one, float other, vec2 range) {
    return severity(one, range) >= severity(other, range) ? one : other;
}

// What the cloth must do along a direction, in percent. metric: E, F, G of the map to the worn cloth.
float strainAlong(vec3 metric, vec2 direction) {
    float square = metric.x * direction.x * direction.x +
                   2.0 * metric.y * direction.x * direction.y +
                   metric.z * direction.y * direction.y;
    return 100.0 * (sqrt(max(square, 0.0)) - 1.0);
}

float worsePrincipalStrain(vec3 metric, vec2 range) {
    float mean = 0.5 * (metric.x + metric.z);
    float radius = length(vec2(0.5 * (metric.x - metric.z), metric.y));
    return worse(100.0 * (sqrt(max(mean + radius, 0.0)) - 1.0),
                 100.0 * (sqrt(max(mean - radius, 0.0)) - 1.0), range);
}

// Above the 1 of cloth that keeps its shape, in percent.
float symmetricDirichlet(vec3 metric) {
    float determinant = metric.x * metric.z - metric.y * metric.y;
    float energy = 0.25 * (metric.x + metric.z) * (1.0 + 1.0 / max(determinant, 1e-12));
    return 100.0 * (energy - 1.0);
}

// range: the ends on the piece.
float overlayValue(vec4 values, vec3 metric, vec2 grain, vec2 range) {
    vec2 across = vec2(-grain.y, grain.x);
    switch (overlay) {
        case kOverlayArea:
            return values.x;
        case kOverlayAngle:
            return values.y;
        case kOverlayStrain:
            return worse(values.z, values.w, range);
        case kOverlayWarp:
            return strainAlong(metric, grain);
        case kOverlayWeft:
            return strainAlong(metric, across);
        case kOverlayBias:
            return worse(strainAlong(metric, (grain + across) * sqrt(0.5)),
                         strainAlong(metric, (grain - across) * sqrt(0.5)), range);
        case kOverlayPrincipal:
            return worsePrincipalStrain(metric, range);
        case kOverlayDirichlet:
            return symmetricDirichlet(metric);
    }
    return 0.0;
}

// 1 on diagonal stripes of the screen: down to the right where the cloth has surplus, up to the
// right where it is stretched, so that either is told without colours too.
float hatching(bool stretched) {
    vec2 p = gl_FragCoord.xy / pixelRatio;
    float along = (stretched ? p.x - p.y : p.x + p.y) * sqrt(0.5);
    float toStripe = abs(fract(along / kHatchPeriod) - 0.5) * kHatchPeriod;
    return clamp((0.5 * kHatchWidth - toStripe) * pixelRatio + 0.5, 0.0, 1.0);
}

// Colour of the cloth of a piece before light falls on it.
// worn: the normal of the cloth on the garment; sewn: gap, strain, and whether it is sewn;
// ownRange: pieceRange of piece_table.glsl
vec3 clothColour(vec3 piece, int flags, vec3 worn, vec2 millimetres, vec4 values, vec3 metric,
                 vec3 sewn, vec2 grain, vec2 ownRange) {
    // Called outside of any branch: derivatives are undefined inside.
    float square = checker(millimetres);
    if (overlay == kOverlayNormal) {
        return 0.5 + 0.5 * normalize(worn);
    }
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
    bool isOfProof = overlay == kOverlayGap || overlay == kOverlayWornStrain;
    if (isOfProof && !(isProved && sewn.z >= 0.999)) {
        return piece;
    }
    vec4 ownValues = values;
    vec3 ownMetric = metric;
    if (triangleTable) {
        int texel = 2 * gl_PrimitiveID;
        ivec2 at = ivec2(texel % kFaceTableWidth, texel / kFaceTableWidth);
        ownValues = texelFetch(faceTable, at, 0);
        ownMetric = texelFetch(faceTable, at + ivec2(1, 0), 0).xyz;
    }
    vec2 range = ownRange.y > ownRange.x ? ownRange : overlayRange;
    // Stripes are of the triangle itself, as the shares beside the colour bar: what is smoothed away
    // is still beyond the fabric.
    float proven = overlay == kOverlayGap ? sewn.x : sewn.y;
    float own = isOfProof ? proven : overlayValue(ownValues, ownMetric, grain, range);
    vec3 painted = valueColour(perTriangle || isOfProof
                                   ? own
                                   : overlayValue(values, metric, grain, range));
    // Crosses are drawn over it, and they carry the colours.
    vec3 ground = overlay == kOverlayPrincipal ? valueColour(0.0) : painted;
    bool isLimited = ownRange.y > ownRange.x || (overlayLimited && ownRange.y == ownRange.x);
    if (isLimited && severity(own, range) > 1.0005) {
        vec3 stripe = overlay == kOverlayPrincipal ? mix(ground, painted, 0.5) : vec3(0.97);
        return mix(ground, stripe, kHatchStrength * hatching(own > 0.0));
    }
    return ground;
}
