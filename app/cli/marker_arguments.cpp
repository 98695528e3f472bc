// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/marker_arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/text.h"
#include "core/formats/drawing/marker_drawing.h"
#include "core/formats/formats.h"
#include "core/garment/fabric.h"

namespace toile::app {
namespace {

/// The numbers between these marks, all of them; nothing where there are others.
std::vector<double> numbersOf(std::string_view typed, std::string_view marks) {
    std::vector<double> numbers;
    while (true) {
        double value = 0;
        const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), value);
        if (error != std::errc() || !std::isfinite(value)) {
            return {};
        }
        numbers.push_back(value);
        typed.remove_prefix(static_cast<std::size_t>(end - typed.data()));
        if (typed.empty()) {
            return numbers;
        }
        if (numbers.size() > marks.size() || typed.front() != marks[numbers.size() - 1]) {
            return {};
        }
        typed.remove_prefix(1);
    }
}

bool isSheetSide(double side) {
    return side >= 1 && side <= kMaxClothWidth;
}

bool endsInJson(const std::filesystem::path& path) {
    return equalsIgnoringCase(path.extension().string(), ".json");
}

/// What an instance says itself, or has no room for.
const char* saidOfGarments(const MarkerArguments& typed) {
    MarkerSettings plain;
    plain.gap = typed.settings.gap;
    plain.border = typed.settings.border;
    plain.seed = typed.settings.seed;
    return typed.minutesPerMetre        ? "--minutes-per-metre"
           : typed.material             ? "--material"
           : !typed.hides.empty()       ? "--hide"
           : !(typed.settings == plain) ? "--width, --sheet, --garments and the rules of cloth"
                                        : nullptr;
}

}  // namespace

MarkerSettings over(MarkerSettings saved, const MarkerArguments& arguments,
                    const MarkerSettings& typed) {
    if (typed.width > 0 || typed.sheet || !typed.hides.empty()) {  // another cloth
        saved.width = typed.width;
        saved.sheet = typed.sheet;
        saved.hides = typed.hides;
    }
    for (const auto& take : arguments.stated) {
        take(typed, saved);
    }
    return saved;
}

bool isToGoOn(const MarkerArguments& typed, int rounds, double seconds) {
    const bool hasRounds = !typed.rounds || rounds < *typed.rounds;
    const double most = typed.seconds.value_or(typed.rounds ? seconds + 1 : kUsualMarkerSeconds);
    return hasRounds && seconds < most;
}

bool isNestInstance(const std::filesystem::path& path) {
    return endsInJson(path);
}

std::string readSheet(const std::string& typed, MarkerSettings& settings) {
    const std::vector<double> sides = numbersOf(typed, "x");
    if (sides.size() != 2 || !isSheetSide(sides[0]) || !isSheetSide(sides[1])) {
        return "--sheet needs the sides along and across the warp, from 1 to " +
               shortest(kMaxClothWidth) + " mm, as in 305x610, not \"" + typed + "\"";
    }
    settings.sheet = Eigen::Vector2d(sides[0], sides[1]);
    return {};
}

std::string readRepeat(const std::string& typed, MarkerSettings& settings) {
    const std::vector<double> numbers = numbersOf(typed, "x@,");
    const bool hasOrigin = numbers.size() == 4;
    if ((numbers.size() != 2 && !hasOrigin) || std::min(numbers[0], numbers[1]) < 0 ||
        std::max(numbers[0], numbers[1]) > kMaxClothWidth ||
        (hasOrigin && std::max(std::abs(numbers[2]), std::abs(numbers[3])) > kMaxClothWidth)) {
        return "--repeat needs the repeat along and across the warp (0 for none), optionally with "
               "its start, as in 80x60 or 80x0@10,5, not \"" +
               typed + "\"";
    }
    settings.repeat.warp = numbers[0];
    settings.repeat.weft = numbers[1];
    if (hasOrigin) {
        settings.repeat.origin = {numbers[2], numbers[3]};
    }
    return {};
}

std::string readGrade(const std::string& typed, MarkerSettings& settings) {
    const std::size_t at = typed.rfind('=');
    int grade = 0;
    if (at != std::string::npos && at > 0) {
        const char* const end = typed.data() + typed.size();
        const auto read = std::from_chars(typed.data() + at + 1, end, grade);
        grade = read.ec == std::errc() && read.ptr == end ? grade : 0;
    }
    if (grade < 1) {
        return "--grade needs a piece and its lowest allowed grade, as in front=2, not \"" + typed +
               "\"";
    }
    settings.grades[typed.substr(0, at)] = grade;
    return {};
}

std::string wrongTogether(const MarkerSettings& typed, const MarkerSettings& settings) {
    if (settings.isFolded && (settings.sheet || !settings.hides.empty()) &&
        (typed.isFolded || typed.sheet || !typed.hides.empty())) {
        return "--folded needs a roll; leave out --sheet and --hide";
    }
    if (!typed.grades.empty() && settings.hides.empty()) {
        return "--grade needs --hide, whose zones have grades";
    }
    if (!typed.matched.empty() && settings.repeat == ClothRepeat{}) {
        return "--match needs the repeat of the stripes; add --repeat";
    }
    return {};
}

std::string wrongInMarker(const std::vector<std::filesystem::path>& inputs,
                          const std::vector<std::filesystem::path>& outputs,
                          const MarkerArguments& typed) {
    const MarkerSettings& settings = typed.settings;
    if (std::ranges::any_of(inputs, isNestInstance)) {
        const char* other = saidOfGarments(typed);
        if (inputs.size() > 1) {
            return "a nesting problem must be the only input: \"" +
                   std::ranges::find_if(inputs, isNestInstance)->string() + "\"";
        }
        if (other) {
            return std::string("a nesting problem sets its own shapes and strip; use ") + other +
                   " only with a garment or a project";
        }
        for (const auto& output : outputs) {
            if (!equalsIgnoringCase(output.extension().string(), ".svg")) {
                return "the result of a nesting problem must be .svg, not \"" + output.string() +
                       "\"";
            }
        }
        return {};
    }
    for (const auto& output : outputs) {
        if (!holdsMarkers(output)) {
            return "\"" + output.string() +
                   "\" has a format that markers do not support; use .svg, .dxf, .pdf, .plt or, in "
                   "builds with the window, .png";
        }
    }
    const int cloths =
        (settings.width > 0 ? 1 : 0) + (settings.sheet ? 1 : 0) + (typed.hides.empty() ? 0 : 1);
    if (cloths > 1) {
        return "--width, --sheet and --hide exclude each other; use one of them";
    }
    return {};
}

}  // namespace toile::app
