// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/formats/export_options.h"

namespace toile {

enum class FormatId;

/// One option of a format: a row of the dialog, an option of the command line ("--dxf-profile"),
/// and a key of the settings.
struct FormatOption {
    std::span<const FormatId> formats;  ///< the formats with this option
    const char* name;                   ///< without the dashes
    const char* title;                  ///< a few words for a dialog, English, to be translated
    const char* help;                   ///< a sentence without a full stop, likewise
    /// The accepted words; empty: a number, or no value at all (`isSwitch`).
    std::span<const char* const> words{};
    std::span<const char* const> names{};  ///< of the words, for a dialog, likewise
    bool isSwitch = false;                 ///< "on" or "off"; typed without a value
    double least = 0, most = 0;
    /// The current value, as typed; empty for a preset that no longer matches the options.
    std::string (*get)(const ExportOptions&);
    /// False if the value is invalid.
    bool (*set)(ExportOptions&, std::string_view);
};

/// Presets come before the options that they set, so setting values in this order keeps them all.
std::span<const FormatOption> formatOptions();

}  // namespace toile
