// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/svg_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

namespace toile {
namespace {

constexpr std::string_view kSvgBlanks = " \t\r\n\f,";
constexpr double kPixel = 25.4 / 96;  // mm

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

struct SvgUnit {
    std::string_view name;
    double millimetres;
};

constexpr SvgUnit kSvgUnits[] = {{"", kPixel}, {"px", kPixel}, {"pt", 25.4 / 72}, {"pc", 25.4 / 6},
                                 {"mm", 1},    {"cm", 10},     {"in", 25.4},      {"Q", 0.25}};

/// One map of a list; the identity if numbers are missing.
Eigen::Affine2d singleTransform(std::string_view name, const std::vector<double>& n) {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
    if (name == "matrix" && n.size() == 6) {
        map.matrix() << n[0], n[2], n[4], n[1], n[3], n[5], 0, 0, 1;
    } else if (name == "translate" && !n.empty()) {
        map.translate(Eigen::Vector2d(n[0], n.size() > 1 ? n[1] : 0));
    } else if (name == "scale" && !n.empty()) {
        map.scale(Eigen::Vector2d(n[0], n.size() > 1 ? n[1] : n[0]));
    } else if (name == "rotate" && !n.empty()) {
        const Eigen::Vector2d middle =
            n.size() > 2 ? Eigen::Vector2d(n[1], n[2]) : Eigen::Vector2d(0, 0);
        map.translate(middle).rotate(radians(n[0])).translate(-middle);
    } else if (name == "skewX" && n.size() == 1) {
        map.matrix()(0, 1) = std::tan(radians(n[0]));
    } else if (name == "skewY" && n.size() == 1) {
        map.matrix()(1, 0) = std::tan(radians(n[0]));
    }
    return map;
}

}  // namespace

void SvgNumbers::skipBlanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kSvgBlanks), rest_.size()));
}

std::optional<double> SvgNumbers::number() {
    skipBlanks();
    std::string_view text = rest_;
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    // from_chars would also accept "nan" and "infinity".
    const std::size_t digit = text.starts_with('-') ? 1 : 0;
    if (text.size() <= digit ||
        !((text[digit] >= '0' && text[digit] <= '9') || text[digit] == '.')) {
        return {};
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) {
        return {};
    }
    rest_ = text.substr(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::optional<Eigen::Vector2d> SvgNumbers::pair() {
    const auto x = number();
    const auto y = x ? number() : std::nullopt;
    return y ? std::optional(Eigen::Vector2d(*x, *y)) : std::nullopt;
}

std::optional<bool> SvgNumbers::flag() {
    skipBlanks();
    if (!rest_.starts_with('0') && !rest_.starts_with('1')) {
        return {};
    }
    const bool isSet = rest_.front() == '1';
    rest_.remove_prefix(1);
    return isSet;
}

std::optional<char> SvgNumbers::letter() {
    skipBlanks();
    if (rest_.empty() || !isLetter(rest_.front())) {
        return {};
    }
    const char letter = rest_.front();
    rest_.remove_prefix(1);
    return letter;
}

std::optional<SvgNumbers::Call> SvgNumbers::call() {
    skipBlanks();
    const std::size_t open = rest_.find('('), close = rest_.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
        return {};
    }
    std::string_view name = rest_.substr(0, open);
    const std::size_t last = name.find_last_not_of(kSvgBlanks);
    name = name.substr(0, last == std::string_view::npos ? 0 : last + 1);
    const Call call{name, rest_.substr(open + 1, close - open - 1)};
    rest_.remove_prefix(close + 1);
    return call;
}

Eigen::Affine2d svgTransform(std::string_view list) {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    SvgNumbers calls(list);
    while (const auto call = calls.call()) {
        std::vector<double> numbers;
        SvgNumbers arguments(call->list);
        while (const auto number = arguments.number()) {
            numbers.push_back(*number);
        }
        map = map * singleTransform(call->name, numbers);
    }
    return map;
}

std::optional<double> svgLength(std::string_view text) {
    SvgNumbers numbers(text);
    const auto value = numbers.number();
    std::string_view unit = numbers.rest();
    const std::size_t last = unit.find_last_not_of(kSvgBlanks);
    unit = unit.substr(0, last == std::string_view::npos ? 0 : last + 1);
    const auto known = std::ranges::find(kSvgUnits, unit, &SvgUnit::name);
    return value && known != std::end(kSvgUnits) ? std::optional(*value * known->millimetres)
                                                 : std::nullopt;
}

}  // namespace toile
