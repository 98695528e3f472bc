// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/garment/garment.h"

namespace toile {

/// Reasons to doubt a pattern although all pieces became flat.
enum class DoubtKind {
    UpAxisInDoubt,      ///< of a file: the axis was guessed, and another one is equally likely
    InsideOut,          ///< of a file: its faces point inwards, so pieces are mirrored
    StrainBeyondCloth,  ///< of one piece
    ManyScraps,         ///< of the garment: debris instead of pieces
    LongCuts,           ///< of a whole piece: it is cut to ribbons
};

/// No cloth takes this strain. A smaller share of a piece's area than this is single triangles.
inline constexpr double kStrainBeyondCloth = 0.25, kStrainBeyondClothShare = 0.02;
/// The pattern is useless if the mean strain is above this, or if kStrainBeyondCloth is exceeded on
/// this share of the area, unless the chosen fabric stretches more. Both weighted by area.
inline constexpr double kMeanStrainFault = 0.06, kStrainFaultArea = 0.05;
/// Moving a crossing outline apart may raise the largest edge strain by this much; more is
/// compression, which needs a cut.
inline constexpr double kApartStrain = 0.1;
/// More scraps than this, each smaller than this area of worn cloth in mm2, are debris.
inline constexpr int kManyScraps = 20;
inline constexpr double kScrapArea = 100;
/// Longest cuts found by Toile itself, relative to all rims of a piece together.
inline constexpr double kLongCuts = 1;

/// Texts for a kind of doubt.
struct DoubtWords {
    const char* name;  ///< kebab-case, as in files
    const char* title;
    const char* describe;  ///< %0: `Doubt::what`
    const char* advice;    ///< a sentence without a full stop
    const char* option;    ///< command line option to use, or empty
};

inline constexpr DoubtWords kDoubtWords[] = {
    {"up-axis-in-doubt", translatable("Up axis in doubt"),
     translatable("the file does not say which axis points up (%0)"),
     translatable("State the axis, or keep it if the garment stands upright"), "--up y or --up z"},
    {"inside-out", translatable("Inside out"),
     translatable("faces of the garment look inwards (%0): their pieces come out mirrored, wrong "
                  "side up"),
     translatable("Turn the garment; if only parts of it look inwards, make the normals consistent "
                  "in the modelling program"),
     "--turn-over"},
    {"strain-beyond-cloth", translatable("Strain beyond any cloth"), "%0",
     translatable("Cut the piece open or put darts where it curves most; if the file is a thick "
                  "shell or a scan, make one sheet of it first"),
     "--auto-cut --enough 5"},
    {"many-scraps", translatable("Scraps instead of pieces"), "%0",
     translatable(
         "State the unit if the garment is too small; else leave the scraps out, or divide "
         "the file by something else; if it is a scan, make one sheet of it first"),
     ""},
    {"long-cuts", translatable("Cuts longer than the outline"), "%0",
     translatable("Divide the garment by its own seams, or draw the cuts where seams are to be; "
                  "if the file is a thick shell or a scan, make one sheet of it first"),
     ""},
};

/// Something to check before you trust the pattern.
struct Doubt {
    DoubtKind kind;
    Subject subject{};  ///< the piece or the file by its name; None for the whole garment
    int piece = -1;     ///< index into the garment's pieces, or -1
    int face = -1;      ///< of the piece: the worst strained triangle, or -1
    double badness = 0;
    Wording what{};        ///< details, in millimetres
    bool isFault = false;  ///< cutting cloth by this pattern would waste it
};

const DoubtWords& doubtWords(DoubtKind kind);
/// "front: strain is beyond 25 % on 40.0 % of the area ...; cut the piece ... (--auto-cut)."
std::string sentence(const Doubt& doubt);

/// Checks the files and the results. Ignores pieces that are left out, and cuts by the user. A
/// closed piece has no rim to compare cuts with.
/// @param results  one per piece of the garment; null or of another shape: strain is not checked
/// @param fabrics  one per piece, as chosen; empty if no fabric is chosen
/// Cost: n log n in the triangles. Pure, thread-safe.
std::vector<Doubt> findDoubts(const Garment& garment, const PieceResults& results,
                              const std::vector<Fabric>& fabrics = {});

/// Whether cloth would be wasted: a piece that is not flat, crosses itself or has flipped
/// triangles, a cut or a join that could not be made, or a doubt that is a fault. The rule for exit
/// status 1 (docs/report.md). @param doubts  of the same garment and results
bool hasFaults(const Garment& garment, const PieceResults& results,
               const std::vector<Doubt>& doubts);

}  // namespace toile
