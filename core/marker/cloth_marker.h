// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/wording.h"
#include "core/garment/fabric.h"
#include "core/layout/marker.h"
#include "core/marker/marker_settings.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A copy of a pattern piece on the cloth.
struct LaidCopy {
    CopyKey key{};
    int piece = 0;         ///< index into Pattern::pieces
    bool isImage = false;  ///< the mirrored one of a pair
    bool isKept = false;   ///< by a person
    int sheet = 0;         ///< or hide: index into ClothMarker::parts
    Placement placement{};
    int yield = 1;  ///< pieces of the garment that come of it: of folded cloth two as a rule
};

/// A stretch of roll, a sheet or a hide, as it lies: those of a marker one after the other along x.
struct ClothPart {
    geometry::Polygon outline;
    std::vector<HideZone> zones{};
};

/// The pieces of one material laid on their cloth: none overlaps another or the cloth's edge.
struct ClothMarker {
    std::string material;  ///< empty: the garment's own fabric
    double width = 0;      ///< mm, as it lies: folded cloth is half as wide
    double length = 0;     ///< mm, along the warp; of sheets and hides up to the last copy
    bool isRoll = true;    ///< else sheets or hides
    bool areHides = false;
    int sheets = 1;        ///< how many of them are used
    double clothArea = 0;  ///< mm2, of a roll up to `length`, of sheets and hides all that are used
    double use = 0;        ///< area of the pieces / area of that cloth
    int rounds = 0;        ///< of search
    bool isOptimal = false;  ///< no shorter one can be: no use to go on
    bool isWhole = true;     ///< nothing was left out
    std::vector<LaidCopy> copies;
    std::vector<ClothPart> parts{};  ///< of the cloth that are used, up to `length`
    std::vector<Wording> notes{};    ///< what is not as it was asked for: pieces too large, seams
                                     ///< whose stripes do not meet
};

/// The pattern as it lies on cloth: on flat cloth all is laid whole, on folded cloth what is its
/// own image lies with its middle on the fold, and of two that mirror each other one is laid.
/// @param whole  `LaidOutPattern::wholePattern`, with its materials  Cost: that of `asCut`. Pure.
Pattern patternOnCloth(Pattern whole, const MarkerSettings& settings);

/// Materials of which something is cut, the garment's own first, then by name.
std::vector<std::string> markerMaterials(const Pattern& pattern);

/// The line that a copy takes up on the cloth, as it lies: its cutting line, closed, in the piece's
/// winding or, where it is mirrored, the other.
Points2 laidOutline(const Pattern& pattern, const LaidCopy& copy);

/// Lays what of a pattern is cut from one material, better round by round (`Nester`). After round k
/// the marker depends on pattern, settings and kept copies alone.
class MarkerNester {
public:
    /// @param pattern  as it lies (`patternOnCloth`)  @param fabric  of this material
    /// @param kept  those of other pieces, or of more copies than are cut, are not looked at
    /// @param threads  to work with, 0: as the machine has; the marker does not depend on it
    /// Kept copies that lie on others, or nearer to them or to an edge than they may, stay there
    /// too, and others make room. What is too large or finds no room is left out, with a note.
    /// Errors: PageTooSmall naming the cloth where its width and border leave none; MalformedFile
    /// naming the cloth where more copies are asked for than are laid at once; Cancelled.
    static Result<MarkerNester> make(std::shared_ptr<const Pattern> pattern,
                                     const std::string& material, const Fabric& fabric,
                                     const MarkerSettings& settings,
                                     const std::vector<KeptCopy>& kept, const Progress& progress,
                                     int threads = 0);
    ~MarkerNester();
    MarkerNester(MarkerNester&&) noexcept;
    MarkerNester& operator=(MarkerNester&&) noexcept;

    /// The best so far; valid from the start.
    const ClothMarker& best() const;
    /// A round of search. A cancelled one adds nothing.
    void step(const Progress& progress);

private:
    struct State;
    explicit MarkerNester(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Measures a marker anew whose copies have been moved: parts, length, cloth and use. A roll ends
/// by the border behind the last copy. Cost: linear.
void measureMoved(const Pattern& pattern, const MarkerSettings& settings, ClothMarker& marker);

/// Which laid copies lie on another, beyond the cloth, in a hole of it or in a zone too bad for
/// them: by exact arithmetic, as indices. Gap and border are not looked at; a roll has no end.
/// Cost: that of the edges in the common parts of boxes. Pure.
std::vector<int> misplacedCopies(const Pattern& pattern, const ClothMarker& marker,
                                 const MarkerSettings& settings);

/// "Own fabric: 1400 mm wide, 2310 mm long, 82.4 % used".
Wording clothSentence(const ClothMarker& marker);

/// For the exports: the copies of a marker as one page, the warp along x, with all of the sheets or
/// hides that are used.
Marker pageOf(const ClothMarker& marker);

/// What a cutter asks of a marker.
struct MarkerFigures {
    double seamMetres = 0;  ///< that are sewn, both sides once
    int notches = 0;        ///< that are cut, through two layers once
    double cutMetres = 0;   ///< along all lines that are cut, through two layers once
    int copies = 0;         ///< pieces of the garment that come of it
};
MarkerFigures markerFigures(const Pattern& pattern, const ClothMarker& marker);

}  // namespace toile
