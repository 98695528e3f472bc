// SPDX-License-Identifier: GPL-3.0-or-later
// Two strokes per cross, each a rectangle wide enough for its arrowheads.
layout(points) in;
layout(triangle_strip, max_vertices = 8) out;

in vec4 alongFrom[], alongTo[], acrossFrom[], acrossTo[];
flat in vec2 crossStrain[];

uniform vec2 viewportPixels;
uniform float pixelRatio;

noperspective out vec2 strokePlace;  // logical pixels along and across, from the middle
flat out float strokeHalf;           // logical pixels
flat out float strokeStrain;

const float kHalfWidth = 5.0;  // logical pixels, heads included
const float kNearest = 1e-4;   // w of a point just before the eye

void stroke(vec4 a, vec4 b, float strain) {
    if (a.w < kNearest || b.w < kNearest) {
        return;
    }
    vec2 along = (b.xy / b.w - a.xy / a.w) * 0.5 * viewportPixels / pixelRatio;
    float pixels = length(along);
    along = pixels > 1e-6 ? along / pixels : vec2(1.0, 0.0);
    vec2 pixel = 2.0 * pixelRatio / viewportPixels;
    vec2 beyond = along * pixel;
    vec2 side = vec2(-along.y, along.x) * kHalfWidth * pixel;
    strokeHalf = 0.5 * pixels;
    strokeStrain = strain;
    for (int i = 0; i < 4; ++i) {
        bool atEnd = i >= 2;
        float sign = i % 2 == 0 ? 1.0 : -1.0;
        vec4 at = atEnd ? b : a;
        strokePlace = vec2(atEnd ? strokeHalf + 1.0 : -strokeHalf - 1.0, sign * kHalfWidth);
        gl_Position = vec4(at.xy + ((atEnd ? beyond : -beyond) + sign * side) * at.w, at.zw);
        EmitVertex();
    }
    EndPrimitive();
}

void main() {
    stroke(alongFrom[0], alongTo[0], crossStrain[0].x);
    stroke(acrossFrom[0], acrossTo[0], crossStrain[0].y);
}
