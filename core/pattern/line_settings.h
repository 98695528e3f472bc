// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/wording.h"
#include "core/garment/seam.h"
#include "core/pattern/corner_allowance.h"

namespace toile {

/// Content of a drawing's layer; each writer defines its name and colour.
enum class LayerKind { Cut, Sew, Notches, Internal, Marks, Grain, Text, Check };

/// Every kind, in the order in which layers are written. Seam line, notches, internal lines and
/// grain are left out if they are empty.
inline constexpr std::array kLayerKinds{LayerKind::Cut,      LayerKind::Sew,   LayerKind::Notches,
                                        LayerKind::Internal, LayerKind::Marks, LayerKind::Grain,
                                        LayerKind::Text,     LayerKind::Check};

/// The shape of a notch (notch_mark.h).
enum class NotchForm { Slit, V, T, Castle };

/// Their names in project files.
inline constexpr Word<NotchForm> kNotchFormWords[] = {{NotchForm::Slit, "slit"},
                                                      {NotchForm::V, "v"},
                                                      {NotchForm::T, "t"},
                                                      {NotchForm::Castle, "castle"}};

/// Why a notch is where it is.
enum class NotchReason {
    SeamEnd,     ///< the seam ends where an outline runs on without a corner
    SleeveHead,  ///< the same at the top of a sleeve
    EaseStart,   ///< drawn ease starts or ends
    Balance,     ///< divides a seam: its middle, quarters or thirds
    ByHand,
};

inline constexpr Word<NotchReason> kNotchReasonWords[] = {{NotchReason::SeamEnd, "seam end"},
                                                          {NotchReason::SleeveHead, "sleeve head"},
                                                          {NotchReason::EaseStart, "ease"},
                                                          {NotchReason::Balance, "balance"},
                                                          {NotchReason::ByHand, "by hand"}};

/// A notch that the user added or removed: a place on either line of a seam, as a share of it, so
/// that it stays wherever the seam is cut. Dragging a notch removes and adds one.
struct NotchSettings {
    LineId line;
    double at = 0;
    bool reversed = false;       ///< on the side of the line that runs against it
    bool isThere = true;         ///< false: the notch nearest to the place is removed
    std::optional<int> count{};  ///< 1 or 2; empty: by convention (Notch::count)

    bool operator==(const NotchSettings&) const = default;
};

/// Limits of the depth of notches, mm.
inline constexpr double kMinNotchDepth = 1, kMaxNotchDepth = 30;

/// All settings of notches.
struct NotchRules {
    bool automatic = true;  ///< false: only `notches`
    NotchForm form = NotchForm::Slit;
    double depth = 5;  ///< from the cutting line inwards, mm
    std::vector<NotchSettings> notches{};

    bool operator==(const NotchRules&) const = default;
};

/// User settings for additions to the outlines of a pattern. Like `SegmentSettings` they refer to
/// stretches of rims and cuts, or to places on the garment, never to flat coordinates.

/// The leg over which a closed dart is laid.
enum class DartLay { First, Second };

/// Their names in project files.
inline constexpr Word<DartLay> kDartLayWords[] = {{DartLay::First, "first"},
                                                  {DartLay::Second, "second"}};

/// Settings of a dart.
struct DartSettings {
    SeamPlace seam;  ///< its two legs
    /// Distance of the legs at the mouth, mm; empty: as the cloth lies flat.
    std::optional<double> intake{};
    std::optional<DartLay> lay{};  ///< none: by convention (`findDarts`)

    bool operator==(const DartSettings&) const = default;

    bool saysNothing() const { return !intake && !lay; }
};

/// Limits of an intake, mm.
inline constexpr double kMinIntake = 0.1, kMaxIntake = 1000;

/// A strip along the outline of one piece that is copied as a piece of its own: the facing of a
/// neckline, the lining of a waistband.
struct Facing {
    std::string name{};                ///< empty: named after its piece
    std::vector<LineStretch> edges{};  ///< of neighbouring segments, along the outline
    double width = 50;                 ///< mm, from the outline inwards

