// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace toile::app {

struct Scene;

/// Principal strains at one place, for both views.
struct GlyphVertex {
    float position[3];   ///< mm, relative to Scene::origin
    float flat[2];       ///< mm, the piece's own coordinates
    float flatAlong[2];  ///< direction of the larger stretch on the flat piece, unit
    float along[3];      ///< the same on the garment, unit; and of the smaller stretch
    float across[3];
    float strain[2];  ///< larger and smaller, percent
    float piece;
};

/// Places spread evenly over the flat cloth, in an order in which every beginning of the list is
/// spread evenly too: what is drawn at a scale is one run from the first on.
struct StrainGlyphs {
    std::vector<GlyphVertex> vertices;
    double finest = 1;  ///< mm between neighbours where all are drawn
    /// How many are at least sqrt(2)^i times as far apart; falling.
    std::vector<std::uint32_t> counts;
};

/// The beginning of the list whose neighbours are at least this far apart, and how far.
struct GlyphRange {
    std::uint32_t count = 0;
    double spacing = 1;  ///< mm
};

GlyphRange glyphsAt(const StrainGlyphs& glyphs, double leastSpacing);

/// Of a scene that has its pieces, vertices and triangles. At most some ten thousand places, no
/// more than triangles, and one at least on each flat piece. Cost: linear.
StrainGlyphs makeStrainGlyphs(const Scene& scene);

}  // namespace toile::app
