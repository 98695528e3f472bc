// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/assemble/identify.h"
#include "core/assemble/seams_file.h"
#include "core/base/wording.h"
#include "core/garment/garment.h"
#include "core/prepare/preparation.h"

namespace toile {

/// How automatic cuts are found.
enum class CutStyle {
    Auto,      ///< tailors' cuts if a worn garment is recognised; else the shortest
    Tailor,    ///< the same, with gores for forms that are not worn
    Topology,  ///< the shortest that let a piece lie flat
};

inline constexpr Word<CutStyle> kCutStyleWords[] = {
    {CutStyle::Auto, "auto"}, {CutStyle::Tailor, "tailor"}, {CutStyle::Topology, "topology"}};

struct LoadOptions {
    std::optional<FileUnit> unit{};  ///< of all files; empty: guessed per file
    std::optional<UpAxis> up{};      ///< of all files; empty: guessed per file
    SplitMode split = SplitMode::Auto;
    Preparation preparing{};  ///< kind of the files, and how to prepare them
    bool weld = false;        ///< join coincident vertices within each object
    bool closeSlits = false;  ///< join both sides of slits inside pieces (`closeSlits`)
    bool strict = false;      ///< reject a file if anything had to be left out or repaired
    bool autoCut = false;     ///< cut pieces that are not disks
    CutStyle cutStyle = CutStyle::Topology;  ///< of automatic cuts
    bool isFrontSwapped = false;  ///< if tailors' cuts guess the front, use it as the back
    /// Strain (part of 1) below which no further cut is worth its length: tailors' cuts stop there,
    /// and darts are added if they do not suffice. Empty: their usual seams.
    std::optional<double> enoughStrain{};
    /// Cuts and joins, in the unit and axes of the first file; and ease by names of seams, which
    /// `resolveNames` turns into settings.
    SeamsFile seams{};
    std::vector<SeamSettings> seamSettings{};
    /// Pieces that an earlier division gave: they keep their ids.
    std::vector<KnownPiece> known{};

    bool operator==(const LoadOptions&) const = default;
};

using ReadFiles = std::vector<ReadFile>;

/// Everything that a garment depends on.
struct GarmentInputs {
    ReadFiles files{};
    LoadOptions loading{};

    bool operator==(const GarmentInputs&) const = default;
};

}  // namespace toile
