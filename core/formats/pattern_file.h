// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/base/wording.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A sewing pattern read from a file of another program or of Toile. Everything is in mm, y up,
/// whatever the file's own unit.

struct FileNotch {
    Eigen::Vector2d point{0, 0};
    std::optional<double> angle{};  ///< radians, anti-clockwise from the x axis, into the piece
    std::optional<double> depth{};  ///< mm
};

struct FileDrill {
    Eigen::Vector2d point{0, 0};
    std::optional<double> diameter{};  ///< mm
};

struct FileLine {
    Points2 points = Points2(0, 2);
    bool closed = false;
};

/// From the first point to the second, mm.
using FileChord = std::array<Eigen::Vector2d, 2>;

struct FilePiece {
    std::string id{};  ///< of the block, panel or group in the file
    std::string name{};
    std::string size{};  ///< empty if the file has none
    std::string material{}, category{}, annotation{};
    int quantity = 1;          ///< number cut as drawn
    int mirroredQuantity = 0;  ///< number cut mirrored
    /// Closed lines, anti-clockwise, first point not repeated; no points if missing.
    Points2 cut = Points2(0, 2), sew = Points2(0, 2);
    std::vector<Points2> holes{};
    std::vector<FileLine> internals{};
    std::vector<FileNotch> notches{};
    std::vector<FileDrill> drills{};
    std::optional<FileChord> grain{}, fold{};
    std::map<std::string, int> layers{};  ///< entities on each layer
    /// The file has only half of it; here it is complete.
    bool isUnfolded = false;
};

/// The cutting line of a piece, or its seam line if the file has no cutting line.
inline const Points2& outlineOf(const FilePiece& piece) {
    return piece.cut.rows() > 0 ? piece.cut : piece.sew;
}

struct PatternFile {
    Wording format{};  ///< "DXF of AccuMark, AAMA"
    FileUnit unit = LengthUnit::Millimetre;
    Wording unitReason{};  ///< source of the unit
    bool unitInDoubt = false;
    std::string style{};
    std::string sampleSize{};
    std::vector<std::string> sizes{};  ///< in the order of the file
    std::vector<FilePiece> pieces{};
    std::vector<Wording> notes{};  ///< on omitted or corrected parts
};

/// The pieces of one size: the sample size if the file has several and names it, else the first.
/// Indices into `pieces`.
std::vector<int> sampleOf(const PatternFile& file);

/// Describes a pattern file as JSON: format, unit and its source, sizes, and each piece with its
/// lengths (mm), area (mm2) and counts. Never NaN: null. Cost: linear. Pure.
std::string writePatternFile(const PatternFile& file);

/// Keeps the first ten notes with the same wording, and counts the others in one note. Pure.
void shortenNotes(std::vector<Wording>& notes);

}  // namespace toile
