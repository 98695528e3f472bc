// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/base/words.h"
#include "core/garment/seam.h"
#include "core/pattern/added_settings.h"
#include "core/pattern/corner_allowance.h"
#include "core/pattern/notch_settings.h"

namespace toile {

/// How outlines are made fair (fair_outline.h).
struct Fairing {
    double tolerance = 1;   ///< no point strays further from the exact outline, mm
    double smoothing = 40;  ///< lambda, mm: waves shorter than about six times that go
    bool isFixed = false;   ///< the tolerance holds on wrinkled garments too

    bool operator==(const Fairing&) const = default;
};

/// Limits of both, and of the length of a segment, mm.
inline constexpr double kMinFairTolerance = 0.05, kMaxFairTolerance = 20;
inline constexpr double kMinSmoothing = 2, kMaxSmoothing = 500;
inline constexpr double kMinSegmentLength = 0.01, kMaxSegmentLength = 1e6;

/// How much cloth is left beyond the seam lines, mm: round folds of the cloth none.
struct AllowanceWidths {
    double seam = 10;
    double hem = 30;  ///< of free edges

    bool operator==(const AllowanceWidths&) const = default;
};

/// Of the width of an allowance, mm.
inline constexpr double kMaxAllowance = 500;

/// What becomes of pieces that are mirror images of each other, but for how the cloth hangs. Mean
/// and First give all mirrored seams a common length (common_lengths.h).
enum class Mirror {
    None,   ///< every piece is what it is
    Close,  ///< as Mean, but only pieces whose seams differ little (`withinTolerance`)
    Mean,   ///< both become mirror images of their mean
    First,  ///< the one on the side to which the plane's normal points is mirrored onto the other
};

/// What they are called in project files.
inline constexpr Word<Mirror> kMirrorWords[] = {{Mirror::None, "none"},
                                                {Mirror::Close, "close"},
                                                {Mirror::Mean, "mean"},
                                                {Mirror::First, "first"}};

/// By what the direction of the warp is found.
enum class GrainRule {
    /// As the garment hangs: up its height, on the mean over the piece. Where that cancels out, as
    /// on a sleeve held out sideways, along the tube if the piece is sewn to itself, else the way
    /// that height changes most.
    Vertical,
    /// Up the reference panel, as the designer laid it; Vertical where the piece has none.
    Reference,
    /// Vertical, or at 90 or 45 degrees to it where the cloth then suffers less by a fifth; no odd
    /// angles, which no pattern maker would cut at.
    LeastStrain,
};

inline constexpr Word<GrainRule> kGrainRuleWords[] = {{GrainRule::Vertical, "vertical"},
                                                      {GrainRule::Reference, "reference"},
                                                      {GrainRule::LeastStrain, "least-strain"}};

/// What a person has said of a segment, or of the part of one that was there then.
struct SegmentSettings {
    LineStretch place;  ///< of the segment, on its own piece's side
    /// In the pattern, mm, of all of `place` and of what is sewn to it; none: as in 3D.
    std::optional<double> length{};
    std::optional<double> tolerance{};  ///< as Fairing::tolerance; none: the garment's
    bool straight = false;              ///< drawn as one straight line
    /// Width of the allowance beside it, on its own piece; none: by its kind (AllowanceWidths).
    std::optional<double> allowance{};
    /// How allowances meet where it begins; none: mitred, or mirrored at the end of a hem.
    std::optional<CornerRule> corner{};
    /// A free edge is drawn out parallel by so much, mm: a button stand, a turn-up.
    std::optional<double> extension{};

    bool operator==(const SegmentSettings&) const = default;

    bool saysNothing() const {
        return !length && !tolerance && !straight && !allowance && !corner && !extension;
    }
};

/// A turn point that a person has added or taken away: a place on a line, as a share of it.
struct TurnPointSettings {
    LineId line;
    double at = 0;
    bool reversed = false;  ///< of the side of the line that runs against it
    bool turns = true;      ///< false: the outline has a corner there, which is none

    bool operator==(const TurnPointSettings&) const = default;
};

/// Whether the kink at an end of a seam is taken out.
struct SeamEndSettings {
    SeamPlace seam;
    bool atEnd = false;  ///< where the seam's left side ends; false: where it starts
    bool trued = true;

    bool operator==(const SeamEndSettings&) const = default;
};

/// Everything a person has decided about the lines of the pattern. As it is here nothing is
/// changed or added: every outline is the exact one, and cut along.
struct LineSettings {
    std::optional<Fairing> fairing{};
    /// Kinks at ends of seams up to this are taken out (trueing.h), radians; 0: none but those
    /// said below.
    double trueBelow = 0;
    /// Pieces that are symmetric in themselves are made so by all but None.
    Mirror mirror = Mirror::None;
    std::vector<SegmentSettings> segments{};
    std::vector<TurnPointSettings> turnPoints{};
    std::vector<SeamEndSettings> seamEnds{};
    std::optional<AllowanceWidths> allowance{};  ///< none: no piece has any
    std::optional<NotchRules> notches{};         ///< none: there are none
    std::optional<GrainRule> grain{};  ///< of pieces whose grain nobody has stated; none: unset
    std::vector<DartSettings> darts{};
    std::vector<Facing> facings{};
    std::vector<InternalLine> internalLines{};
    LabelTexts label{};

    bool operator==(const LineSettings&) const = default;
};

/// The limit up to which trueing is proposed: larger ones may be meant. Radians.
inline constexpr double kProposedTrueing = 0.17453292519943295;

/// A pattern to cut and sew: what nothing has been said of as it is usual.
inline LineSettings withPattern(LineSettings lines) {
    lines.fairing = lines.fairing.value_or(Fairing{});
    lines.trueBelow = std::max(lines.trueBelow, kProposedTrueing);
    lines.mirror = lines.mirror == Mirror::None ? Mirror::Close : lines.mirror;
    lines.allowance = lines.allowance.value_or(AllowanceWidths{});
    lines.notches = lines.notches.value_or(NotchRules{});
    lines.grain = lines.grain.value_or(GrainRule::Vertical);
    return lines;
}

}  // namespace toile
