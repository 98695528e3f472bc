// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/notches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/pattern/notch_rules.h"
#include "core/pattern/seam_places.h"
#include "core/seam/outline.h"
#include "core/seam/seam_origin.h"

namespace toile {
namespace {

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
std::vector<SeamSpot> spotsOf(const NotchSettings& said, const Garment& garment,
                              const seam::Outlines& outlines) {
    const double sense = said.reversed ? -1 : 1;
    const LineStretch place{said.line, said.at - sense * kHalfPlace, said.at + sense * kHalfPlace};
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
        for (const NotchSettings& said : rules.notches) {
            apply(said);
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

    void apply(const NotchSettings& said) {
        for (SeamSpot spot : spotsOf(said, garment_, outlines_)) {
            if (!isNotched(spot.seam)) {
                continue;
            }
            const int leader = leaderOf(spot.seam);
            const bool isSecondHalf = mirrored_[spot.seam].seam == spot.seam && spot.share > 0.5;
            if (mirrored_[spot.seam].turned && (leader != spot.seam || isSecondHalf)) {
                spot.share = 1 - spot.share;
            }
            spot.seam = leader;
            if (!said.isThere) {
                takeAway(spot);
                continue;
            }
            add(spot, said.count.value_or(places_.countOf(leader)));
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
            const bool isSaid = notch.reason == NotchReason::ByHand;
            return apart(spot, notch) < (isSaid ? kOnePlace : kNotchGap);
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
