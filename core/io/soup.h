// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/io/conventions.h"

namespace toile {

/// The position of a span in the file's text.
struct TextSpan {
    std::uint64_t offset = 0;
    std::uint32_t length = 0;
};

/// The unit that a file or its format states, with the reason for display.
struct StatedUnit {
    LengthUnit unit;
    Wording reason;  ///< "glTF files are in metres"
};

/// The same for the up axis.
struct StatedUp {
    UpAxis axis;
    Wording reason;
};

/// The contents of a mesh file before division and checks: polygons over shared positions, with
/// names. All indices count from 0 and are in range; dropped records are listed in `problems` with
/// their line numbers. Face i has the corners faceStart[i] .. faceStart[i+1]-1.
struct PolygonSoup {
    std::vector<Eigen::Vector3d> positions;  ///< in the file's unit; may be non-finite
    std::vector<Eigen::Vector2d> uvs;

    std::vector<int> faceStart{0};  ///< #faces + 1
    std::vector<int> corners;       ///< position index per corner; at least 3 per face
    std::vector<int> cornerUvs;     ///< uv index per corner or -1; empty if the file has no uvs

    /// Per face: index into the lists of names below, or -1. If the file has no names of a kind,
    /// its list and its per-face vector are empty. A name used twice is one entry.
    std::vector<int> faceObject, faceGroup, faceMaterial;
    std::vector<std::string> objects, groups, materials;

    /// The file's own text of each position (everything after the keyword, for example "1.50 2.25
    /// 0.1"), so that an export can repeat the file's digits. Empty for binary files and for
    /// formats without such lines; an entry of length 0 means: print the numbers.
    std::vector<TextSpan> positionText;
    std::shared_ptr<const std::string> text;  ///< the file, if positionText is used

    /// Of the file's bytes (base/content_hash.h); empty if it was read from memory.
    std::optional<std::uint64_t> contentHash{};

    std::optional<StatedUnit> statedUnit;  ///< of the positions; OBJ, OFF, PLY and STL have none
    std::optional<StatedUp> statedUp;      ///< likewise; FBX if the file names y or z

    Problems problems;

    int faceCount() const { return static_cast<int>(faceStart.size()) - 1; }

    int cornerCount(int face) const { return faceStart[face + 1] - faceStart[face]; }
};

/// Endings of the mesh files that this build can read, lower case with the dot.
std::vector<std::string> readableEndings();

/// Reads OBJ, OFF, PLY (ASCII, binary) or STL (ASCII, binary) by the file's ending; for STL, whose
/// triangles repeat their corners, equal positions are merged. Positions are read as doubles.
/// glTF, FBX, Collada and 3MF by `readWithAssimp`, USD text by `readUsd`, .zip by `readZipped`.
/// Errors: FileUnreadable, UnknownFormat, MalformedFile, NoGeometry, Cancelled.
/// Cost: linear, one pass. Re-entrant.
Result<PolygonSoup> readSoup(const std::filesystem::path& path, Progress& progress);

/// The readers behind `readSoup`, on a file already in memory. `name` is used in messages only.
/// Precondition: less than 2 GiB, so that every count fits an int (`readFile`).
Result<PolygonSoup> readObj(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress);
Result<PolygonSoup> readOff(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress);
Result<PolygonSoup> readPly(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress);
Result<PolygonSoup> readStl(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress);

}  // namespace toile
