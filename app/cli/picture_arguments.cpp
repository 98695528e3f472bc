// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/picture_arguments.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "core/base/units.h"

namespace toile::app {
namespace {

const std::map<std::string, ViewDirection> kLooks = {
    {"front", kFrontView}, {"back", kBackView}, {"left", kLeftView},
    {"right", kRightView}, {"top", kTopView},   {"bottom", kBottomView}};

/// The numbers between separators, all of the text; none where it is anything else.
std::optional<std::array<double, 2>> twoNumbers(const std::string& text, char separator) {
    std::array<double, 2> numbers{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0 && (at == end || *at++ != separator)) {
            return std::nullopt;
        }
        const auto [next, fault] = std::from_chars(at, end, numbers[i]);
        if (fault != std::errc() || !std::isfinite(numbers[i])) {
            return std::nullopt;
        }
        at = next;
    }
    return at == end ? std::optional(numbers) : std::nullopt;
}

}  // namespace

std::string readPictureSize(const std::string& typed, PictureArguments& picture) {
    if (typed.empty()) {
        return {};
    }
    const auto size = twoNumbers(typed, 'x');
    const auto fits = [](double side) -> bool {
        return side >= kMinPicture && side <= kMaxPicture && side == std::floor(side);
    };
    if (!size || !fits((*size)[0]) || !fits((*size)[1])) {
        return "--size must be width and height in whole pixels, such as 1600x800, each from " +
               std::to_string(kMinPicture) + " to " + std::to_string(kMaxPicture);
    }
    picture.width = static_cast<int>((*size)[0]);
    picture.height = static_cast<int>((*size)[1]);
    return {};
}

std::string readPictureLook(const std::string& typed, PictureArguments& picture) {
    if (const auto side = kLooks.find(typed); side != kLooks.end()) {
        picture.direction = side->second;
    } else if (!typed.empty()) {
        const auto degrees = twoNumbers(typed, ',');
        if (!degrees || std::abs((*degrees)[0]) > 360 || std::abs((*degrees)[1]) > 90) {
            return "--look must be a side, or two angles in degrees such as 30,10: around from the "
                   "front within 360, upwards within 90";
        }
        picture.direction = ViewDirection{(*degrees)[0] * kDegree, (*degrees)[1] * kDegree};
    }
    return {};
}

}  // namespace toile::app
