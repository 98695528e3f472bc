// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string_view>

namespace toile {

/// Unit of the coordinates in a file. Inside Toile every length is in millimetres.
enum class LengthUnit { Millimetre, Centimetre, Metre, Inch };

/// Millimetres in one unit: 1, 10, 1000, 25.4.
double millimetresPer(LengthUnit unit);
/// "mm", "cm", "m", "in".
std::string_view symbol(LengthUnit unit);
/// The unit of a symbol as typed by a person ("mm", "cm", "m", "in"), or nothing.
std::optional<LengthUnit> parseLengthUnit(std::string_view text);

inline constexpr double kPi = std::numbers::pi;
/// One degree, in radians.
inline constexpr double kDegree = kPi / 180;

}  // namespace toile
