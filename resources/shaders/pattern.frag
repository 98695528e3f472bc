// SPDX-License-Identifier: GPL-3.0-or-later
in vec3 wornNormal;
in vec2 millimetres;
in vec4 vertexValues;
in vec3 vertexMetric;
in vec3 vertexSewn;
flat in vec2 grain;
flat in vec2 ownRange;
flat in vec3 pieceColour;
flat in int pieceFlags;

out vec4 colour;

void main() {
    vec3 cloth = clothColour(pieceColour, pieceFlags, wornNormal, millimetres, vertexValues,
                             vertexMetric, vertexSewn, grain, ownRange);
    if ((pieceFlags & kPieceSelected) != 0 && !isRead()) {
        cloth = mix(cloth, vec3(1.0), kSelectedLight);
    }
    colour = vec4(cloth, 1.0);
}
