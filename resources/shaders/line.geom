// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of any width: core profile promises a width of one pixel only, which vanishes on a dense
// screen. Each segment becomes a rectangle of `lineWidth` pixels with square ends, which also
// closes the gaps at the outline's corners.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

flat in int lineFlags[];
flat in int lineTint[];
in float lineAlong[];

noperspective out float millimetresAlong;
flat out int tintOfLine;
flat out float lineStrength;

uniform vec2 viewportPixels;
uniform float lineWidth;
uniform bool selectedOnly;
uniform vec2 fade;    // pixels: shorter lines than the first are left out, up to the second faint
uniform bool tinted;  // lines of a scene's seams: free edges are half as wide

const int kPieceSelected = 1;
const float kNearest = 1e-4;  // w of a point just before the eye

void main() {
    if (selectedOnly && (lineFlags[0] & kPieceSelected) == 0) {
        return;
    }
    vec4 a = gl_in[0].gl_Position;
    vec4 b = gl_in[1].gl_Position;
    if (a.w < kNearest && b.w < kNearest) {
        return;
    }
    if (a.w < kNearest) {
        a = mix(a, b, (kNearest - a.w) / (b.w - a.w));
    }
    if (b.w < kNearest) {
        b = mix(b, a, (kNearest - b.w) / (a.w - b.w));
    }

    vec2 along = (b.xy / b.w - a.xy / a.w) * viewportPixels;
    float pixels = length(along);
    along = pixels > 1e-6 ? along / pixels : vec2(1.0, 0.0);
    float strength = fade.y > 0.0 ? clamp((0.5 * pixels - fade.x) / (fade.y - fade.x), 0.0, 1.0) : 1.0;
    if (strength <= 0.0) {
        return;
    }
    vec2 across = vec2(-along.y, along.x);
    float width = tinted && lineTint[0] < 0 ? 0.5 * lineWidth : lineWidth;
    vec2 end = along * width / viewportPixels;
    vec2 side = across * width / viewportPixels;

    lineStrength = strength;
    tintOfLine = lineTint[0];
    millimetresAlong = lineAlong[0];
    gl_Position = vec4(a.xy + (-end + side) * a.w, a.zw);
    EmitVertex();
    lineStrength = strength;
    tintOfLine = lineTint[0];
    millimetresAlong = lineAlong[0];
    gl_Position = vec4(a.xy + (-end - side) * a.w, a.zw);
    EmitVertex();
    lineStrength = strength;
    tintOfLine = lineTint[0];
    millimetresAlong = lineAlong[1];
    gl_Position = vec4(b.xy + (end + side) * b.w, b.zw);
    EmitVertex();
    lineStrength = strength;
    tintOfLine = lineTint[0];
    millimetresAlong = lineAlong[1];
    gl_Position = vec4(b.xy + (end - side) * b.w, b.zw);
    EmitVertex();
    EndPrimitive();
}
