// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/drawing/key_points.h"
#include "core/formats/export_source.h"
#include "core/pattern/piece_grain.h"

namespace toile {

/// Layer numbers of ASTM D6673 and ANSI/AAMA-292.
enum ApparelLayer {
    kCutLayer = 1,
    kTurnLayer = 2,
    kCurveLayer = 3,
    kNotchLayer = 4,
    kMirrorLayer = 6,
    kGrainLayer = 7,
    kInternalLayer = 8,
    kHoleLayer = 11,
    kDrillLayer = 13,
    kSewLayer = 14,
    kTextLayer = 15,
    kTNotchLayer = 80,
    kCastleNotchLayer = 81,
};

/// The layer of the validation curve for a primary layer: 84 to 87.
int validationLayer(int layer);

/// A line of a piece: few points for curves, and the exact points.
struct ApparelLine {
    int layer = kCutLayer;
    std::size_t path = 0;  ///< index into ApparelPattern::drawing.paths
    bool closed = false;
    Points2 keys = Points2(0, 2);   ///< mm; a closed line starts at a turn point if it has one
    std::vector<bool> isTurn{};     ///< of each
    Points2 dense = Points2(0, 2);  ///< the line's own points, including the keys
};

/// A notch as a record on the cutting line.
struct ApparelNotch {
    Eigen::Vector2d point{0, 0};
    Eigen::Vector2d inwards{0, 0};  ///< unit
    double depth = 0;               ///< mm
};

struct ApparelPiece {
    std::string name;       ///< [A-Z0-9_-], 1 to 20, unique
    std::size_t block = 0;  ///< index into Drawing::blocks
    std::vector<ApparelLine> lines{};
    std::vector<ApparelNotch> notches{};  ///< two for a double notch
    std::vector<Eigen::Vector2d> drills{};
    Chord grain{{0, 0}, {0, 0}};
    std::optional<Chord> mirror{};  ///< of a piece on the fold
    Eigen::Vector2d middle{0, 0};   ///< inside: where its texts begin
};

/// The drawing for the apparel profiles of DXF.
struct ApparelDrawing {
    struct Line {
        std::size_t path = 0;  ///< index into the drawing's
        int layer = kCutLayer;
    };

    /// The drawing with the legs of capped darts appended, on the layer Internal
    /// ("piece-<slug>--dart-<k>-legs"). Circles and crosses of drill points, which are records
    /// here, are moved from Internal to Marks.
    Drawing drawing;
    std::vector<std::vector<Line>> lines;  ///< of each block, in the order of the file
};

/// Cost: that of `findDarts`, and linear. Pure.
ApparelDrawing apparelDrawing(const ExportSource& source);

/// A name for each block, unique and made by `apparelName`. A name without usable characters
/// becomes the piece's number: PIECE-7. Pure.
std::vector<std::string> apparelNames(const Pattern& pattern, const Drawing& drawing);

/// One piece for each block.  Cost: that of `keyPoints`. Pure.
std::vector<ApparelPiece> apparelPieces(const ExportSource& source, const ApparelDrawing& drawing);

/// Diameter of drill holes, mm.
inline constexpr double kDrillDiameter = 3;

/// A name that every reader accepts: capitals, digits, '-' and '_', at most 20 characters.
/// @param otherwise  used if no letter or digit remains
std::string apparelName(std::string_view name, std::string_view otherwise);

/// The name of the check square as a piece.
inline constexpr const char* kControlName = "CONTROL";

/// The stated maximum distance of a line from its key points, mm: kKeyFar, rounded.
inline constexpr double kKeyTolerance = 0.1;

}  // namespace toile
