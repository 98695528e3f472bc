// SPDX-License-Identifier: GPL-3.0-or-later
// A stroke with arrowheads: outwards where the cloth is stretched, inwards where it has surplus.
noperspective in vec2 strokePlace;
flat in float strokeHalf;
flat in float strokeStrain;

uniform sampler2D colourMap;
uniform float pixelRatio;

const float kShaft = 1.5, kStrongShaft = 2.4;  // width in logical pixels, within and beyond the ends
const float kHead = 4.5;                       // length of a head
const float kHeadSlope = 0.62;
const vec3 kFaint = vec3(0.46, 0.47, 0.49);

out vec4 colour;

void main() {
    float severity = strokeSeverity(strokeStrain);
    float x = abs(strokePlace.x), y = abs(strokePlace.y);
    float shaft = 0.5 * (severity > 1.0 ? kStrongShaft : kShaft) - y;
    float head = min(kHead, 0.75 * strokeHalf);
    float fromEnd = strokeHalf - x;
    float reach = strokeStrain >= 0.0 ? fromEnd : head - fromEnd;
    float arrow = fromEnd < head && strokeHalf > 3.0 ? kHeadSlope * reach - y : -1.0;
    float inside = min(max(shaft, arrow), fromEnd + 0.5);
    float cover = clamp(inside * pixelRatio + 0.5, 0.0, 1.0);
    if (cover <= 0.0) {
        discard;
    }
    float place = 0.5 + (strokeStrain < 0.0 ? -0.5 : 0.5) * min(severity, 1.0);
    vec3 strong = texture(colourMap, vec2((place * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    colour = vec4(mix(kFaint, strong, smoothstep(0.05, 0.4, severity)), cover);
}
