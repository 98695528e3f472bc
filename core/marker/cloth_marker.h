// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/wording.h"
#include "core/garment/fabric.h"
#include "core/layout/marker.h"
#include "core/marker/marker_settings.h"
#include "core/nest/nest.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A copy of a pattern piece on the cloth.
struct LaidCopy {
    CopyKey key{};
    int piece = 0;         ///< index into Pattern::pieces
    bool isImage = false;  ///< the mirrored one of a pair
    bool isKept = false;   ///< placed by the user
    int sheet = 0;         ///< sheet or hide: index into ClothMarker::parts
    Placement placement{};
    int yield = 1;  ///< pieces of the garment cut from it: usually two on folded cloth
};

/// A stretch of roll, a sheet or a hide in cloth coordinates; parts follow each other along x.
struct ClothPart {
    geometry::Polygon outline;
    std::vector<HideZone> zones{};
};

/// The pieces of one material laid on their cloth, without overlaps and within the cloth's edges.
struct ClothMarker {
    std::string material;  ///< empty: the garment's own fabric
    double width = 0;      ///< mm, on the table: folded cloth is half as wide
    double length = 0;     ///< mm, along the warp; for sheets and hides up to the last copy
    bool isRoll = true;    ///< false: sheets or hides
    bool areHides = false;
    int sheets = 1;          ///< number of sheets or hides used
    double clothArea = 0;    ///< mm2, of a roll up to `length`, of sheets and hides all those used
    double use = 0;          ///< area of the pieces / clothArea
    int rounds = 0;          ///< search rounds so far
    bool isOptimal = false;  ///< no shorter marker exists: stop searching
    bool isWhole = true;     ///< nothing was left out
    std::vector<LaidCopy> copies;
    std::vector<ClothPart> parts{};  ///< cloth used, up to `length`
    std::vector<Wording> notes{};    ///< pieces too large, seams with unmatched
                                     ///< stripes
};

/// The pattern as laid on cloth. On flat cloth all pieces are whole. On folded cloth symmetric
/// pieces are placed with their middle on the fold, and only one of a mirrored pair is laid.
/// @param whole  `LaidOutPattern::wholePattern`, with its materials  Cost: that of `asCut`. Pure.
Pattern patternOnCloth(Pattern whole, const MarkerSettings& settings);

/// Materials that pieces are cut from, the garment's own first, then by name.
std::vector<std::string> markerMaterials(const Pattern& pattern);

/// The cutting line of a copy on the cloth: closed, with the piece's winding, or the opposite
/// winding if the copy is mirrored.
Points2 laidOutline(const Pattern& pattern, const LaidCopy& copy);

/// Lays the pieces of one material, with an improvement in each round (`Nester`). After round k the
/// marker depends only on pattern, settings and kept copies.
class MarkerNester {
public:
    /// @param pattern  from `patternOnCloth`  @param fabric  of this material
    /// @param kept  placed copies; those of other pieces, or beyond the number to cut, are ignored
    /// @param threads  0: as many as the machine has; the marker does not depend on it
    /// @param seconds  after which the first marker is laid in haste; none: never
    /// Kept copies stay even if they overlap others, or are too close to them or to an edge; other
    /// copies move away. Pieces that are too large or find no room are left out, with a note.
    /// Errors: PageTooSmall naming the cloth if its width and border leave no room; MalformedFile
    /// naming the cloth if more copies are requested than the limit; Cancelled.
    static Result<MarkerNester> make(std::shared_ptr<const Pattern> pattern,
                                     const std::string& material, const Fabric& fabric,
                                     const MarkerSettings& settings,
                                     const std::vector<KeptCopy>& kept, const Progress& progress,
                                     int threads = 0, std::optional<double> seconds = {});
    ~MarkerNester();
    MarkerNester(MarkerNester&&) noexcept;
    MarkerNester& operator=(MarkerNester&&) noexcept;

    /// The best marker so far; valid from the start.
    const ClothMarker& best() const;
    /// Runs one round of search. A cancelled round has no effect.
    void step(const Progress& progress);

private:
    struct State;
    explicit MarkerNester(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Recomputes the figures of a marker after copies were moved: parts, length, cloth and use. A roll
/// ends one border behind the last copy. Cost: linear.
void measureMoved(const Pattern& pattern, const MarkerSettings& settings, ClothMarker& marker);

/// Indices of the copies that overlap another, exceed the cloth, or are in a hole or in a zone of
/// too low a grade, by exact arithmetic. Gap and border are ignored; a roll has no end. Cost: that
/// of the edges in the common parts of boxes. Pure.
std::vector<int> misplacedCopies(const Pattern& pattern, const ClothMarker& marker,
                                 const MarkerSettings& settings);

/// "Garment's fabric: 1400 mm wide, 2310 mm long, 82.4 % used".
Wording clothSentence(const ClothMarker& marker);

/// For the exports: the copies of a marker as a single page, the warp along x, with the full length
/// of the sheets or hides used.
Marker pageOf(const ClothMarker& marker);

/// Figures of a marker for the cutter.
struct MarkerFigures {
    double seamMetres = 0;  ///< total seam length, both sides counted once
    int notches = 0;        ///< notches to cut; two layers count once
    double cutMetres = 0;   ///< length of all cutting lines; two layers count once
    int copies = 0;         ///< pieces of the garment cut from it
};
MarkerFigures markerFigures(const Pattern& pattern, const ClothMarker& marker);

}  // namespace toile

// For the sources of this folder and the marker in the window.
namespace toile::cloth {

/// Sheets or hides one after the other along x; empty for a roll. One sheet for each copy, but no
/// more than fit the range of a nest's coordinates.
std::vector<ClothPart> clothParts(const MarkerSettings& settings, std::size_t copies);

/// Width of all of them, or of the roll; half of it for folded cloth.
double widthOnCloth(const MarkerSettings& settings, const Fabric& fabric);

/// Adds the ends of the parts to the nest, and the zones that items must avoid.
/// @param grades  worst allowed grade of each item of the instance, 0: any
void addParts(const std::vector<ClothPart>& parts, const std::vector<int>& grades,
              NestInstance& instance);

/// Sets the parts used and the use of a marker with placed copies. Its length is at least the
/// stored one, and reaches the last copy.
void measureOn(const std::vector<ClothPart>& parts, const Pattern& pattern, ClothMarker& marker);

/// Index of the part that a line is on, by the line's leftmost point.
int partAt(const std::vector<ClothPart>& parts, double x);

/// Area of the part without its holes, mm2.
double areaOf(const ClothPart& part);

}  // namespace toile::cloth
