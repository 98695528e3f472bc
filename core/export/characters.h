// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Names of people and files, made fit for a format. All take UTF-8 and never fail: a byte that is
/// no UTF-8 counts as one unknown character. Pure functions, linear.

/// Number of characters (code points).
std::size_t characterCount(std::string_view text);

/// Valid UTF-8 without control characters; unknown characters become U+FFFD, controls a blank.
std::string cleanText(std::string_view text);

/// Printable ASCII: Latin letters lose their accents ("Rücken" becomes "Rucken", "ß" becomes
/// "ss"), every other character becomes '_'.
std::string asciiText(std::string_view text);

}  // namespace toile
