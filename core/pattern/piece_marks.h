// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pattern/grain_line.h"
#include "core/pattern/label.h"
#include "core/pattern/pattern.h"

namespace toile {

/// What a drawing says, in the language of whoever reads it. "%1" stands for how many are cut.
struct DrawingWords {
    std::string noAllowance = "net outline, no allowance";
    std::string mirrored = "mirrored: wrong side of the fabric up";
    std::string cut = "cut %1", cutPair = "cut 1 pair", cutPairs = "cut %1 pairs";
    std::string checkSquare = "check square 100 mm x 100 mm";
};

/// What stands on a piece that is not cut once: "cut 3", or "cut 2 pairs" where each of them is cut
/// mirrored too. Empty for a single piece.
std::string cuttingNote(int quantity, bool mirroredPair, const DrawingWords& words = {});

/// The label of a piece, line by line: its name, how often it is cut, what kind of outline it is
/// and, where it is mirrored, that the wrong side is up. Its outline is not looked at.
std::vector<std::string> labelLines(const PatternPiece& piece, const DrawingWords& words);

/// What is drawn on a piece as it lies, in files and on screen alike.
struct PieceMarks {
    LabelPlace label{};
    std::optional<Chord> grain{};  ///< none where no grain is asked for, or no line has room
};

/// Places the label (`placeLabel`) and a grain line beside it, or through it where there is no room
/// beside it.
/// @param loops  mm, not empty: the outline, then holes; closed, first point not repeated
/// @param grain  direction of the warp, radians, as the loops lie
/// @param page   that the label is to stay on, where a tiny piece is narrower than its own name;
///               empty: endless  Cost: that of `placeLabel` and `grainLine`.
PieceMarks placeMarks(const std::vector<Points2>& loops, const std::vector<std::string>& lines,
                      std::optional<double> grain, const Eigen::AlignedBox2d& page = {});

}  // namespace toile
