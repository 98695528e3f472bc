// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// A name from a file as valid UTF-8 without control characters, so that every writer may print
/// it. Bytes that are no UTF-8 are taken as Latin-1, the likeliest of the old encodings.
std::string readableName(std::string_view bytes);

}  // namespace toile
