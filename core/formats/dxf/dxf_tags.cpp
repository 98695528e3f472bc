// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/dxf_tags.h"

#include "core/base/characters.h"
#include "core/base/text.h"

namespace toile {
namespace {

constexpr std::size_t kLongestText = 250;  // limit of strings in R12
constexpr int kNumberDecimals = 4;

/// 4 decimals of a millimetre, one more for the larger units.
int decimalsOf(LengthUnit unit) {
    return unit == LengthUnit::Millimetre  ? 4
           : unit == LengthUnit::Metre     ? 7
           : unit == LengthUnit::Decimetre ? 6
                                           : 5;
}

}  // namespace

DxfTags::DxfTags(LengthUnit unit) : perUnit_(millimetresPer(unit)), decimals_(decimalsOf(unit)) {}

void DxfTags::tag(int code, std::string_view value) {
    const std::string digits = std::to_string(code);
    out_.append(digits.size() < 3 ? 3 - digits.size() : 0, ' ').append(digits);
    out_.append("\r\n").append(value).append("\r\n");
}

void DxfTags::tag(int code, int value) {
    tag(code, std::string_view(std::to_string(value)));
}

void DxfTags::length(int code, double millimetres) {
    tag(code, std::string_view(digits(millimetres)));
}

void DxfTags::number(int code, double value) {
    tag(code, std::string_view(fixed(value, kNumberDecimals)));
}

void DxfTags::flatPoint(int first, const Eigen::Vector2d& point) {
    length(first, point.x());
    length(first + 10, point.y());
}

void DxfTags::point(int first, const Eigen::Vector2d& point) {
    flatPoint(first, point);
    length(first + 20, 0);
}

void DxfTags::beginSection(const char* name) {
    tag(0, "SECTION");
    tag(2, name);
}

void DxfTags::endSection() {
    tag(0, "ENDSEC");
}

void DxfTags::beginTable(const char* name, int entries) {
    tag(0, "TABLE");
    tag(2, name);
    tag(70, entries);
}

void DxfTags::endTable() {
    tag(0, "ENDTAB");
}

std::string DxfTags::digits(double millimetres) const {
    return fixed(millimetres / perUnit_, decimals_);
}

std::string dxfText(std::string_view line) {
    std::string text = asciiText(line).substr(0, kLongestText);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool doubled = text[i] == '%' && i + 1 < text.size() && text[i + 1] == '%';
        if (doubled || text[i] == '^') {
            text[i] = '_';
        }
    }
    return text;
}

}  // namespace toile