    bool operator==(const Facing&) const = default;
};

/// Limits of the width of facings and extensions, mm.
inline constexpr double kMinStrip = 1, kMaxStrip = 1000;

/// A line drawn within the cloth: style line, pocket place, quilting; a single point is a drill
/// point.
struct InternalLine {
    std::string name{};
    /// One or more, near the surface, in axes and unit of the garment's first file.
    std::vector<Eigen::Vector3d> points{};
    bool closed = false;  ///< leads back to the first of three or more points

    bool operator==(const InternalLine&) const = default;
};

/// Texts on the labels of all pieces.
struct LabelTexts {
    std::string size{};
    std::string date{};  ///< as it is printed

    bool operator==(const LabelTexts&) const = default;
};

/// How outlines are made fair (fair_outline.h).
struct Fairing {
    double tolerance = 1;   ///< no point strays further from the exact outline, mm
    double smoothing = 40;  ///< lambda, mm: waves shorter than about six times that go
    bool isFixed = false;   ///< the tolerance holds on wrinkled garments too

    bool operator==(const Fairing&) const = default;
};

/// Limits of both values, and of the length of a segment, mm.
inline constexpr double kMinFairTolerance = 0.05, kMaxFairTolerance = 20;
inline constexpr double kMinSmoothing = 2, kMaxSmoothing = 500;
inline constexpr double kMinSegmentLength = 0.01, kMaxSegmentLength = 1e6;

/// What a free edge is on the worn garment; it decides the width of its allowance.
enum class EdgeKind {
    Hem,       ///< of a body, a leg, a skirt or a short sleeve
    Cuff,      ///< end of a long sleeve
    Neckline,  ///< without collar or band
    Armhole,   ///< without sleeve
    Waist,     ///< top of trousers or a skirt
    Front,     ///< upright edge of an open front, or of a placket
    Collar,    ///< free edge of a collar or neck band
    Slit,      ///< upright edge of a slit from a hem, or of an opening within a seam
    Unknown,
};

/// Their names in project files, in reports and on the command line.
inline constexpr Word<EdgeKind> kEdgeKindWords[] = {{EdgeKind::Hem, "hem"},
                                                    {EdgeKind::Cuff, "cuff"},
                                                    {EdgeKind::Neckline, "neckline"},
                                                    {EdgeKind::Armhole, "armhole"},
                                                    {EdgeKind::Waist, "waist"},
                                                    {EdgeKind::Front, "front-edge"},
                                                    {EdgeKind::Collar, "collar-edge"},
                                                    {EdgeKind::Slit, "slit"},
                                                    {EdgeKind::Unknown, "unknown"}};
inline constexpr std::size_t kEdgeKindCount = std::size(kEdgeKindWords);

/// Width of cloth beyond the seam lines, mm; none at folds of the cloth.
struct AllowanceWidths {
    double seam = 10;
    double hem = 30;
    /// Of free edges by EdgeKind, drawn as they are; empty: `widthOf`, narrowed where it does not
    /// fit (`limitAllowances`). That of hems is `hem`.
    std::array<std::optional<double>, kEdgeKindCount> edges{};

    bool operator==(const AllowanceWidths&) const = default;

