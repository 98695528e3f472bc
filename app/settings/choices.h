// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "core/base/units.h"

namespace toile::app {

/// Whose way of moving the garment view with the mouse a person is used to.
enum class Navigation { Toile, Blender, Clo, Rhino };

/// Of the window: as the desktop has it, or always the same.
enum class Theme { System, Light, Dark };
/// Of all text: as the desktop has it (English where there is no such translation), or the same.
enum class Language { System, English, German };

/// What a garment that is opened is at first.
enum class NewGarment {
    Exact,    ///< its exact outlines
    Pattern,  ///< a pattern to cut and sew (`withPattern`)
};

/// How much menus offer.
enum class Menus {
    All,
    Plain,  ///< without what is there for comparing methods and for meshes (`isForSpecialists`)
};

/// What a person chooses in the preferences dialog. A value, so that a dialog can put back what was
/// chosen before.
struct Choices {
    LengthUnit lengthUnit = LengthUnit::Millimetre;  ///< lengths on the screen are written in
    int inchDenominator = 16;  ///< inches in fractions of this; 0: in decimals
    Theme theme = Theme::System;
    Language language = Language::System;  ///< holds from the next start
    Navigation navigation = Navigation::Toile;
    NewGarment newGarment = NewGarment::Pattern;
    Menus menus = Menus::All;
    QColor selectionColour{};  ///< in the views; invalid: what goes with the theme
    QColor seamColour{};       ///< as above
    int autosaveMinutes = 1;   ///< between copies kept for after a crash; 0: none are kept
    static constexpr int kMaxAutosaveMinutes = 60;
    /// Garments of more triangles begin without flattening after every edit.
    int autoFlattenTriangles = 500'000;

    bool operator==(const Choices&) const = default;
};

}  // namespace toile::app
