// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/notches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/segments.h"
#include "core/pattern/walk.h"
#include "core/seam/outline.h"
#include "core/seam/seam_settings.h"

// Internal header of this folder.
namespace toile {
namespace {

/// Places of automatic notches, seam by seam. They have a share, a count, a reason and sides.
class NotchPlaces {
public:
    /// The arguments must outlive this.
    NotchPlaces(const Garment& garment, const seam::Outlines& outlines,
                const std::vector<OutlineSegments>& segments);

    /// Fixed notches: at ends that no corner marks, at ease, at the start of a closed seam.
    std::vector<Notch> fixed(int seam) const;
    /// Adds balance notches in one of the possible ways, except those too near to another notch; 0
    /// is the usual way for the seam's length.
    std::vector<Notch> balanced(int seam, std::vector<Notch> notches, int way) const;
    static int ways();

    /// Whether two seams of a piece could be confused by their length and notches.
    bool canBeConfused(int one, const std::vector<Notch>& notches, int other,
                       const std::vector<Notch>& others) const;

    /// The sewn seams that touch a piece, ascending.
    const std::vector<int>& seamsOf(int piece) const { return seamsOf_[piece]; }
    double lengthOf(int seam) const;
    /// By convention: 2 towards the back.
    int countOf(int seam) const;

private:
    bool runsOn(const SeamSide& side, double at) const;
    bool isSleeveHead(const SeamSide& side, double at) const;
    double lowestOf(const SeamSide& side) const;

    const Garment& garment_;
    const seam::Outlines& outlines_;
    const std::vector<OutlineSegments>& segments_;
    std::vector<std::vector<int>> seamsOf_;
    double backwards_ = 0;  ///< seams with less z than this are towards the back
};

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

/// Places nearer to each other than this are the same, mm.
constexpr double kOnePlace = 1e-3;
/// Half the length, in shares, of the stretch that represents a place on a line.
constexpr double kHalfPlace = 1e-9;

/// The mirror image of a seam, and its orientation.
struct MirroredSeam {
    int seam = -1;         ///< -1: none
    bool turned = false;   ///< runs in the opposite direction
    bool swapped = false;  ///< its left side mirrors the other's right side
};

const SeamSide& seamSide(const Seam& seam, bool isRight) {
    return isRight ? seam.right : seam.left;
}

/// For a pair of segments: mirrored outlines run in opposite directions.
std::vector<MirroredSeam> mirroredSeams(const Garment& garment, const Symmetry* symmetry) {
    const std::vector<Seam>& seams = garment.seams.seams;
    std::vector<MirroredSeam> mirrored(seams.size());
    for (std::size_t p = 0; symmetry && p < symmetry->segments.size(); ++p) {
        for (std::size_t i = 0; i < symmetry->segments[p].size(); ++i) {
            const MirrorSegment& one = symmetry->segments[p][i];
            const int pair = symmetry->pairs[p][i];
            if (pair < 0 || one.seam < 0) {
                continue;
            }
            const MirrorSegment& other = symmetry->segments[symmetry->pieces.counterpart[p]][pair];
            if (symmetry->lengths.mirrored[one.seam] == other.seam && !seams[one.seam].closed &&
                !seams[other.seam].closed) {  // closed seams start anywhere
                mirrored[one.seam] = {other.seam,
                                      seamSide(seams[one.seam], one.isRight).reversed ==
                                          seamSide(seams[other.seam], other.isRight).reversed,
                                      one.isRight != other.isRight};
            }
        }
    }
    return mirrored;
}

/// A place on the line of a seam.
struct SeamSpot {
    int seam = -1;
    double share = 0;
};

/// The seams at a place of a line; two if one ends where the next starts.
std::vector<SeamSpot> spotsOf(const NotchSettings& stated, const Garment& garment,
                              const seam::Outlines& outlines) {
    const double sense = stated.reversed ? -1 : 1;
    const LineStretch place{stated.line, stated.at - sense * kHalfPlace,
                            stated.at + sense * kHalfPlace};
    std::vector<SeamSpot> spots;
    for (std::size_t o = 0; o < outlines.list.size(); ++o) {
        const seam::Outline& outline = outlines.list[o];
        if (outline.size() == 0) {
            continue;
        }
        const auto parts = partsOf(place, outline, *garment.pieces[outline.piece]);
        for (std::size_t s = 0; !parts.empty() && s < garment.seams.seams.size(); ++s) {
            const Seam& seam = garment.seams.seams[s];
            for (const bool isRight : {false, true}) {
                const SeamSide& side = seamSide(seam, isRight);
                if (seam.matches.empty() || outlines.indexOf(side) != static_cast<int>(o)) {
                    continue;
                }
                const double low = std::min(side.start, side.end) - kOnePlace;
                const double past = outline.wrap((parts[0].low + parts[0].high) / 2 - low);
                if (past <= side.length() + 2 * kOnePlace) {
                    spots.push_back({static_cast<int>(s),
                                     shareOf(seam, placeOnSide(seam, isRight, low + past))});
                }
            }
        }
    }
    return spots;
}

/// Collects the notches of a garment. Of two seams that mirror each other the first leads, and the
/// other gets its notches.
class NotchFinder {
public:
    NotchFinder(const Garment& garment, const PieceResults& results,
                const std::vector<OutlineSegments>& segments, const Symmetry* symmetry)
        : garment_(garment),
          seams_(garment.seams.seams),
          outlines_(seam::buildOutlines(garment.pieces)),
          loops_(results),
          places_(garment, outlines_, segments),
          mirrored_(mirroredSeams(garment, symmetry)),
          notches_(seams_.size()) {
        for (int s = 0; s < count(); ++s) {
            const int other = mirrored_[s].seam;
            if (other >= 0 && (!isNotched(s) || !isNotched(other))) {
                mirrored_[s] = {};
            }
        }
    }

