// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/target_lengths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/seam/outline.h"
#include "core/seam/seam_measure.h"
#include "core/seam/seam_settings.h"

namespace toile {
namespace {

/// Ease that would shrink its part to less than this factor is drawn along the whole seam.
constexpr double kMinFactor = 0.5;

/// Length changes of parts of every outline; later ones replace earlier ones.
class Stretches {
public:
    explicit Stretches(const seam::Outlines& outlines)
        : outlines_(outlines), of_(outlines.list.size()) {}

    /// Sets the cause of the length changes that are added next.
    void begin(LengthCause cause) { cause_ = cause; }

    void add(int outline, geometry::Interval part, double factor) {
        const double length = outlines_.list[outline].length();
        const double turns = std::floor(part.low / length) * length;
        part = {part.low - turns, part.high - turns};
        const auto change = static_cast<int>(of_[outline].size());
        of_[outline].push_back({cause_, part.low, part.high, factor, change});
        if (part.high > length) {
            of_[outline].push_back({cause_, 0, part.high - length, factor, change});
        }
    }

    /// Length of a stretch of an outline with the changes so far.
    double lengthOf(int outline, double from, double to) const {
        return outlines_.list[outline].length() > 0 ? upTo(outline, to) - upTo(outline, from) : 0;
    }

    double lengthOf(const SeamSide& side) const {
        const auto [low, high] = std::minmax(side.start, side.end);
        return lengthOf(outlines_.indexOf(side), low, high);
    }

    bool isTouched(int outline) const { return !of_[outline].empty(); }

    /// The parts of an outline whose lengths change, each with its last change.
    std::vector<ChangedPart> changed(int outline) const {
        std::vector<ChangedPart> parts = partsUpTo(outline, outlines_.list[outline].length());
        std::erase_if(parts, [](const ChangedPart& part) { return part.factor == 1; });
        return parts;
    }

private:
    /// From the outline's first vertex to a place, over any number of turns.
    double upTo(int outline, double at) const {
        const double length = outlines_.list[outline].length();
        const double turns = std::floor(at / length);
        const double within = at - turns * length;
        return turns * measured(outline, length) + measured(outline, within);
    }

    double measured(int outline, double at) const {
        double sum = 0;
        for (const ChangedPart& part : partsUpTo(outline, at)) {
            sum += part.factor * (part.to - part.from);
        }
        return sum;
    }

    /// From the first vertex to a place within the first turn: consecutive parts, each with its
    /// last change.
    std::vector<ChangedPart> partsUpTo(int outline, double at) const {
        std::vector<double> cuts{0, at};
        for (const ChangedPart& one : of_[outline]) {
            for (const double end : {one.from, one.to}) {
                if (end > 0 && end < at) {
                    cuts.push_back(end);
                }
            }
        }
        std::ranges::sort(cuts);
        std::vector<ChangedPart> parts;
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const double middle = (cuts[k] + cuts[k + 1]) / 2;
            ChangedPart part;
            for (const ChangedPart& one : of_[outline]) {
                if (one.from <= middle && middle < one.to) {
                    part = one;
                }
            }
            part.from = cuts[k];
            part.to = cuts[k + 1];
            parts.push_back(part);
        }
        return parts;
    }

    const seam::Outlines& outlines_;
    std::vector<std::vector<ChangedPart>> of_;  ///< per outline; later ones replace earlier ones
    LengthCause cause_ = LengthCause::Mirroring;
};

/// Applies common lengths to both sides of mirrored seams, and to mirrored free edges.
void mirrorLengths(const Garment& garment, const CommonLengths& common,
                   const seam::Outlines& outlines, Stretches& stretches) {
    for (std::size_t s = 0; s < garment.seams.seams.size(); ++s) {
        const Seam& seam = garment.seams.seams[s];
        for (const SeamSide* side : {&seam.left, &seam.right}) {
            const bool isOwnPlace = side == &seam.left || !seam.stacked;
            if (common.factor[s] != 1 && side->piece >= 0 && isOwnPlace) {
                const auto [low, high] = std::minmax(side->start, side->end);
                stretches.begin(LengthCause::Mirroring);
                stretches.add(outlines.indexOf(*side), {low, high}, common.factor[s]);
            }
        }
    }
}

/// Applies set lengths of segments, on both sides of their seams.
class TypedLengths {
public:
    TypedLengths(const Garment& garment, const seam::Outlines& outlines, Stretches& stretches)
        : garment_(garment), outlines_(outlines), stretches_(stretches) {}

