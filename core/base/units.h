// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace toile {

/// A unit with a name. Inside Toile every length is in millimetres.
enum class LengthUnit { Millimetre, Centimetre, Decimetre, Metre, Inch };
inline constexpr LengthUnit kLengthUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre,
                                              LengthUnit::Decimetre, LengthUnit::Metre,
                                              LengthUnit::Inch};

/// Millimetres in one unit: 1, 10, 100, 1000, 25.4.
double millimetresPer(LengthUnit unit);
/// "mm", "cm", "dm", "m", "in".
std::string_view symbol(LengthUnit unit);
/// The unit of a symbol as typed by a person ("mm", "cm", "dm", "m", "in"), or nothing.
std::optional<LengthUnit> parseLengthUnit(std::string_view text);

/// Unit of the coordinates in a file: a named one, or any other length, for example derived from
/// the height of a garment that a person typed.
class FileUnit {
public:
    FileUnit(LengthUnit unit) : millimetres_(millimetresPer(unit)) {}
    /// Nothing outside 1 nm to 1 km: no garment has such a unit.
    static std::optional<FileUnit> ofMillimetres(double millimetres);

    double millimetres() const { return millimetres_; }
    /// Nothing if it has no name.
    std::optional<LengthUnit> named() const;

    bool operator==(const FileUnit&) const = default;

private:
    explicit FileUnit(double millimetres) : millimetres_(millimetres) {}

    double millimetres_;
};

inline double millimetresPer(const FileUnit& unit) {
    return unit.millimetres();
}
/// "cm"; "12.1866 mm" if it has no name, with as many digits as reproduce the unit.
std::string unitText(const FileUnit& unit);
/// Parses such a text: "cm", "12.1866 mm", "0.5in"; nothing if it has another form.
std::optional<FileUnit> parseFileUnit(std::string_view text);

inline constexpr double kPi = std::numbers::pi;
/// One degree, in radians.
inline constexpr double kDegree = kPi / 180;

}  // namespace toile
