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

inline constexpr double kPointsPerMillimetre = 72 / 25.4;  ///< of print and PDF

inline constexpr double kPi = std::numbers::pi;
/// One degree, in radians.
inline constexpr double kDegree = kPi / 180;

/// Lengths and angles as text for people. All functions are pure; text is UTF-8.

/// How lengths are written.
struct LengthFormat {
    LengthUnit unit = LengthUnit::Millimetre;
    /// Inches in fractions of this: 8, 16, 32; 0: decimals. Ignored for other units.
    int denominator = 0;
    /// The user's decimal separator: "." or ",".
    std::string decimalMark = ".";

    bool operator==(const LengthFormat&) const = default;
};

/// Decimals that show a tenth of a millimetre in this unit, or come closest: 1 for mm, 2 for cm, 4
/// for m, 2 for inches.
int lengthDecimals(LengthUnit unit);

/// Without the unit: "314.2", "31.42", "12 3/8", "-3/8", "0". Fractions are rounded to the nearest
/// and reduced; a value that rounds to zero has no sign. Not finite: "–".
std::string lengthNumber(double millimetres, const LengthFormat& format);
/// With the unit: "314.2 mm", "12 3/8 in".
std::string lengthText(double millimetres, const LengthFormat& format);

/// Parses a length typed by a person, in millimetres; nothing if it is not a length. Sums and
/// differences of lengths, each with its own unit or the format's, times or divided by plain
/// numbers: "31,4 cm", "12 3/8\"", "12⅜ in", "1/2", "2 * 45 mm + 1 in". Both decimal marks are
/// accepted; no mark groups thousands.
std::optional<double> parseLength(std::string_view text, const LengthFormat& format);

/// "12.5°": degrees with up to `decimals` decimals, no trailing zeros.
std::string angleText(double radians, int decimals, std::string_view decimalMark);
/// "45", "12,5°", "-30 deg", "90 - 12.5": sums of degrees, in radians; else nothing.
std::optional<double> parseAngle(std::string_view text);

/// Named tolerances, all relative to the perimeter, an edge or an area, so that results do not
/// depend on the size or unit of a piece.

/// Closing gap of an outline, relative to its perimeter, below which it counts as closed.
inline constexpr double kClosureTolerance = 1e-10;
/// A triangle whose height is below this fraction of its longest edge has no usable angles: its
/// cotangents would leave fewer than half of a double's digits.
inline constexpr double kDegenerateHeight = 1e-10;
/// A boundary edge shorter than this fraction of the perimeter counts as having no length.
inline constexpr double kZeroLengthEdge = 1e-13;

}  // namespace toile
