// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/wording.h"

namespace toile {

/// Text of DXF files in UTF-8. All functions are pure but for the notes, and linear.

/// The whole file in UTF-8, if it is not valid UTF-8 already: by $DWGCODEPAGE, or as Western
/// European text where that is missing or unknown. Bytes that the code page lacks become U+FFFD.
/// @param notes  what could not be decoded, and what was guessed
std::optional<std::string> decodedDxf(std::string_view bytes, std::vector<Wording>& notes);

/// Whether a value may hold an escape that `withoutDxfEscapes` replaces.
bool hasDxfEscapes(std::string_view value);

/// The value with \U+XXXX, \M+nXXXX, %%c, %%d, %%p, %%% and %%nnn as the characters they stand for,
/// and without %%u, %%o and %%k, which underline.
std::string withoutDxfEscapes(std::string_view value);

/// The value of an MTEXT without its formatting; a new paragraph becomes a blank.
std::string plainMText(std::string_view value);

}  // namespace toile
