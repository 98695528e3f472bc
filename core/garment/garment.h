// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/length_unit.h"
#include "core/garment/piece.h"
#include "core/garment/split.h"
#include "core/io/soup.h"

namespace toile {

/// One mesh file of a garment, kept as read so that exports can repeat it.
struct SourceFile {
    std::filesystem::path path;
    LengthUnit unit = LengthUnit::Millimetre;
    std::string unitReason;  ///< why this unit, where it was not stated; else empty
    PolygonSoup soup;
    SplitChoice split;  ///< by what the file was divided, and why
    Problems problems;  ///< of the file as a whole; a piece's own are with the piece
    double readSeconds = 0;
};

/// A garment: files and the pieces found in them, in order of their first face.
struct Garment {
    std::vector<std::shared_ptr<const SourceFile>> files;
    std::vector<std::shared_ptr<const Piece>> pieces;
};

}  // namespace toile
