// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"
#include "core/base/id.h"
#include "core/base/wording.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"

namespace toile {

/// What a garment keeps of how it was made: division, joins and cuts. `core/assemble` fills these.

/// How a file is divided into pieces. In every mode a piece is connected: a class with several
/// components gives several pieces.
enum class SplitMode {
    Auto,        ///< by the file's contents; `SplitChoice::reason` explains it
    Components,  ///< connected by shared vertices
    Objects,     ///< OBJ `o`
    Groups,      ///< OBJ `g`
    Materials,   ///< OBJ `usemtl`
    Uv,          ///< islands of the UV map, by shared `vt` index, never by position
    Seams,       ///< only along the user's cuts: like components, ignoring names
};

/// A mode other than Auto, and why it was chosen if the user stated none.
struct SplitChoice {
    SplitMode mode = SplitMode::Components;
    Wording reason;  ///< for display; empty if the mode was stated
};

/// "auto", "components", ...: the words of the command line.
std::string_view name(SplitMode mode);
std::optional<SplitMode> parseSplitMode(std::string_view text);

/// Number of pieces of a division, and how many of them can lie flat without cuts.
struct DivisionCount {
    SplitMode mode = SplitMode::Components;
    int pieces = 0;
    int flat = 0;

    bool operator==(const DivisionCount&) const = default;
};

/// A removed seam.
struct AppliedJoin {
    std::string name;   ///< the user's name
    std::string piece;  ///< the result: "front + back", or the one piece on both sides
    double length = 0;  ///< mm, of the closed line
};

enum class CutAuthor { User, Automatic };

/// A cut made in a piece.
struct AppliedCut {
    std::string name;  ///< the user's name; "front, automatic cut 1"
    CutAuthor author = CutAuthor::User;
    UserCut::Kind kind = UserCut::Kind::Path;
    std::string piece;  ///< the piece that it opened, by the name before the cut
    double length = 0;  ///< mm, of the opened line
    CutId id{};
    Wording evidence{};                     ///< of a cut proposed by Toile: its reasons
    std::vector<Eigen::Vector3d> points{};  ///< its line in the piece that it opened, mm
};

/// The record of cutting one piece.
struct CutRecord {
    std::shared_ptr<const Piece> whole;
    std::vector<UserCut> requested;
    bool automatic = false;
    int proposer = 0;         ///< its `way`; 0: no proposals were requested
    bool namesPiece = false;  ///< proposed cuts are called by their piece, too
    Pieces pieces{};
    std::vector<AppliedCut> cuts{};
    Problems problems{};
};

}  // namespace toile
