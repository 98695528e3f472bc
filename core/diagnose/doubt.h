// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile {

/// Why a pattern is most likely none that anybody could sew, though all of it came out flat.
enum class DoubtKind {
    StrainBeyondCloth,  ///< of one piece
    ManyScraps,         ///< of the garment: debris, not pieces
    LongCuts,           ///< of a piece as divided: cut to ribbons
};

/// No cloth takes this strain, and fewer than so much of a piece's area are single triangles.
inline constexpr double kStrainBeyondCloth = 0.25, kStrainBeyondClothShare = 0.02;
/// More scraps than this, each smaller than so much worn cloth, mm2, are debris.
inline constexpr int kManyScraps = 20;
inline constexpr double kScrapArea = 100;
/// Cuts that Toile found itself and that are longer than all rims of a piece together.
inline constexpr double kLongCuts = 1;

/// How a kind of doubt is told; `advice` is a sentence without a full stop.
struct DoubtWords {
    const char* name;  ///< kebab-case, as in files
    const char* title;
    const char* advice;
};

inline constexpr DoubtWords kDoubtWords[] = {
    {"strain-beyond-cloth", translatable("Strain beyond any cloth"),
     translatable("Cut the piece where it curves most; if the file is a thick shell or a scan, "
                  "make one sheet of it first")},
    {"many-scraps", translatable("Scraps instead of pieces"),
     translatable(
         "State the unit if the garment is too small; else leave the scraps out, or divide "
         "the file by something else; if it is a scan, make one sheet of it first")},
    {"long-cuts", translatable("Cuts longer than the outline"),
     translatable("Divide the garment by its own seams, or draw the cuts where seams are to be; "
                  "if the file is a thick shell or a scan, make one sheet of it first")},
};

/// Something that is to be looked at before anybody trusts the pattern.
struct Doubt {
    DoubtKind kind;
    Subject subject{};  ///< the piece by its name; None of the whole garment
    int piece = -1;     ///< index into the garment's pieces, or -1
    int face = -1;      ///< of the piece: the worst strained triangle, or -1
    double badness = 0;
    Wording what{};  ///< what is the matter, in millimetres
};

const DoubtWords& doubtWords(DoubtKind kind);
/// "front: strain beyond 25 % on 40.0 % of the area ...; cut the piece ...".
std::string sentence(const Doubt& doubt);

/// Looks at what came out, as no method does. Pieces that are left out do not count, nor does what
/// a person has cut; a closed piece has no rim that a cut could be compared with.
/// @param results  one per piece of the garment; null or of another shape: not looked at for strain
/// Cost: linear in the triangles. Pure, thread-safe.
std::vector<Doubt> findDoubts(const Garment& garment, const PieceResults& results);

}  // namespace toile
