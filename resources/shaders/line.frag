// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec4 lineColour;

out vec4 colour;

void main() {
    colour = lineColour;
}
