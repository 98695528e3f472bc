// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/units.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/base/text.h"
#include "core/base/wording.h"

namespace toile {
namespace {

/// In the order of the enumeration, like the numbers below.
constexpr Word<LengthUnit> kSymbols[] = {{LengthUnit::Millimetre, "mm"},
                                         {LengthUnit::Centimetre, "cm"},
                                         {LengthUnit::Decimetre, "dm"},
                                         {LengthUnit::Metre, "m"},
                                         {LengthUnit::Inch, "in"}};
constexpr double kMillimetres[] = {1, 10, 100, 1000, 25.4};
constexpr double kSmallestUnit = 1e-6, kLargestUnit = 1e6;

}  // namespace

double millimetresPer(LengthUnit unit) {
    return kMillimetres[static_cast<std::size_t>(unit)];
}

std::string_view symbol(LengthUnit unit) {
    return wordOf(kSymbols, unit);
}

std::optional<LengthUnit> parseLengthUnit(std::string_view text) {
    return parseWord(kSymbols, text);
}

std::optional<FileUnit> FileUnit::ofMillimetres(double millimetres) {
    return millimetres >= kSmallestUnit && millimetres <= kLargestUnit
               ? std::optional(FileUnit(millimetres))
               : std::nullopt;
}

std::optional<LengthUnit> FileUnit::named() const {
    const auto found = std::ranges::find(kMillimetres, millimetres_);
    return found == std::end(kMillimetres)
               ? std::nullopt
               : std::optional(kLengthUnits[found - std::begin(kMillimetres)]);
}

std::string unitText(const FileUnit& unit) {
    const auto named = unit.named();
    return named ? std::string(symbol(*named)) : shortest(unit.millimetres()) + " mm";
}

std::optional<FileUnit> parseFileUnit(std::string_view text) {
    if (const auto named = parseLengthUnit(text)) {
        return *named;
    }
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.starts_with(' ')) {
        text.remove_prefix(1);
    }
    const auto of = parseLengthUnit(text);
    return error == std::errc() && of ? FileUnit::ofMillimetres(number * millimetresPer(*of))
                                      : std::nullopt;
}

namespace {

constexpr std::string_view kMinus = "\u2212", kDash = "\u2013";
/// Beyond, whole numbers are no longer exact, and no garment is that large.
constexpr double kLargest = 1e12;

std::string withMark(std::string text, std::string_view mark) {
    if (const auto at = text.find('.'); at != std::string::npos) {
        text.replace(at, 1, mark);
    }
    return text;
}

std::string fraction(double inches, int denominator) {
    const auto parts = static_cast<long long>(std::llround(std::abs(inches) * denominator));
    const long long whole = parts / denominator, rest = parts % denominator;
    std::string text = inches < 0 && parts != 0 ? "-" : "";
    if (whole != 0 || rest == 0) {
        text += std::to_string(whole);
    }
    if (rest != 0) {
        const long long common = std::gcd(rest, static_cast<long long>(denominator));
        text += whole != 0 ? " " : "";
        text += std::to_string(rest / common) + '/' + std::to_string(denominator / common);
    }
    return text;
}

/// Words and signs for units after a number, and the size of one unit; if two begin alike, the
/// longer one comes first.
constexpr std::pair<std::string_view, double> kLengthWords[] = {
    {"mm", 1},    {"cm", 10},     {"dm", 100},  {"m", 1000},      {"inches", 25.4}, {"inch", 25.4},
    {"in", 25.4}, {"zoll", 25.4}, {"\"", 25.4}, {"\u2033", 25.4}, {"\u201d", 25.4}, {"''", 25.4},
};
constexpr std::pair<std::string_view, double> kAngleUnits[] = {
    {"\u00b0", kDegree}, {"degrees", kDegree}, {"deg", kDegree}, {"grad", kDegree}};

constexpr std::pair<std::string_view, double> kWrittenFractions[] = {
    {"½", 1.0 / 2}, {"¼", 1.0 / 4}, {"¾", 3.0 / 4}, {"⅛", 1.0 / 8},
    {"⅜", 3.0 / 8}, {"⅝", 5.0 / 8}, {"⅞", 7.0 / 8},
};

/// Reads a sum of quantities from left to right.
class QuantityReader {
public:
    template <class UnitTable>
    QuantityReader(std::string_view text, const UnitTable& units, double usual)
        : text_(text), units_(std::begin(units)), unitsEnd_(std::end(units)), usual_(usual) {}

