// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/id.h"
#include "core/garment/garment.h"
#include "core/geometry/placement.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A vertex of a piece, and where it lay in the flat coordinates that placement and grain are
/// about, mm.
struct Anchor {
    int vertex = 0;
    Eigen::Vector2d flat = Eigen::Vector2d::Zero();
    /// In a project: where the vertex is on the garment, mm, should its number be another.
    std::optional<Eigen::Vector3d> point{};

    bool operator==(const Anchor&) const = default;
};

inline constexpr int kMaxCopies = 1000000;  ///< of a piece that can be asked for

/// What a person has said about one piece, beyond its shape; of a quantity, at most kMaxCopies.
struct PieceSettings : Cutting {
    /// Where the flat piece lies; none until it has been laid out.
    std::optional<Placement> placement{};
    /// A person has put it there: it moves for no other piece.
    bool placedByHand = false;
    /// A person has said what it is cut from, be it the garment's own fabric: no layer changes
    /// that.
    bool materialByHand = false;
    /// Which flat points placement and grain are about (PieceResult::fingerprint); 0: not known.
    std::uint64_t flat = 0;
    /// Where these lay, as long as the next are not there: they are fitted to the anchors, which
    /// then go (`anchoredSettings`).
    std::vector<Anchor> anchors{};
    /// The piece that this one and others were cut from, as long as none of them has been laid out:
    /// all have its placement. None where no piece was divided.
    PieceId partOf{};
    bool hidden = false;   ///< on the screen alone: in files and figures it is as all others
    bool leftOut = false;  ///< not part of the pattern: neither flat nor in files and figures

    bool operator==(const PieceSettings&) const = default;
};

/// By piece; also of pieces that are not there at the time, since a cut that is taken back brings
/// them back.
using SettingsById = std::map<PieceId, PieceSettings>;

/// How a person tells a piece from the others.
struct PieceLabel {
    std::string name{};  ///< shown in place of the piece's own; empty: that one
    int colour = -1;     ///< number of its colour on screen; negative: none yet

    bool operator==(const PieceLabel&) const = default;
};

/// By id; also of pieces that are not there at the time, since a cut that is taken back brings them
/// back.
using PieceLabels = std::map<PieceId, PieceLabel>;

/// Colours of a number beyond these are the same hues again, in other shades.
inline constexpr int kHueCount = 12;

/// Gives every piece a colour that no other has: its own; else that of the piece that it was, where
/// that is not there any more; else another shade of that hue, or one that none ever had. What was
/// cut from a piece that a person named is called by that name.
/// @param before  null: the garment is new  Cost: that of `predecessors`. Pure.
PieceLabels withColours(PieceLabels labels, const Garment* before, const Garment& after);

/// One number per piece: that of its place where it has none.
std::vector<int> coloursOf(const PieceLabels& labels, const Garment& garment);

/// What a piece is called.
const std::string& nameOf(const PieceLabels& labels, const Piece& piece);
/// The subject by the name that a person gave it, where it is a piece with one.
Subject labelled(const PieceLabels& labels, Subject subject);

}  // namespace toile
