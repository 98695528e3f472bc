// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/garment/piece.h"
#include "core/garment/records.h"
#include "core/garment/seam.h"
#include "core/io/conventions.h"
#include "core/io/soup.h"
#include "core/prepare/orientation.h"
#include "core/prepare/prepare_file.h"

namespace toile {

/// The contents of a mesh file when it was read: later divisions, cuts and exports use this, not
/// the current file on disk. Equal for the same reading.
struct ReadFile {
    std::filesystem::path path;
    std::shared_ptr<const PolygonSoup> soup{};
    double seconds = 0;  ///< reading time

    bool operator==(const ReadFile& other) const { return soup == other.soup; }
};

/// One mesh file of a garment, with its interpretation.
struct SourceFile {
    std::filesystem::path path;
    FileUnit unit = LengthUnit::Millimetre;
    Wording unitReason;  ///< why this unit, if it was not stated; else empty
    bool unitInDoubt = false;
    UpAxis up = UpAxis::Y;  ///< the file's axis that points up; pieces have y up
    Wording upReason;       ///< why this axis, if it was not stated; else empty
    bool upInDoubt = false;
    ClothSide side;  ///< which way the faces look, as detected or after turning
    /// After reading, welding and preparing; never null.
    std::shared_ptr<const PolygonSoup> soup = std::make_shared<const PolygonSoup>();
    FileReading reading;  ///< how it was read; the result is `soup`
    SplitChoice split;    ///< how the file was divided, and why
    /// A division with more pieces that lie flat, if Toile chose and some pieces cannot.
    std::optional<DivisionCount> betterSplit{};
    Problems problems;       ///< of the file as a whole; pieces have their own
    double readSeconds = 0;  ///< reading and dividing
};

/// A garment: files, the pieces found in them in order of their first face, and how these are cut
/// and sewn. Everything follows from the files and the settings; nothing is changed later.
struct Garment {
    std::vector<std::shared_ptr<const SourceFile>> files;
    Pieces pieces;   ///< as cut
    Pieces uncut{};  ///< as divided, before any join or cut; those
                     ///< that none touches are the same pointers
    std::vector<AppliedJoin> joins{};
    std::vector<AppliedCut> cuts{};
    std::vector<CutRecord> cutRecords{};       ///< see `CutPieces::records`
    SeamGraph seams{};                         ///< of `pieces`
    std::vector<SeamSettings> seamSettings{};  ///< settings applied to these
    Problems problems{};                       ///< of the garment as a whole: failed cuts and joins
};

}  // namespace toile
