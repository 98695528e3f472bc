// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/formats/drawing/drawing.h"
#include "core/garment/garment.h"
#include "core/layout/marker.h"

namespace toile::test {

/// A rectangle, anti-clockwise from its lower left corner.
Points2 rectangle(double x, double y, double width, double height);
/// A U of three straight arms: the middle of its box is outside.
Points2 horseshoe(double x, double y, double size, double arm);
/// A curved and slightly turned panel of many short edges of odd lengths.
Points2 curvedPanel(int count, double radius);

/// Pieces of all these kinds, away from the origin, with names in several scripts.
Pattern sewingPattern();
/// `sewingPattern` laid out.
Drawing sewingDrawing();

/// Length of each edge of a closed outline.
Eigen::VectorXd edgeLengths(const Points2& outline);

struct GarmentAndResults {
    Garment garment;
    PieceResults results;
    Marker marker;
};

/// One text file in cm: pieces "front 1" and "back" share two positions; "ring" has failed; one
/// face is in no piece. "front 1" holds a quad and a triangle, with a face of "ring" between.
GarmentAndResults handmadeGarment();
/// Adds a file in inches without text: a position that is no number, and a piece "patch" one of
/// whose vertices is not the file's.
void addBinaryFile(GarmentAndResults& all);

/// Makes every C and C++ number of the program use a decimal comma while it lives.
class CommaLocale {
public:
    CommaLocale();
    ~CommaLocale();
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

private:
    std::string before_;
};

}  // namespace toile::test
