// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/label.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

#include "core/base/characters.h"
#include "core/pattern/pole.h"

namespace toile {
namespace {

constexpr double kAir = 1;  // total margin beside and above the block, in capital heights
constexpr PoleSearch kLabelSearch{.tolerance = 0.01, .slack = 0.05, .useful = kSmallestLabel};

/// Splits at the blank that makes the longer part shortest; not split if there is none.
std::vector<std::string> halves(const std::string& line) {
    std::vector<std::string> best{line};
    std::size_t shortest = characterCount(line);
    for (std::size_t at = line.find(' '); at != std::string::npos; at = line.find(' ', at + 1)) {
        std::string before = line.substr(0, at), after = line.substr(at + 1);
        const std::size_t longer = std::max(characterCount(before), characterCount(after));
        if (longer < shortest && !before.empty() && !after.empty()) {
            shortest = longer;
            best = {std::move(before), std::move(after)};
        }
    }
    return best;
}

std::size_t longestOf(const std::vector<std::string>& lines) {
    std::size_t longest = 1;
    for (const std::string& line : lines) {
        longest = std::max(longest, characterCount(line));
    }
    return longest;
}

}  // namespace

Eigen::Vector2d textExtent(const std::vector<std::string>& lines, double height) {
    const double rows = lines.empty() ? 1 : static_cast<double>(lines.size());
    return height * Eigen::Vector2d(kCharacterWidth * static_cast<double>(longestOf(lines)),
                                    1 + kLineSpacing * (rows - 1));
}

std::vector<std::string> brokenLines(const std::vector<std::string>& lines) {
    std::size_t width = 1;
    for (const std::string& line : lines) {
        width = std::max(width, longestOf(halves(line)));
    }
    std::vector<std::string> broken;
    for (const std::string& line : lines) {
        if (characterCount(line) <= width) {
            broken.push_back(line);
        } else {
            std::ranges::move(halves(line), std::back_inserter(broken));
        }
    }
    return broken;
}

Points2 textBox(const LabelPlace& place, const std::vector<std::string>& lines, double angle,
                double clear) {
    const Eigen::Vector2d size = textExtent(lines, place.height);
    const double right = 0.5 * size.x() + clear, top = 0.5 * place.height + clear;
    const double bottom = top - size.y() - 2 * clear;
    Points2 box(5, 2);
    box << -right, bottom, right, bottom, right, top, -right, top, -right, bottom;
    return (box * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose()).rowwise() +
           place.position.transpose();
}

LabelPlace placeLabel(const std::vector<Points2>& loops, const std::vector<std::string>& lines,
                      const std::vector<Points2>& obstacles) {
    const Eigen::Vector2d size = textExtent(lines, 1);
    const FreeCloth cloth{loops, obstacles};
    const auto pole = boxPole(cloth, size.array() + kAir, 0, coarserIfSmall(kLabelSearch, cloth));
    Eigen::Vector2d middle(0, 0);
    if (pole) {
        middle = pole->place;
    } else if (!loops.empty() && loops.front().rows() > 0 && loops.front().allFinite()) {
        middle = 0.5 * (loops.front().colwise().minCoeff() + loops.front().colwise().maxCoeff());
    }
    const double height = std::clamp(pole ? pole->room : 0, kSmallestLabel, kLargestLabel);
    middle.y() += 0.5 * (size.y() - 1) * height;  // to the middle of the first line
    return {middle, height, pole && pole->room >= kSmallestLabel};
}

}  // namespace toile
