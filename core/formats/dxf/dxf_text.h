// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/wording.h"

namespace toile {

/// Converts text of DXF files to UTF-8. All functions are linear, and pure except for the notes.

/// The whole file in UTF-8 if it is not valid UTF-8 already: by $DWGCODEPAGE, or as Western
/// European text if that is missing or unknown. Bytes outside the code page become U+FFFD.
/// @param notes  receives notes on undecodable bytes and on guesses
std::optional<std::string> decodedDxf(std::string_view bytes, std::vector<Wording>& notes);

/// Whether a value may hold an escape that `withoutDxfEscapes` replaces.
bool hasDxfEscapes(std::string_view value);

/// The value with \U+XXXX, \M+nXXXX, %%c, %%d, %%p, %%% and %%nnn replaced by their characters, and
/// without %%u, %%o and %%k, which underline.
std::string withoutDxfEscapes(std::string_view value);

/// The value of an MTEXT without its formatting; paragraph breaks become blanks.
std::string plainMText(std::string_view value);

}  // namespace toile