    void apply(const SegmentSettings& stated) {
        std::vector<std::pair<int, geometry::Interval>> parts;  // several if a cut divides it
        double length = 0;
        for (std::size_t p = 0; p < garment_.pieces.size(); ++p) {
            for (const geometry::Interval& part :
                 partsOf(stated.place, outlines_.list[p], *garment_.pieces[p])) {
                parts.emplace_back(static_cast<int>(p), part);
                length += part.length();
            }
        }
        stretches_.begin(LengthCause::Length);
        for (const auto& [piece, part] : parts) {
            stretch(piece, part, *stated.length / length);
        }
    }

private:
    void stretch(int index, const geometry::Interval& part, double factor) {
        stretches_.add(index, part, factor);
        for (const Seam& seam : garment_.seams.seams) {
            if (!seam.matches.empty() && seam.kind != SeamKind::Free) {
                carryOver(seam, false, index, part, factor);
                carryOver(seam, true, index, part, factor);
            }
        }
    }

    /// Applies the part on one side of a seam to the other side too.
    void carryOver(const Seam& seam, bool fromRight, int index, const geometry::Interval& part,
                   double factor) {
        const SeamSide& side = fromRight ? seam.right : seam.left;
        const SeamSide& other = fromRight ? seam.left : seam.right;
        if (side.piece != index || side.loop != 0 || other.loop != 0) {
            return;
        }
        const auto [low, high] = std::minmax(side.start, side.end);
        const double perimeter = outlines_.list[index].length();
        for (const auto& shared : geometry::commonParts({low, high}, part, perimeter)) {
            const double a = placeAcross(seam, shared.low, fromRight);
            const double b = placeAcross(seam, shared.high, fromRight);
            stretches_.add(outlines_.indexOf(other), {std::min(a, b), std::max(a, b)}, factor);
        }
    }

    const Garment& garment_;
    const seam::Outlines& outlines_;
    Stretches& stretches_;
};

/// Excludes rims of holes, which keep their lengths.
bool isDrawn(const Seam& seam) {
    return seam.ease && seam.drawn && seam.left.loop == 0 && seam.right.loop == 0;
}

/// Lengthens the longer side of a seam by its ease.
void drawEase(const Seam& seam, const seam::Outlines& outlines, Stretches& stretches) {
    const bool leftIsLonger = *seam.ease >= 0;
    const SeamSide& longer = leftIsLonger ? seam.left : seam.right;
    const double now = stretches.lengthOf(longer);
    const double other = stretches.lengthOf(leftIsLonger ? seam.right : seam.left);
    const double wanted = leftIsLonger ? (1 + *seam.ease) * other : other / (1 + *seam.ease);
    const auto at = [&longer](double share) -> double {
        return longer.start + share * (longer.end - longer.start);
    };
    const int outline = outlines.indexOf(longer);
    SeamPart drawn = *seam.drawn;
    const auto factorOn = [&](const SeamPart& part) -> double {
        const auto [from, to] = std::minmax({at(part.from), at(part.to)});
        const double length = stretches.lengthOf(outline, from, to);
        return (length + wanted - now) / (to - from);
    };
    if (!(drawn.from < drawn.to) || !(factorOn(drawn) >= kMinFactor)) {
        drawn = {};
    }
    const double factor = factorOn(drawn);
    const auto [from, to] = std::minmax({at(drawn.from), at(drawn.to)});
    if (std::isfinite(factor) && factor > 0) {
        stretches.begin(LengthCause::Ease);
        stretches.add(outline, {from, to}, factor);
    }
}

}  // namespace

bool drawsEase(const Garment& garment) {
    return std::ranges::any_of(garment.seams.seams, isDrawn);
}

std::vector<OutlineTargets> outlineTargets(const Garment& garment, const LineSettings& settings,
                                           const Symmetry* symmetry) {
    std::vector<OutlineTargets> targets(garment.pieces.size());
    const auto isTyped = [](const SegmentSettings& stated) { return stated.length.has_value(); };
    if (!symmetry && std::ranges::none_of(settings.segments, isTyped) && !drawsEase(garment)) {
        return targets;
    }
    const seam::Outlines outlines = seam::buildOutlines(garment.pieces);
    Stretches stretches(outlines);
    if (symmetry) {
        mirrorLengths(garment, symmetry->lengths, outlines, stretches);
    }
    TypedLengths typed(garment, outlines, stretches);
    for (const SegmentSettings& stated : settings.segments) {
        if (stated.length) {
            typed.apply(stated);
        }
    }
    for (const Seam& seam : garment.seams.seams) {
        if (isDrawn(seam)) {
            drawEase(seam, outlines, stretches);
        }
    }
    for (std::size_t p = 0; p < targets.size(); ++p) {
        const seam::Outline& outline = outlines.list[p];
        if (!stretches.isTouched(static_cast<int>(p))) {
            continue;
        }
        targets[p].lengths.resize(outline.size());
        for (int k = 0; k < outline.size(); ++k) {
            targets[p].lengths[k] =
                stretches.lengthOf(static_cast<int>(p), outline.arcOf(k), outline.arcOf(k + 1));
        }
        targets[p].changed = stretches.changed(static_cast<int>(p));
    }
    return targets;
}

}  // namespace toile
