// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/notch_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/pattern/seam_places.h"

namespace toile {
namespace {

/// A seam lies towards the back if it is this far behind the middle, as a part of half the
/// garment's depth; side seams and shoulder seams do not.
constexpr double kBackPart = 0.25;
/// Limits for a sleeve head, mm, which exclude neckbands: the line falls by kHeadFall within
/// kHeadWay to either side, and the sleeve hangs kSleeveBelow below the armhole.
constexpr double kHeadWay = 50, kHeadFall = 6, kSleeveBelow = 15;
/// Seams whose lengths differ by less than this part could be confused.
constexpr double kLikeLength = 0.1;

/// Balance notches as shares: none, the middle, quarters, and others for seams that could be
/// confused; each seam starts with the usual ones for its length and continues from there.
constexpr std::array kHalves = std::to_array<double>({0.5});
constexpr std::array kQuarters = std::to_array<double>({0.25, 0.5, 0.75});
constexpr std::array kThirds = std::to_array<double>({1.0 / 3, 2.0 / 3});
constexpr std::array kThird = std::to_array<double>({1.0 / 3});
constexpr std::array kLowQuarters = std::to_array<double>({0.25, 0.5});
constexpr std::array kOuterQuarters = std::to_array<double>({0.25, 0.75});
constexpr std::array kQuarter = std::to_array<double>({0.25});
constexpr std::array kSixths = std::to_array<double>({1.0 / 3, 0.5, 2.0 / 3});
constexpr std::array<std::span<const double>, 9> kRhythms = {std::span<const double>(),
                                                             kHalves,
                                                             kQuarters,
                                                             kThirds,
                                                             kThird,
                                                             kLowQuarters,
                                                             kOuterQuarters,
                                                             kQuarter,
                                                             kSixths};
constexpr int kOfNone = 0, kOfHalves = 1, kOfQuarters = 2;
constexpr int kRhythmCount = static_cast<int>(kRhythms.size());

/// A notch inside a seam.
struct Mark {
    double share = 0;
    int count = 1;
};

std::vector<Mark> marksInside(const std::vector<Notch>& notches) {
    std::vector<Mark> marks;
    for (const Notch& notch : notches) {
        if (notch.share > 0 && notch.share < 1) {
            marks.push_back({notch.share, notch.count});
        }
    }
    std::ranges::sort(marks, {}, &Mark::share);
    return marks;
}

bool areLike(const std::vector<Mark>& a, const std::vector<Mark>& b, double length) {
    return std::ranges::equal(a, b, [length](const Mark& x, const Mark& y) {
        return x.count == y.count && std::abs(x.share - y.share) * length < kNotchGap;
    });
}

}  // namespace

NotchPlaces::NotchPlaces(const Garment& garment, const seam::Outlines& outlines,
                         const std::vector<OutlineSegments>& segments)
    : garment_(garment), outlines_(outlines), segments_(segments), seamsOf_(garment.pieces.size()) {
    const std::vector<Seam>& seams = garment.seams.seams;
    for (int s = 0; s < static_cast<int>(seams.size()); ++s) {
        if (seams[s].right.piece >= 0) {
            seamsOf_[seams[s].left.piece].push_back(s);
            if (seams[s].right.piece != seams[s].left.piece) {
                seamsOf_[seams[s].right.piece].push_back(s);
            }
        }
    }
    double back = std::numeric_limits<double>::infinity(), front = -back;
    for (const seam::Outline& outline : outlines.list) {
        if (outline.size() > 0) {
            back = std::min(back, outline.line.points().col(2).minCoeff());
            front = std::max(front, outline.line.points().col(2).maxCoeff());
        }
    }
    backwards_ = 0.5 * (back + front) - 0.5 * kBackPart * (front - back);
}

double NotchPlaces::lengthOf(int seam) const {
    const Seam& of = garment_.seams.seams[seam];
    return 0.5 * (of.left.length() + of.right.length());
}

int NotchPlaces::countOf(int seam) const {
    const Seam& of = garment_.seams.seams[seam];
    const seam::Outline& outline = outlines_.list[outlines_.indexOf(of.left)];
    return outline.pointAt(placeAtShare(of, 0.5).left).z() < backwards_ ? 2 : 1;
}

bool NotchPlaces::runsOn(const SeamSide& side, double at) const {
    if (side.loop != 0 || static_cast<std::size_t>(side.piece) >= segments_.size()) {
        return false;
    }
    const double perimeter = outlines_.list[side.piece].length();
    return std::ranges::none_of(segments_[side.piece].turnPoints, [&](const TurnPoint& point) {
        return point.isCorner && std::abs(std::remainder(point.at - at, perimeter)) < kNotchGap;
    });
}

double NotchPlaces::lowestOf(const SeamSide& side) const {
    const seam::Outline& outline = outlines_.list[outlines_.indexOf(side)];
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = side.first; k < side.first + side.count; ++k) {
        lowest = std::min(lowest, outline.line.point(k).y());
    }
    return lowest;
}

