// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/export/export_options.h"

namespace toile {

enum class FormatId;

/// One choice that a person has with a format: a row of the dialog, an option of the command line
/// ("--dxf-profile"), a key under which it is remembered.
struct FormatOption {
    std::span<const FormatId> formats;  ///< that have it
    const char* name;                   ///< without the dashes
    const char* title;                  ///< a few words for a dialog, English, to be translated
    const char* help;                   ///< a sentence without a full stop, likewise
    /// The words that it takes; empty: a number, or nothing at all (`isSwitch`).
    std::span<const char* const> words{};
    std::span<const char* const> names{};  ///< of the words, for a dialog, likewise
    bool isSwitch = false;                 ///< "on" or "off"; typed without a value
    double least = 0, most = 0;
    /// What it is now, as it is typed; empty of a preset that the options are no longer.
    std::string (*get)(const ExportOptions&);
    /// False where the value is none of its.
    bool (*set)(ExportOptions&, std::string_view);
};

/// Presets stand before what they set, so that values set in this order mean what they say.
std::span<const FormatOption> formatOptions();

}  // namespace toile
