// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages of the glyphs share. Joined in front of them.
const float kMinShare = 0.1;  // of the full length, so that a place without strain is seen too

uniform vec2 overlayRange;  // strains at the two ends of the colour bar, percent

// How near a strain is to the end on its side: 1 at the end, more beyond it.
float strokeSeverity(float strain) {
    return strain < 0.0 ? strain / overlayRange.x : strain / overlayRange.y;
}

// Length of a stroke, as a part of the longest.
float strokeShare(float strain) {
    return clamp(strokeSeverity(strain), kMinShare, 1.0);
}
