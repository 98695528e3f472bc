// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"

namespace toile {

/// How much a finding matters to somebody with scissors in the hand.
enum class Severity {
    Fault,  ///< to be put right before the cloth is cut
    Doubt,  ///< to be looked at: right or wrong, the person knows
    Note,   ///< good to know
};

/// What was found. In the order in which a person would put it right: what hides the rest comes
/// first.
enum class FindingKind {
    NotFlattened,       ///< the pattern is not made, or older than the last change
    NotFlat,            ///< a piece could not be flattened
    OutlineCrosses,     ///< a flat outline crosses itself
    FlippedTriangles,   ///< cloth is flipped in the pattern
    ProofFault,         ///< what is to be sewn together is no such pattern (core/prove/proof.h)
    InsideOut,          ///< the faces of a file look inwards (core/diagnose/doubt.h)
    StrainBeyondCloth,  ///< no fabric takes the strain,
    ManyScraps,         ///< there are more scraps than pieces,
    LongCuts,           ///< cuts found by Toile are longer than the outline
    SeamLengths,        ///< two flat sides of a seam do not fit, the ease taken out
    StrainWarp,         ///< strain beyond the fabric's limits along the grain,
    StrainWeft,         ///< across it,
    StrainBias,         ///< at 45 degrees to it
    SewnGap,            ///< sewn back together, it sits far from the design
    SeamKink,           ///< lines that run on into each other over a seam make a corner there
    NotSymmetric,       ///< a piece is to be cut by half, and is not drawn as a mirror image
    NoFacing,           ///< a facing has no room along its edge
    WiderThanCloth,     ///< a piece fits its cloth in no turn that is allowed
    PiecesOverlap,      ///< two pieces lie on each other on the sheet
    UnlikelySize,       ///< no garment is as small or as large
    UnitInDoubt,        ///< the file's unit was guessed, and another is as likely
    UpAxisInDoubt,      ///< likewise the axis that points up
    GrainMissing,       ///< the grain is unset
    ReferenceNote,      ///< what reading the reference pattern left out or put right
    Message,            ///< what reading, cutting or flattening had to say: `Finding::error`
};

/// One past the last kind; kinds are contiguous from 0.
inline constexpr int kFindingKindCount = static_cast<int>(FindingKind::Message) + 1;

/// A number of a finding, and how it is to be written.
struct Figure {
    enum class Unit {
        Length,   ///< mm
        Percent,  ///< a fraction: 0.02 is 2 %
        Strain,   ///< a fraction with a sign
        Angle,    ///< radians
        Count,
    };

    double value = 0;
    Unit unit = Unit::Count;

    bool operator==(const Figure&) const = default;
};

inline Figure count(double value) {
    return {value, Figure::Unit::Count};
}

/// A place on the cloth.
struct FindingPlace {
    Eigen::Vector2d flat = Eigen::Vector2d::Zero();      ///< mm, the flat piece's own coordinates
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< mm, on the garment
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< towards the right side, unit; or zero
};

/// One thing to know before the cloth is cut.
struct Finding {
    FindingKind kind = FindingKind::Message;
    Severity severity = Severity::Note;
    Subject subject{};  ///< the piece, the seam or the file; None with both names where two pieces
    /// Indices into the garment's pieces: one, two that lie on each other, or none.
    std::vector<int> pieces{};
    int seam = -1;                        ///< index into the garment's seams, or -1
    std::optional<FindingPlace> place{};  ///< on the first piece: of the worst
    /// What was measured, the telling number first; `findingWords` say where each goes.
    std::vector<Figure> figures{};
    Wording reason{};  ///< why something was guessed or is in doubt; the fabric's name; or empty
    std::optional<Error> error{};  ///< that says it all: of NotFlat, OutlineCrosses and Message
};

/// Stable kebab-case name, for example "seam-lengths".
std::string_view name(FindingKind kind);
/// "fault", "doubt", "note".
std::string_view name(Severity severity);

/// How a kind of finding is told. %1, %2 ... stand for the figures in their order, %0 for the
/// reason. The window translates these words and writes the numbers in the person's units.
struct FindingWords {
    const char* name;      ///< kebab-case, as in the report
    const char* title;     ///< of several findings of the kind: "Seams that do not match"
    const char* describe;  ///< what is the matter; empty where the finding's error says it
    const char* advice;    ///< what to try; likewise
};

const FindingWords& findingWords(FindingKind kind);

/// What is the matter, with places for the figures as in `describe`: a tube is called so and not by
/// what its error names. Empty where the error says it.
const char* patternOf(const Finding& finding);

/// What was found, without the place and without what to try: "the flat sides of the seam differ
/// by 3.20 mm ...". English, millimetres.
std::string description(const Finding& finding);
/// What to try, as a sentence without a full stop; empty where nothing is needed.
std::string adviceFor(const Finding& finding);
/// One sentence for a person, like those of errors: where, what, what to try.
std::string sentence(const Finding& finding);

}  // namespace toile
