// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Cleans names of people and files for a format or for display. All functions take UTF-8 and never
/// fail: an invalid byte is an unknown character. Control characters include those that
/// change the writing direction or break lines. Pure functions, linear.

/// Number of characters (code points).
std::size_t characterCount(std::string_view text);

/// Every character (code point); U+FFFD for an unknown one.
std::u32string codePoints(std::string_view text);

/// Valid UTF-8 without control characters; unknown characters become U+FFFD, controls a blank.
std::string cleanText(std::string_view text);

/// A name from a file as cleanText. If it is not UTF-8 it is read as Latin-1, the most likely of
/// the old encodings.
std::string readableName(std::string_view bytes);

/// At most this many characters of the readable name, for a sentence or a table; "…" for the rest.
inline constexpr std::size_t kMaxShown = 120;
std::string shownText(std::string_view bytes, std::size_t most = kMaxShown);

/// Printable ASCII: Latin letters lose their accents ("Rücken" becomes "Rucken", "ß" becomes
/// "ss"), Greek and Cyrillic letters become Latin ones, every other character becomes '_'.
std::string asciiText(std::string_view text);

}  // namespace toile