bool NotchPlaces::isSleeveHead(const SeamSide& side, double at) const {
    const seam::Outline& outline = outlines_.list[side.piece];
    const double top = outline.pointAt(at).y() - kHeadFall;
    if (outline.pointAt(at - kHeadWay).y() > top || outline.pointAt(at + kHeadWay).y() > top) {
        return false;
    }
    double lowest = lowestOf(side);  // of both seams of the armhole
    for (const int s : seamsOf_[side.piece]) {
        for (const SeamSide& next : {garment_.seams.seams[s].left, garment_.seams.seams[s].right}) {
            if (next.piece == side.piece && next.loop == 0 &&
                (std::abs(std::remainder(next.start - at, outline.length())) < kNotchGap ||
                 std::abs(std::remainder(next.end - at, outline.length())) < kNotchGap)) {
                lowest = std::min(lowest, lowestOf(next));
            }
        }
    }
    return outline.line.points().col(1).minCoeff() < lowest - kSleeveBelow;
}

std::vector<Notch> NotchPlaces::fixed(int index) const {
    const Seam& seam = garment_.seams.seams[index];
    std::vector<Notch> notches;
    if (seam.closed) {
        if (lengthOf(index) >= kHalvedSeam) {
            notches.push_back({.seam = index, .count = countOf(index)});
        }
    } else {
        for (const bool atEnd : {false, true}) {
            const double left = atEnd ? seam.left.end : seam.left.start;
            const double right = atEnd ? seam.right.end : seam.right.start;
            Notch end{.seam = index, .share = atEnd ? 1.0 : 0.0};
            end.onLeft = runsOn(seam.left, left);
            end.onRight = runsOn(seam.right, right);
            const bool isHead = (end.onLeft && isSleeveHead(seam.left, left)) ||
                                (end.onRight && isSleeveHead(seam.right, right));
            end.reason = isHead ? NotchReason::SleeveHead : NotchReason::SeamEnd;
            if (end.onLeft || end.onRight) {
                notches.push_back(end);
            }
        }
    }
    if (seam.ease && seam.drawn && seam.drawn->from < seam.drawn->to) {
        const bool onRight = *seam.ease < 0;  // the longer side
        const SeamSide& longer = onRight ? seam.right : seam.left;
        for (const double part : {seam.drawn->from, seam.drawn->to}) {
            const double arc = longer.start + part * (longer.end - longer.start);
            const double share = shareOf(seam, placeOnSide(seam, onRight, arc));
            if (std::min(share, 1 - share) * lengthOf(index) >= kNotchGap) {
                notches.push_back({.seam = index,
                                   .share = share,
                                   .count = countOf(index),
                                   .reason = NotchReason::EaseStart});
            }
        }
    }
    return notches;
}

int NotchPlaces::ways() {
    return 2 * kRhythmCount;  // each also with its first notch doubled, if it is single
}

std::vector<Notch> NotchPlaces::balanced(int seam, std::vector<Notch> notches, int way) const {
    const double length = lengthOf(seam);
    const int usual = length >= kQuarteredSeam ? kOfQuarters
                      : length >= kHalvedSeam  ? kOfHalves
                                               : kOfNone;
    const int next = (usual + way) % kRhythmCount;
    const int rhythm = next == kOfNone ? usual : next;
    int count = countOf(seam);
    count = way < kRhythmCount ? count : 3 - count;
    for (const double share : kRhythms[rhythm]) {
        const bool isNearEnd = std::min(share, 1 - share) * length < kNotchGap;
        const bool isNear = std::ranges::any_of(notches, [&](const Notch& other) {
            return std::abs(share - other.share) * length < kNotchGap;
        });
        if (!isNearEnd && !isNear) {
            notches.push_back({.seam = seam, .share = share, .count = count});
            count = countOf(seam);
        }
    }
    return notches;
}

bool NotchPlaces::canBeConfused(int one, const std::vector<Notch>& notches, int other,
                                const std::vector<Notch>& others) const {
    const auto isPlain = [this](int s) { return garment_.seams.seams[s].kind == SeamKind::Seam; };
    const auto [shorter, longer] = std::minmax({lengthOf(one), lengthOf(other)});
    if (!isPlain(one) || !isPlain(other) || longer - shorter > kLikeLength * longer) {
        return false;
    }
    const std::vector<Mark> a = marksInside(notches), b = marksInside(others);
    std::vector<Mark> backwards(b.rbegin(), b.rend());
    for (Mark& mark : backwards) {
        mark.share = 1 - mark.share;
    }
    return areLike(a, b, longer) || areLike(a, backwards, longer);
}

}  // namespace toile
