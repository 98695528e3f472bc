// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"
#include "core/garment/piece.h"

namespace toile {

/// How severe a finding is for somebody who is about to cut.
enum class Severity {
    Fault,  ///< fix it before the cloth is cut
    Doubt,  ///< check it: only the user knows whether it is right
    Note,   ///< good to know
};

/// Kinds of findings, in the order in which to fix them: a finding that hides others comes first.
enum class FindingKind {
    NotFlattened,       ///< there is no pattern, or it is older than the last change
    NotFlat,            ///< a piece could not be flattened
    OutlineCrosses,     ///< a flat outline crosses itself
    FlippedTriangles,   ///< cloth is flipped in the pattern
    ProofFault,         ///< sewn, the cloth did not come to rest
    Mirrored,           ///< the pattern's file has the piece mirrored
    OtherFits,          ///< the file's piece for this one fits another piece better
    SeamSlips,          ///< the two sides of a seam do not fit each other
    LengthDiffers,      ///< a side of a seam has another length than on the design
    NotThere,           ///< the pattern lacks this piece
    NotNeeded,          ///< the file has a piece that is not the garment's
    FarOff,             ///< the cloth came to rest nowhere near the design
    InsideOut,          ///< the faces of a file point inwards, so that its pieces are mirrored
    StrainBeyondCloth,  ///< no fabric can take the strain
    ManyScraps,         ///< there are more scraps than pieces
    LongCuts,           ///< cuts found by Toile are longer than the outline
    SeamLengths,        ///< two flat sides of a seam differ by more than the ease
    StrainWarp,         ///< strain beyond the fabric's limits along the grain
    StrainWeft,         ///< likewise across the grain
    StrainBias,         ///< likewise at 45 degrees to the grain
    SewnGap,            ///< sewn back together, the pattern sits far from the design
    SeamKink,           ///< lines that should continue over a seam make a corner there
    NotSymmetric,       ///< a piece to cut by half is not drawn as a mirror image
    NoFacing,           ///< a facing has no room along its edge
    WiderThanCloth,     ///< a piece does not fit its cloth at any allowed turn
    PiecesOverlap,      ///< two pieces overlap on the sheet
    UnlikelySize,       ///< smaller or larger than any garment
    UnitInDoubt,        ///< the file's unit was guessed, and another is as likely
    UpAxisInDoubt,      ///< likewise the up axis
    GrainMissing,       ///< the grain is unset
    ReferenceNote,      ///< what reading the reference pattern left out or put right
    Message,            ///< what reading, cutting or flattening had to say: `Finding::error`
};

/// One past the last kind; kinds are contiguous from 0.
inline constexpr int kFindingKindCount = static_cast<int>(FindingKind::Message) + 1;

/// A number of a finding, with the unit to write it in.
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

/// One thing to know before the cloth is cut: found in files and flat pieces (`findDoubts`), by
/// sewing (`Proof::faults`) or by the list of checks (`readyToCut`).
struct Finding {
    FindingKind kind = FindingKind::Message;
    Severity severity = Severity::Note;
    Subject subject{};  ///< the piece, seam or file; None with both names for two pieces
    /// Indices into the garment's pieces: one, two that overlap, or none.
    std::vector<int> pieces{};
    int seam = -1;                        ///< index into the garment's seams, or -1
    std::optional<FindingPlace> place{};  ///< the worst place, on the first piece
    /// The measured numbers, the most important first; `findingWords` places them in the text.
    std::vector<Figure> figures{};
    Wording reason{};    ///< why something is guessed or in doubt; or the fabric's name; or empty
    double badness = 0;  ///< orders findings of one severity and kind, the worst first
    std::optional<Error> error{};  ///< full text of NotFlat, OutlineCrosses and Message
};

/// The place of a triangle's middle. @param Q  flat coordinates of the piece's vertices, mm
FindingPlace placeInTriangle(const Piece& piece, const Points2& Q, Eigen::Index face);

/// Stable kebab-case name, for example "seam-lengths".
std::string_view name(FindingKind kind);
/// "fault", "doubt", "note".
std::string_view name(Severity severity);

/// The wording of a kind of finding. %1, %2 ... are the figures in order, %0 is the reason. The
/// window translates these words and writes the numbers in the user's units.
struct FindingWords {
    const char* name;         ///< kebab-case, as in the report
    const char* title;        ///< for several findings of the kind: "Seams that do not match"
    const char* describe;     ///< the problem; empty if the finding's error describes it
    const char* advice;       ///< how to solve it; likewise
    const char* option = "";  ///< the command line's answer, or empty
};

const FindingWords& findingWords(FindingKind kind);

/// The problem, with places for the figures as in `describe`; empty if the error describes it. A
/// tube has its own wording instead of that of its error.
const char* patternOf(const Finding& finding);

/// The finding without its place and without advice: "the flat sides of the seam differ by 3.20 mm
/// ...". English, millimetres.
std::string description(const Finding& finding);
/// The advice, as a sentence without a full stop; empty if nothing is needed.
std::string adviceFor(const Finding& finding);
/// The text for the user, like that of errors: place, problem, advice.
std::string sentence(const Finding& finding);

}  // namespace toile
