// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>

#include "core/base/setting.h"
#include "core/base/wording.h"
#include "core/diagnose/finding.h"

namespace toile::app {

/// The overlay on the cloth, in both views. Shaders know the values as kOverlayNone,
/// kOverlayChecker, ... (shader_program.cpp). To add one, see CONTRIBUTING.md.
enum class Overlay {
    None,        ///< the piece's colour alone
    Checker,     ///< true-scale squares
    Area,        ///< A3D / A2D - 1
    Angle,       ///< largest change of a corner angle
    Strain,      ///< L3D / L2D - 1 of the edges
    Warp,        ///< strain along the grain
    Weft,        ///< strain across it
    Bias,        ///< strain at 45 degrees to it, the worse of both diagonals
    Principal,   ///< principal strains and their directions, as glyphs
    Dirichlet,   ///< symmetric Dirichlet energy, above that of cloth that keeps its shape
    Normal,      ///< normal of the 3D cloth, as a colour ([Wan05], figures)
    Gap,         ///< distance of the sewn pattern outside the design, mm
    WornStrain,  ///< largest principal strain of the sewn cloth
};

/// Groups of overlays, in the order of the menu.
enum class OverlayKind {
    Plain,    ///< no number
    Flat,     ///< a number of the flat cloth compared to the garment
    Sewn,     ///< a number of a proof: there is none before it
    Surface,  ///< a direction of the garment's surface
};

/// Unit of the values; lengths are in mm and shown in the user's unit.
enum class OverlayUnit { None, Percent, Degrees, Length };

/// The limits of the fabric for a value. Limited values of the flat cloth have one colour scale.
enum class LimitedBy { Nothing, Warp, Weft, Bias, Tightest };

/// The action that turns an overlay on. All texts are marked for translation.
struct OverlayAction {
    const char* name;       ///< "overlayStrain"; a shader knows the overlay as kOverlayStrain
    const char* text;       ///< in menus
    const char* shortText;  ///< on buttons
    const char* shortcut;
    const char* tip;
};

/// Everything about an overlay but its values (overlay_values.h, surface.glsl).
struct OverlayTraits {
    Overlay overlay;
    /// On the command line, in project files and in the icon's name, overlay-WORD.svg. Released
    /// words stay.
    std::string_view word;
    OverlayAction action;
    const char* meaning;  ///< of the colours, for the legend
    OverlayKind kind = OverlayKind::Flat;
    OverlayUnit unit = OverlayUnit::Percent;
    int decimals = 1;
    double finest = 0.1;  ///< minimum range of the colour scale; less does not matter for cloth
    bool hasSign = true;  ///< 0 is in the middle of the colours
    bool usesGrain = false;
    LimitedBy limit = LimitedBy::Nothing;
    /// Sentences for cloth beyond the limits, and for none beyond; null: of the tightest limit.
    const char *beyond = nullptr, *within = nullptr;
    std::optional<FindingKind> finding = std::nullopt;  ///< the overlay that shows it
    const char* reportCaption = nullptr;                ///< not null: the report has its picture
    bool isForSpecialists = false;
};

// clang-format off
inline constexpr OverlayTraits kOverlays[] = {
    {.overlay = Overlay::None, .word = "none",
     .action = {"overlayNone", TR("Piece &colours"), TR("Colours"), "1",
                TR("Show every piece in its own colour")},
     .meaning = TR("each piece in its own colour"),
     .kind = OverlayKind::Plain, .unit = OverlayUnit::None},
    {.overlay = Overlay::Checker, .word = "checker",
     .action = {"overlayChecker", TR("Check&erboard"), TR("Checker"), "2",
                TR("Show true-scale squares on the cloth")},
     .meaning = TR("squares of 1 cm on the flat cloth"),
     .kind = OverlayKind::Plain, .unit = OverlayUnit::None,
     .reportCaption = "The garment and its pattern; squares of 10 mm"},
    {.overlay = Overlay::Area, .word = "area",
     .action = {"overlayArea", TR("&Area change"), TR("Area"), "3",
                TR("Show how much area the cloth must gain or lose to take its shape")},
     .meaning = TR("3D against flat: orange stretches, blue has surplus"),
     .finding = FindingKind::FlippedTriangles,  // they have negative area
     .isForSpecialists = true},
    {.overlay = Overlay::Angle, .word = "angle",
     .action = {"overlayAngle", TR("An&gle change"), TR("Angle"), "4",
                TR("Show how much the angles of the cloth change")},
     .meaning = TR("largest change of a triangle's corner angle"),
     .unit = OverlayUnit::Degrees, .hasSign = false, .isForSpecialists = true},
    {.overlay = Overlay::Strain, .word = "strain",
     .action = {"overlayStrain", TR("Edge &strain"), TR("Strain"), "5",
                TR("Show how far the cloth must stretch or shrink to take its shape")},
     .meaning = TR("mesh edges: orange stretches, blue has surplus"),
     .limit = LimitedBy::Tightest,
     .beyond = TR("%1 of the cloth has an edge beyond the tightest limit"),
     .within = TR("no edge is beyond the tightest limit"),
     .finding = FindingKind::StrainBeyondCloth,
     .reportCaption = "Strain: how far the cloth must stretch or shrink"},
    {.overlay = Overlay::Warp, .word = "warp",
     .action = {"overlayWarp", TR("Strain along war&p"), TR("Warp"), "6",
                TR("Show how far the cloth must stretch or shrink along the grain")},
     .meaning = TR("along the grain: orange stretches, blue has surplus"),
     .usesGrain = true, .limit = LimitedBy::Warp,
     .beyond = TR("%1 of the cloth exceeds the warp limits"),
     .within = TR("all cloth is within the warp limits"), .finding = FindingKind::StrainWarp},
    {.overlay = Overlay::Weft, .word = "weft",
     .action = {"overlayWeft", TR("Strain along we&ft"), TR("Weft"), "7",
                TR("Show how far the cloth must stretch or shrink across the grain")},
     .meaning = TR("across the grain: orange stretches, blue has surplus"),
     .usesGrain = true, .limit = LimitedBy::Weft,
     .beyond = TR("%1 of the cloth exceeds the weft limits"),
     .within = TR("all cloth is within the weft limits"), .finding = FindingKind::StrainWeft},
    {.overlay = Overlay::Bias, .word = "bias",
     .action = {"overlayBias", TR("Strain on the &bias"), TR("Bias"), "8",
                TR("Show the larger of the strains along the two diagonals, at 45° to the grain")},
     .meaning = TR("at 45° to the grain, the worse of both diagonals"),
     .usesGrain = true, .limit = LimitedBy::Bias,
     .beyond = TR("%1 of the cloth exceeds the bias limits"),
     .within = TR("all cloth is within the bias limits"), .finding = FindingKind::StrainBias},
    {.overlay = Overlay::Principal, .word = "principal",
     .action = {"overlayPrincipal", TR("Principal s&train"), TR("Principal"), "9",
                TR("Draw crosses along the directions of largest and least strain")},
     .meaning = TR("outward arrows stretch, inward arrows have surplus"),
     .limit = LimitedBy::Tightest, .isForSpecialists = true},
    {.overlay = Overlay::Dirichlet, .word = "dirichlet",
     .action = {"overlayDirichlet", TR("&Distortion energy"), TR("Energy"), "0",
                TR("Show the symmetric Dirichlet energy: one number for strain in all directions")},
     .meaning = TR("symmetric Dirichlet energy; 0 if the cloth keeps its shape"),
     .decimals = 2, .finest = 0.01, .hasSign = false, .isForSpecialists = true},
    {.overlay = Overlay::Normal, .word = "normal",
     .action = {"overlayNormal", TR("Surface &normals"), TR("Normals"), "",
                TR("Show which way the garment's surface faces, one colour per direction")},
     .meaning = TR("direction of the 3D surface, one colour for each axis"),
     .kind = OverlayKind::Surface, .unit = OverlayUnit::None, .isForSpecialists = true},
    {.overlay = Overlay::Gap, .word = "gap",
     .action = {"overlayGap", TR("Gap of the sewn c&loth"), TR("Gap"), "",
                TR("Show how far the sewn pattern lies outside or inside the design")},
     .meaning = TR("sewn cloth against design: orange outside, blue inside"),
     .kind = OverlayKind::Sewn, .unit = OverlayUnit::Length, .finding = FindingKind::SewnGap},
    {.overlay = Overlay::WornStrain, .word = "worn-strain",
     .action = {"overlayWornStrain", TR("&Worn strain of the sewn cloth"), TR("Worn strain"), "",
                TR("Show the strain of the cloth in the sewn pattern")},
     .meaning = TR("sewn cloth: orange pulls, blue is slack"),
     .kind = OverlayKind::Sewn, .limit = LimitedBy::Tightest},
};
// clang-format on

inline constexpr int kOverlayCount = static_cast<int>(std::size(kOverlays));

constexpr const OverlayTraits& traits(Overlay overlay) {
    return kOverlays[static_cast<std::size_t>(overlay)];
}
static_assert(std::ranges::is_sorted(kOverlays, {}, &OverlayTraits::overlay) &&
                  kOverlays[kOverlayCount - 1].overlay == Overlay{kOverlayCount - 1},
              "one row for each overlay, in order");

struct OverlayWordTable {
    Word<Overlay> words[kOverlayCount];
};
inline constexpr OverlayWordTable kOverlayWordTable = [] {
    OverlayWordTable table{};
    for (std::size_t i = 0; i < std::size(kOverlays); ++i) {
        table.words[i] = {kOverlays[i].overlay, kOverlays[i].word};
    }
    return table;
}();
inline constexpr const auto& kOverlayWords = kOverlayWordTable.words;

/// True if the overlay shows a number and so needs a colour bar.
constexpr bool isMeasured(Overlay overlay) {
    const OverlayKind kind = traits(overlay).kind;
    return kind == OverlayKind::Flat || kind == OverlayKind::Sewn;
}

/// True if the number comes from a proof.
constexpr bool isOfProof(Overlay overlay) {
    return traits(overlay).kind == OverlayKind::Sewn;
}

}  // namespace toile::app
