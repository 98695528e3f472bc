// SPDX-License-Identifier: GPL-3.0-or-later
// The way from the garment to the pattern, as laid down by app/render/morph.h. Joined behind
// piece_table.glsl, in front of the garment's vertex shaders.

uniform float bend;  // 0: as worn, 1: flat
// Per piece the motion of the flat piece in space: the three columns of its turn, and in their
// fourth numbers the offset.
uniform sampler2D morphTable;

const int kPieceIsFlat = 2;

vec4 morphTexel(float piece, int which) {
    int index = 3 * int(piece + 0.5) + which;
    return texelFetch(morphTable, ivec2(index % kPieceTableWidth, index / kPieceTableWidth), 0);
}

vec3 morphedPoint(float piece, int flags, vec3 worn, vec2 flatPoint) {
    if (bend <= 0.0 || (flags & kPieceIsFlat) == 0) {
        return worn;
    }
    vec4 x = morphTexel(piece, 0), y = morphTexel(piece, 1);
    vec3 offset = vec3(x.w, y.w, morphTexel(piece, 2).w);
    return mix(worn, offset + x.xyz * flatPoint.x + y.xyz * flatPoint.y, bend);
}

vec3 morphedNormal(float piece, int flags, vec3 normal) {
    if (bend <= 0.0 || (flags & kPieceIsFlat) == 0) {
        return normal;
    }
    vec3 mixed = mix(normal, morphTexel(piece, 2).xyz, bend);
    return dot(mixed, mixed) > 1e-6 ? mixed : normal;
}