    const std::optional<double>& of(EdgeKind kind) const {
        return edges[static_cast<std::size_t>(kind)];
    }
    /// The width beside a free edge, set or usual: hems and cuffs (25 mm) are turned up; necklines
    /// and armholes (7 mm), which curve, are bound, faced or turned; slits (15 mm) have a narrow
    /// hem; others are sewn to something. Usual widths are no wider than a hem or a seam. An edge
    /// of unknown kind gets a hem, because cloth can be trimmed but not added.
    double widthOf(EdgeKind kind) const;
};

/// Limit of the width of an allowance, mm.
inline constexpr double kMaxAllowance = 500;

/// How to draw pieces that would be mirror images of each other if the cloth hung alike. Mean and
/// First give all mirrored seams a common length (common_lengths.h).
enum class Mirror {
    None,   ///< every piece keeps its own lines
    Close,  ///< as Mean, but only pieces whose seams differ little (`withinTolerance`)
    Mean,   ///< both become mirror images of their mean
    First,  ///< the piece on the side of the plane's normal is mirrored onto the other
};

/// Their names in project files.
inline constexpr Word<Mirror> kMirrorWords[] = {{Mirror::None, "none"},
                                                {Mirror::Close, "close"},
                                                {Mirror::Mean, "mean"},
                                                {Mirror::First, "first"}};

/// How the direction of the warp is found.
enum class GrainRule {
    /// As the garment hangs: upwards, averaged over the piece. If that cancels out, as on a sleeve
    /// held out sideways, along the tube if the piece is sewn to itself, else in the direction of
    /// greatest change of height.
    Vertical,
    /// Up the reference panel, as the designer laid it; Vertical if the piece has none.
    Reference,
    /// Vertical, or at 90 or 45 degrees to it if that strains the cloth less by a fifth; no odd
    /// angles, which no pattern maker would use.
    LeastStrain,
};

inline constexpr Word<GrainRule> kGrainRuleWords[] = {{GrainRule::Vertical, "vertical"},
                                                      {GrainRule::Reference, "reference"},
                                                      {GrainRule::LeastStrain, "least-strain"}};

/// Settings of a segment, or of the part of a segment that existed when they were made.
struct SegmentSettings {
    LineStretch place;  ///< of the segment, on the side of its own piece
    /// Length in the pattern of all of `place` and of the edge sewn to it, mm; empty: as in 3D.
    std::optional<double> length{};
    std::optional<double> tolerance{};  ///< as Fairing::tolerance; empty: the garment's
    bool straight = false;              ///< drawn as a straight line
    /// Width of the adjacent allowance, on its own piece; empty: by its kind (AllowanceWidths).
    std::optional<double> allowance{};
    std::optional<EdgeKind> edge{};  ///< kind of a free edge; empty: as found (edge_kinds.h)
    /// How allowances meet where it starts; empty: mitred, or mirrored at the end of a hem.
    std::optional<CornerRule> corner{};
    /// Width by which a free edge is extended in parallel, mm: a button stand, a turn-up.
    std::optional<double> extension{};

    bool operator==(const SegmentSettings&) const = default;

    bool saysNothing() const {
        return !length && !tolerance && !straight && !allowance && !edge && !corner && !extension;
    }
};

/// A turn point that the user added or removed: a place on a line, as a share of its length.
struct TurnPointSettings {
    LineId line;
    double at = 0;
    bool reversed = false;  ///< on the side of the line that runs against it
    bool turns = true;      ///< false: a corner of the outline that is not a turn point

    bool operator==(const TurnPointSettings&) const = default;
};

/// Whether the kink at an end of a seam is removed.
struct SeamEndSettings {
    SeamPlace seam;
    bool atEnd = false;  ///< at the end of the seam's left side; false: at its start
    bool trued = true;

    bool operator==(const SeamEndSettings&) const = default;
};

/// All settings of the pattern's lines. The defaults change and add nothing: every outline is the
/// exact one, and is the cutting line.
struct LineSettings {
    std::optional<Fairing> fairing{};
    /// Kinks at ends of seams up to this are removed (trueing.h), radians; 0: only those listed in
    /// `seamEnds`.
    double trueBelow = 0;
    /// All but None also make pieces symmetric that are symmetric in themselves.
    Mirror mirror = Mirror::None;
    std::vector<SegmentSettings> segments{};
    std::vector<TurnPointSettings> turnPoints{};
    std::vector<SeamEndSettings> seamEnds{};
    std::optional<AllowanceWidths> allowance{};  ///< empty: no piece has any
    std::optional<NotchRules> notches{};         ///< empty: there are none
    std::optional<GrainRule> grain{};            ///< for pieces without a set grain; empty: unset
    std::vector<DartSettings> darts{};
    std::vector<Facing> facings{};
    std::vector<InternalLine> internalLines{};
    LabelTexts label{};

    bool operator==(const LineSettings&) const = default;
};

/// Limit up to which trueing is proposed, radians; larger kinks may be intended.
inline constexpr double kProposedTrueing = 0.17453292519943295;

/// A pattern to cut and sew: adds the usual values for everything that is not set.
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