    std::vector<std::vector<Notch>> found(const NotchRules& rules) {
        for (int s = 0; rules.automatic && s < count(); ++s) {
            if (isNotched(s) && !seams_[s].stacked && leaderOf(s) == s) {
                notches_[s] = automatic(s);
                mirror(s);
            }
        }
        for (const NotchSettings& stated : rules.notches) {
            apply(stated);
        }
        for (int s = 0; s < count(); ++s) {
            if (leaderOf(s) == s) {
                mirror(s);
            }
        }
        for (int s = 0; s < count(); ++s) {
            place(s);
        }
        showOnce();
        return std::move(notches_);
    }

private:
    int count() const { return static_cast<int>(seams_.size()); }
    bool isNotched(int s) const {
        return !seams_[s].matches.empty() && loops_.isFlat(seams_[s].left) &&
               loops_.isFlat(seams_[s].right);
    }
    int leaderOf(int s) const {
        const int other = mirrored_[s].seam;
        return other < 0 ? s : std::min(s, other);
    }

    /// The first way of placing balance notches that cannot be confused with an earlier seam's; the
    /// usual way if there is none.
    std::vector<Notch> automatic(int s) const {
        const std::vector<Notch> fixed = places_.fixed(s);
        std::vector<Notch> usual;
        for (int way = 0; way < NotchPlaces::ways(); ++way) {
            std::vector<Notch> notches = symmetrised(s, places_.balanced(s, fixed, way));
            if (!isConfusable(s, notches)) {
                return notches;
            }
            if (way == 0) {
                usual = std::move(notches);
            }
        }
        return usual;
    }

