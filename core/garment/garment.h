// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/garment/better_division.h"
#include "core/garment/cut_pieces.h"
#include "core/garment/join_pieces.h"
#include "core/garment/piece.h"
#include "core/garment/seam.h"
#include "core/garment/split.h"
#include "core/io/conventions.h"
#include "core/io/soup.h"
#include "core/prepare/orientation.h"
#include "core/prepare/prepare_file.h"

namespace toile {

/// What a mesh file held when it was read: whatever is divided, cut or exported later is made of
/// this, not of what is on the disk by then. Equal where it is the same reading.
struct ReadFile {
    std::filesystem::path path;
    std::shared_ptr<const PolygonSoup> soup{};
    double seconds = 0;  ///< that reading took

    bool operator==(const ReadFile& other) const { return soup == other.soup; }
};

/// One mesh file of a garment, and how it was taken.
struct SourceFile {
    std::filesystem::path path;
    FileUnit unit = LengthUnit::Millimetre;
    Wording unitReason;  ///< why this unit, where it was not stated; else empty
    bool unitInDoubt = false;
    UpAxis up = UpAxis::Y;  ///< the file's axis that points up; pieces have y up
    Wording upReason;       ///< why this axis, where it was not stated; else empty
    bool upInDoubt = false;
    ClothSide side;  ///< which way the faces look, as seen or as turned
    /// As read, welded and prepared; never null.
    std::shared_ptr<const PolygonSoup> soup = std::make_shared<const PolygonSoup>();
    FileReading reading;  ///< as what it was read; `soup` is what came of that
    SplitChoice split;    ///< by what the file was divided, and why
    /// By which more pieces could lie flat, where Toile chose and some cannot.
    std::optional<DivisionCount> betterSplit{};
    Problems problems;       ///< of the file as a whole; a piece's own are with the piece
    double readSeconds = 0;  ///< reading and dividing
};

/// A garment: files, the pieces found in them, in order of their first face, and how these are cut
/// and sewn. All of it follows from the files and the orders given; nothing is changed later.
struct Garment {
    std::vector<std::shared_ptr<const SourceFile>> files;
    Pieces pieces;   ///< as cut
    Pieces uncut{};  ///< as divided, before any join or cut; those
                     ///< that none touches are the same pointers
    std::vector<AppliedJoin> joins{};
    std::vector<AppliedCut> cuts{};
    std::vector<CutRecord> cutRecords{};       ///< what became of the pieces that were to be cut
    SeamGraph seams{};                         ///< of `pieces`
    std::vector<SeamSettings> seamSettings{};  ///< that these follow
    Problems problems{};  ///< of the garment as a whole: cuts and joins that could not be
};

}  // namespace toile
