// SPDX-License-Identifier: GPL-3.0-or-later
in vec3 viewNormal;
in vec3 wornNormal;
in vec2 millimetres;
in vec4 vertexValues;
in vec3 vertexMetric;
in vec3 vertexSewn;
flat in vec2 grain;
flat in vec2 ownRange;
flat in vec3 pieceColour;
flat in int pieceFlags;

uniform float clothAlpha;  // less than 1: what is behind is seen
uniform bool shaded;

out vec4 colour;

void main() {
    vec3 cloth = clothColour(pieceColour, pieceFlags, wornNormal, millimetres, vertexValues,
                             vertexMetric, vertexSewn, grain, ownRange);
    if ((pieceFlags & kPieceSelected) != 0 && !isRead()) {
        cloth = mix(cloth, vec3(1.0), kSelectedLight);
    }

    vec3 n = normalize(viewNormal);
    if (!gl_FrontFacing) {
        n = -n;
    }
    // Two soft lights that travel with the eye: one from the upper left, one from behind it.
    float key = max(dot(n, normalize(vec3(-0.45, 0.65, 0.75))), 0.0);
    float fill = max(dot(n, vec3(0.0, 0.0, 1.0)), 0.0);
    float light = 0.50 + 0.40 * key + 0.20 * fill;
    // Numbers are read by colour, so colours may not drown in shadow.
    light = isRead() ? mix(1.0, light, 0.45) : light;

    vec3 lit = shaded && overlay != kOverlayNormal ? cloth * light : cloth;
    if (!gl_FrontFacing) {
        float grey = dot(lit, vec3(0.299, 0.587, 0.114));
        lit = mix(lit, vec3(grey), 0.35) * 0.56;
    }
    colour = vec4(lit, clothAlpha);
}