    bool isConfusable(int s, const std::vector<Notch>& notches) const {
        for (const int one : {s, mirrored_[s].seam}) {
            for (const bool isRight : {false, true}) {
                if (one < 0) {
                    continue;
                }
                for (const int other : places_.seamsOf(seamSide(seams_[one], isRight).piece)) {
                    if (leaderOf(other) < s && !seams_[other].stacked && isNotched(other) &&
                        places_.canBeConfused(s, notches, other, notches_[other])) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    Notch image(Notch notch) const {
        const MirroredSeam& to = mirrored_[notch.seam];
        notch.seam = to.seam;
        notch.share = to.turned ? 1 - notch.share : notch.share;
        if (to.swapped) {
            std::swap(notch.onLeft, notch.onRight);
        }
        return notch;
    }

    /// For a seam that is its own image turned around, the first half counts.
    std::vector<Notch> symmetrised(int s, const std::vector<Notch>& notches) const {
        if (mirrored_[s].seam != s || !mirrored_[s].turned) {
            return notches;
        }
        const double half = 0.5 - kOnePlace / places_.lengthOf(s);
        std::vector<Notch> both;
        for (const Notch& notch : notches) {
            if (notch.share < half) {
                both.push_back(notch);
                both.push_back(image(notch));
            } else if (notch.share <= 1 - half) {
                both.push_back(notch);
            }
        }
        return both;
    }

    void mirror(int s) {
        const int other = mirrored_[s].seam;
        if (other == s) {
            notches_[s] = symmetrised(s, notches_[s]);
        } else if (other >= 0) {
            notches_[other].clear();
            for (const Notch& notch : notches_[s]) {
                notches_[other].push_back(image(notch));
            }
        }
    }

    void apply(const NotchSettings& stated) {
        for (SeamSpot spot : spotsOf(stated, garment_, outlines_)) {
            if (!isNotched(spot.seam)) {
                continue;
            }
            const int leader = leaderOf(spot.seam);
            const bool isSecondHalf = mirrored_[spot.seam].seam == spot.seam && spot.share > 0.5;
            if (mirrored_[spot.seam].turned && (leader != spot.seam || isSecondHalf)) {
                spot.share = 1 - spot.share;
            }
            spot.seam = leader;
            if (!stated.isThere) {
                takeAway(spot);
                continue;
            }
            add(spot, stated.count.value_or(places_.countOf(leader)));
            return;
        }
    }

    double apart(const SeamSpot& spot, const Notch& notch) const {
        return std::abs(notch.share - spot.share) * places_.lengthOf(spot.seam);
    }

    void takeAway(const SeamSpot& spot) {
        std::vector<Notch>& notches = notches_[spot.seam];
        const auto nearest = std::ranges::min_element(
            notches, {}, [&](const Notch& notch) { return apart(spot, notch); });
        if (nearest != notches.end() && apart(spot, *nearest) < kNotchGap) {
            notches.erase(nearest);
        }
    }

    void add(const SeamSpot& spot, int marks) {
        std::erase_if(notches_[spot.seam], [&](const Notch& notch) {
            const bool isStated = notch.reason == NotchReason::ByHand;
            return apart(spot, notch) < (isStated ? kOnePlace : kNotchGap);
        });
        notches_[spot.seam].push_back({.seam = spot.seam,
                                       .share = spot.share,
                                       .count = marks,
                                       .reason = NotchReason::ByHand});
    }

    void place(int s) {
        std::ranges::sort(notches_[s], {}, &Notch::share);
        for (Notch& notch : notches_[s]) {
            notch.at = placeAtShare(seams_[s], notch.share);
            const DrawnLoop &left = loops_.of(seams_[s].left), &right = loops_.of(seams_[s].right);
            notch.flat = {left.flat.wrap(left.flatAt(notch.at.left)),
                          right.flat.wrap(right.flatAt(notch.at.right))};
        }
    }

    static bool isAtEnd(const Notch& notch) {
        return notch.reason == NotchReason::SeamEnd || notch.reason == NotchReason::SleeveHead;
    }

    /// Marks the common end of two seams on an outline once, and hides notches near others.
    void showOnce() {
        for (const bool atEnd : {false, true}) {
            for (std::vector<Notch>& ofSeam : notches_) {
                for (Notch& notch : ofSeam) {
                    if (isAtEnd(notch) == atEnd) {
                        const Seam& seam = seams_[notch.seam];
                        notch.onLeft = notch.onLeft && show(seam.left, notch.at.left, atEnd);
                        notch.onRight = notch.onRight && show(seam.right, notch.at.right, atEnd);
                    }
                }
                std::erase_if(ofSeam, [](const Notch& one) { return !one.onLeft && !one.onRight; });
            }
        }
    }

    /// @return whether it is shown: always, unless it gives way and another is near
    bool show(const SeamSide& side, double arc, bool givesWay) {
        const int outline = outlines_.indexOf(side);
        const double perimeter = outlines_.list[outline].length();
        std::vector<double>& shown = shown_[outline];
        const auto isNear = [&](double other) {
            return std::abs(std::remainder(other - arc, perimeter)) < kNotchGap;
        };
        if (givesWay && std::ranges::any_of(shown, isNear)) {
            return false;
        }
        shown.push_back(arc);
        return true;
    }

    const Garment& garment_;
    const std::vector<Seam>& seams_;
    seam::Outlines outlines_;
    DrawnLoops loops_;
    NotchPlaces places_;
    std::vector<MirroredSeam> mirrored_;
    std::vector<std::vector<Notch>> notches_;   ///< per seam
    std::map<int, std::vector<double>> shown_;  ///< per outline: arc lengths, mm
};

}  // namespace

std::vector<std::vector<Notch>> findNotches(const Garment& garment, const PieceResults& results,
                                            const std::vector<OutlineSegments>& segments,
                                            const NotchRules& rules, const Symmetry* symmetry) {
    return NotchFinder(garment, results, segments, symmetry).found(rules);
}

std::optional<NotchSettings> notchSettingsAt(const Garment& garment, int seam, double share) {
    const Seam& of = garment.seams.seams[seam];
    const seam::Outlines outlines = seam::buildOutlines(garment.pieces);
    const SeamMatch at = placeAtShare(of, share);
    for (const bool isRight : {false, true}) {
        const SeamSide& side = seamSide(of, isRight);
        const seam::Outline& outline = outlines.list[outlines.indexOf(side)];
        const auto [edge, t] = outline.line.arc().edgePlace(isRight ? at.right : at.left);
        const EdgeOrigin* origin =
            originAt(garment.pieces[side.piece]->origins, outline.vertices[edge]);
        if (origin) {
            return NotchSettings{origin->line, (1 - t) * origin->from + t * origin->to,
                                 origin->from > origin->to};
        }
    }
    return std::nullopt;
}

}  // namespace toile