    std::optional<double> sum() {
        double total = 0;
        bool first = true;
        do {
            double sign = 1;
            if (accept("-") || accept(kMinus)) {
                sign = -1;
            } else if (!accept("+") && !first) {
                return std::nullopt;
            }
            const auto term = product();
            if (!term) {
                return std::nullopt;
            }
            total += sign * *term;
            first = false;
        } while (!atEnd());
        return std::abs(total) <= kLargest ? std::optional(total) : std::nullopt;
    }

private:
    /// A quantity, and plain numbers before or after it: "2 * 45 mm", "45 mm / 2", "3/8 in".
    std::optional<double> product() {
        const auto first = number();
        if (!first) {
            return std::nullopt;
        }
        double value = *first;
        std::optional<double> unit = readUnit();
        for (;;) {
            const bool times = accept("*") || accept("\u00d7");
            if (!times && !accept("/")) {
                return value * unit.value_or(usual_);
            }
            const auto factor = number();
            const auto ownUnit = factor ? readUnit() : std::nullopt;
            if (!factor || (ownUnit && unit) || (!times && *factor == 0)) {
                return std::nullopt;
            }
            value = times ? value * *factor : value / *factor;
            unit = ownUnit ? ownUnit : unit;
        }
    }

    /// "12", "31,4", "3/8", "12 3/8", "12⅜", "⅜".
    std::optional<double> number() {
        skipSpace();
        if (const auto written = writtenFraction()) {
            return written;
        }
        bool isWhole = false;
        const auto whole = digits(isWhole);
        if (!whole) {
            return std::nullopt;
        }
        if (!isWhole) {
            return whole;
        }
        if (const auto written = writtenFraction()) {
            return *whole + *written;
        }
        if (const auto part = properFraction()) {
            return *whole + *part;
        }
        return whole;
    }

    std::optional<double> digits(bool& isWhole) {
        skipSpace();
        std::string plain;
        isWhole = true;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            const bool isMark = c == '.' || c == ',';
            if (isMark && !isWhole) {
                return std::nullopt;  // a second mark: "1.234,5" could mean two things
            }
            if (!isMark && (c < '0' || c > '9')) {
                break;
            }
            isWhole = isWhole && !isMark;
            plain += isMark ? '.' : c;
            ++at_;
        }
        double value = 0;
        const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
        const bool good = error == std::errc() && end == plain.data() + plain.size();
        return good && value <= kLargest ? std::optional(value) : std::nullopt;
    }

    /// The "3/8" of "12 3/8"; does not move if there is none.
    std::optional<double> properFraction() {
        const std::size_t before = at_;
        bool isWhole = false;
        if (at_ < text_.size() && text_[at_] == ' ') {
            if (const auto above = digits(isWhole); above && isWhole && accept("/")) {
                const auto below = digits(isWhole);
                if (below && isWhole && *below > 0) {
                    return *above / *below;
                }
            }
        }
        at_ = before;
        return std::nullopt;
    }

    std::optional<double> writtenFraction() {
        for (const auto& [sign, value] : kWrittenFractions) {
            if (accept(sign)) {
                return value;
            }
        }
        return std::nullopt;
    }

    std::optional<double> readUnit() {
        for (auto unit = units_; unit != unitsEnd_; ++unit) {
            if (accept(unit->first)) {
                return unit->second;
            }
        }
        return std::nullopt;
    }

    /// Ignores the case of letters.
    bool accept(std::string_view token) {
        const std::size_t before = at_;
        skipSpace();
        const bool same = equalsIgnoringCase(text_.substr(at_, token.size()), token);
        at_ = same ? at_ + token.size() : before;
        return same;
    }

    void skipSpace() {
        while (at_ < text_.size()) {
            if (text_[at_] == ' ' || text_[at_] == '\t') {
                ++at_;
            } else if (text_.substr(at_, 2) == "\u00a0") {
                at_ += 2;
            } else if (text_.substr(at_, 3) == "\u202f") {
                at_ += 3;
            } else {
                return;
            }
        }
    }

    bool atEnd() {
        skipSpace();
        return at_ == text_.size();
    }

    std::string_view text_;
    const std::pair<std::string_view, double>*units_, *unitsEnd_;
    double usual_;  ///< for numbers without a unit
    std::size_t at_ = 0;
};

}  // namespace

int lengthDecimals(LengthUnit unit) {
    return unit == LengthUnit::Millimetre  ? 1
           : unit == LengthUnit::Decimetre ? 3
           : unit == LengthUnit::Metre     ? 4
                                           : 2;
}

std::string lengthNumber(double millimetres, const LengthFormat& format) {
    if (!(std::abs(millimetres) <= kLargest)) {
        return std::string(kDash);
    }
    const double value = millimetres / millimetresPer(format.unit);
    return format.unit == LengthUnit::Inch && format.denominator > 0
               ? fraction(value, format.denominator)
               : withMark(fixed(value, lengthDecimals(format.unit)), format.decimalMark);
}

std::string lengthText(double millimetres, const LengthFormat& format) {
    return lengthNumber(millimetres, format) + ' ' + std::string(symbol(format.unit));
}

std::optional<double> parseLength(std::string_view text, const LengthFormat& format) {
    return QuantityReader(text, kLengthWords, millimetresPer(format.unit)).sum();
}

std::string angleText(double radians, int decimals, std::string_view decimalMark) {
    std::string text = fixed(radians / kDegree, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return withMark(std::move(text), decimalMark) + "\u00b0";
}

std::optional<double> parseAngle(std::string_view text) {
    return QuantityReader(text, kAngleUnits, kDegree).sum();
}

}  // namespace toile
