// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

/// Marks a text for translation: the window's text collector looks for this name.
#define TR(text) text

namespace toile {

/// The meaning of a number, which decides its field and its unit in a form.
enum class Quantity {
    Length,   ///< stored in mm
    Angle,    ///< stored in radians, shown in degrees
    Percent,  ///< stored as a share of 1
    Count,    ///< a whole number
    Other,    ///< with `Setting::unit`
};

/// A setting as the user sees it. It takes the place of the key in a description of fields
/// (core/base/field_archive.h): files use only `key`, forms make a row of it. Texts are English,
/// marked for translation in namespace toile.
struct Setting {
    const char* key;    ///< in project files; never changes once released
    const char* title;  ///< label of the field: a noun, with "&" before its mnemonic
    const char* name;   ///< a noun that needs no context: step of the history, screen readers
    const char* help;   ///< tool tip without full stop
    /// Shown for a value that is not set (an empty optional, or 0): "Default"; "": nothing is.
    const char* unset = nullptr;
    std::span<const char* const> names{};  ///< of the words, in the order of their table
    Quantity quantity = Quantity::Length;
    const char* none = nullptr;  ///< text of a number field for 0, below its least value
    const char* unit = nullptr;  ///< of a number, if its quantity is Other
    double unitSize = 1;         ///< stored value of one `unit`
    bool hasSwitch = false;      ///< a check box sets the number to 0

    constexpr operator const char*() const { return key; }
    constexpr operator std::string_view() const { return key; }
};

}  // namespace toile
