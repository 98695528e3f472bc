// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "core/base/units.h"

namespace toile::app {

/// Program whose mouse controls the garment view follows.
enum class Navigation { Toile, Blender, Clo, Rhino };

/// Theme of the window; `System` follows the desktop.
enum class Theme { System, Light, Dark };
/// Language of all text. `System` follows the desktop, or is English without a translation.
enum class Language { System, English, German };

/// Initial state of a newly opened garment.
enum class NewGarment {
    Exact,    ///< its exact outlines
    Pattern,  ///< a pattern to cut and sew (`withPattern`)
};

/// How much menus offer.
enum class Menus {
    All,
    Plain,  ///< without method comparison and mesh repair (`isForSpecialists`)
};

/// The user's choices in the preferences dialog. A value type, so that a dialog can restore the
/// previous choices.
struct Choices {
    LengthUnit lengthUnit = LengthUnit::Millimetre;  ///< unit of lengths on the screen
    int inchDenominator = 16;                        ///< denominator of inch fractions; 0: decimals
    Theme theme = Theme::System;
    Language language = Language::System;  ///< takes effect at the next start
    Navigation navigation = Navigation::Toile;
    NewGarment newGarment = NewGarment::Pattern;
    Menus menus = Menus::All;
    QColor selectionColour{};  ///< in the views; invalid: the theme's
    QColor seamColour{};       ///< as above
    int autosaveMinutes = 1;   ///< between recovery copies; 0: none
    static constexpr int kMaxAutosaveMinutes = 60;
    /// Automatic flattening starts switched off for garments of more triangles.
    int autoFlattenTriangles = 500'000;

    bool operator==(const Choices&) const = default;
};

}  // namespace toile::app
