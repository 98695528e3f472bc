// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/label.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/base/characters.h"

namespace toile {
namespace {

constexpr std::array kHeights{6.0, 5.0, 4.0, 3.5, 3.0, 2.5, 2.0, 1.5};  // mm, tried in turn
constexpr int kLevels = 41;       // tried from bottom to top; odd, so that the middle is one
constexpr double kClearance = 1;  // capital heights kept free beside and above the block together
constexpr double kClearlyWider = 1.02;  // times another chord

/// A horizontal range; inside an outline, the free one.
struct Range {
    double left = 0, right = 0;

    double width() const { return right - left; }
};

/// What an edge takes away from a horizontal band.
struct Blocked {
    Range range;
    bool crossesMiddle;
};

/// The part of edge a-b within the band, if any, as seen from above.
std::optional<Blocked> blockedBy(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double low,
                                 double high) {
    const double yMin = std::min(a.y(), b.y()), yMax = std::max(a.y(), b.y());
    if (yMax < low || yMin > high) {
        return std::nullopt;
    }
    const auto xAt = [&](double y) {
        const double t = yMax > yMin ? std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0) : 0.0;
        return a.x() + t * (b.x() - a.x());
    };
    double x0 = a.x(), x1 = b.x();
    if (yMax > yMin) {
        x0 = xAt(std::max(yMin, low));
        x1 = xAt(std::min(yMax, high));
    }
    const double middle = 0.5 * (low + high);
    return Blocked{{std::min(x0, x1), std::max(x0, x1)}, (a.y() > middle) != (b.y() > middle)};
}

/// Brings them in order from left to right. Those that begin in one stretch of half the width
/// `least` are made one, where that is less work than sorting all: no free range of that width lies
/// between them, and so the time is linear in the edges however they crowd.
void bringInOrder(std::vector<Blocked>& blocked, double least) {
    const auto left = [](const Blocked& part) { return part.range.left; };
    const auto [first, last] = std::ranges::minmax_element(blocked, {}, left);
    const double from = blocked.empty() ? 0 : left(*first), perMillimetre = 2 / least;
    const double count = blocked.empty() ? 0 : (left(*last) - from) * perMillimetre + 1;
    if (!(count < static_cast<double>(blocked.size()))) {
        std::ranges::sort(blocked, {}, left);
        return;
    }
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::vector<Blocked> stretches(static_cast<std::size_t>(count) + 1, {{kNone, -kNone}, false});
    for (const Blocked& part : blocked) {
        Blocked& all = stretches[static_cast<std::size_t>((left(part) - from) * perMillimetre)];
        all.range = {std::min(all.range.left, part.range.left),
                     std::max(all.range.right, part.range.right)};
        all.crossesMiddle = all.crossesMiddle != part.crossesMiddle;
    }
    std::erase_if(stretches, [&](const Blocked& all) { return left(all) == kNone; });
    blocked.assign(stretches.begin(), stretches.end());
}

/// The widest range over which the whole band from `low` to `high` lies on the cloth, as long as it
/// is as wide as `least`; else any that is narrower, or none.
/// @param blocked  room for the work, kept from one call to the next
Range widestFree(const std::vector<Points2>& loops, double low, double high, double least,
                 std::vector<Blocked>& blocked) {
    blocked.clear();
    for (const Points2& loop : loops) {
        const Eigen::Index n = loop.rows();
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::Index next = i + 1 < n ? i + 1 : 0;
            if (const auto part = blockedBy(loop.row(i), loop.row(next), low, high)) {
                blocked.push_back(*part);
            }
        }
    }
    Range best;
    bool inside = false;  // of the gap to the right of all edges seen so far
    double reach = -std::numeric_limits<double>::infinity();
    bringInOrder(blocked, least);
    for (const auto& [range, crossesMiddle] : blocked) {
        if (inside && range.left - reach > best.width()) {
            best = {reach, range.left};
        }
        reach = std::max(reach, range.right);
        inside = inside != crossesMiddle;
    }
    return best;
}

/// The height of level k of kLevels between two heights.
double levelHeight(double low, double high, int k) {
    return low + (high - low) * k / (kLevels - 1);
}

/// Middle of a place where a block of this size lies on the cloth: of the levels at which it
/// fits, the run nearest to the outline's middle, and the middle of that run.
std::optional<Eigen::Vector2d> findRoom(const std::vector<Points2>& loops,
                                        const Eigen::Vector2d& size) {
    const Points2& outline = loops.front();
    const double low = outline.col(1).minCoeff() + 0.5 * size.y();
    const double high = outline.col(1).maxCoeff() - 0.5 * size.y();
    if (low > high) {
        return std::nullopt;
    }
    std::array<Range, kLevels> free;
    std::vector<Blocked> blocked;
    const auto fits = [&](int k) { return k >= 0 && k < kLevels && free[k].width() >= size.x(); };
    for (int k = 0; k < kLevels; ++k) {
        const double y = levelHeight(low, high, k);
        free[k] = widestFree(loops, y - 0.5 * size.y(), y + 0.5 * size.y(), size.x(), blocked);
    }
    for (int distance = 0; distance <= kLevels / 2; ++distance) {
        for (const int nearest : {kLevels / 2 + distance, kLevels / 2 - distance}) {
            if (!fits(nearest)) {
                continue;
            }
            int first = nearest, last = nearest;
            while (fits(first - 1)) {
                --first;
            }
            while (fits(last + 1)) {
                ++last;
            }
            const int k = (first + last) / 2;
            return Eigen::Vector2d(0.5 * (free[k].left + free[k].right), levelHeight(low, high, k));
        }
    }
    return std::nullopt;
}

/// Of chords about equally wide, the one nearest to the outline's middle.
Eigen::Vector2d middleOfWidestChord(const std::vector<Points2>& loops) {
    const Points2& outline = loops.front();
    const Eigen::Vector2d low = outline.colwise().minCoeff().transpose();
    const Eigen::Vector2d high = outline.colwise().maxCoeff().transpose();
    Eigen::Vector2d middle = 0.5 * (low + high);
    double width = 0;
    std::vector<Blocked> blocked;
    for (int distance = 0; distance <= kLevels / 2; ++distance) {
        for (const int k : {kLevels / 2 + distance, kLevels / 2 - distance}) {
            const double y = levelHeight(low.y(), high.y(), k);
            const Range free = widestFree(loops, y, y, kClearlyWider * width, blocked);
            if (free.width() > kClearlyWider * width) {
                width = free.width();
                middle = {0.5 * (free.left + free.right), y};
            }
        }
    }
    return middle;
}

}  // namespace

Eigen::Vector2d textExtent(const std::vector<std::string>& lines, double height) {
    std::size_t longest = 1;
    for (const std::string& line : lines) {
        longest = std::max(longest, characterCount(line));
    }
    const double rows = lines.empty() ? 1 : static_cast<double>(lines.size());
    return height * Eigen::Vector2d(kCharacterWidth * static_cast<double>(longest),
                                    1 + kLineSpacing * (rows - 1));
}

LabelPlace placeLabel(const std::vector<Points2>& loops, const std::vector<std::string>& lines) {
    const bool hasOutline = !loops.empty() && loops.front().rows() > 0;
    double height = kHeights.back();
    std::optional<Eigen::Vector2d> middle;
    if (hasOutline) {
        for (const double trial : kHeights) {
            const Eigen::Vector2d clearance = Eigen::Vector2d::Constant(kClearance * trial);
            middle = findRoom(loops, textExtent(lines, trial) + clearance);
            if (middle) {
                height = trial;
                break;
            }
        }
    }
    if (!middle) {
        middle = hasOutline ? middleOfWidestChord(loops) : Eigen::Vector2d(0, 0);
    }
    middle->y() += 0.5 * (textExtent(lines, height).y() - height);  // to the first line's middle
    return {*middle, height};
}

}  // namespace toile
