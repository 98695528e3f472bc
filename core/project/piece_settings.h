// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/id.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/geometry/placement.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A vertex of a piece, and its position in the flat coordinates that placement and grain refer to,
/// mm.
struct Anchor {
    int vertex = 0;
    Eigen::Vector2d flat = Eigen::Vector2d::Zero();
    /// In a project: the vertex's position on the garment, mm, in case its number changes.
    std::optional<Eigen::Vector3d> point{};

    bool operator==(const Anchor&) const = default;
};

inline constexpr int kMaxCopies = 1000000;  ///< largest number of copies of a piece

/// Settings of one piece, beyond its shape; quantities are at most kMaxCopies.
struct PieceSettings : Cutting {
    /// Where the flat piece lies; empty until it is laid out.
    std::optional<Placement> placement{};
    /// Placed by the user: it does not make room for other pieces.
    bool placedByHand = false;
    /// The user chose the material, possibly the garment's own fabric: layers do not change it.
    bool materialByHand = false;
    /// Flat points of placement and grain (PieceResult::fingerprint); 0: unknown.
    std::uint64_t flat = 0;
    /// Positions in these points until new ones exist. Then the settings are fitted to the anchors,
    /// which are cleared (`anchoredSettings`).
    std::vector<Anchor> anchors{};
    /// The piece that this one and others were cut from, until one of them is laid out: all have
    /// its placement. Empty if no piece was divided.
    PieceId partOf{};
    bool hidden = false;   ///< on the screen only: files and figures include it
    bool leftOut = false;  ///< not part of the pattern: neither flattened nor in files and figures

    bool operator==(const PieceSettings&) const = default;
};

/// By piece; includes pieces that do not exist at present, because undoing a cut restores them.
using SettingsById = std::map<PieceId, PieceSettings>;

/// How the user tells a piece from the others.
struct PieceLabel {
    std::string name{};  ///< shown instead of the piece's own; empty: its own
    int colour = -1;     ///< number of its colour on screen; negative: none yet

    bool operator==(const PieceLabel&) const = default;
};

/// By id; includes pieces that do not exist at present, because undoing a cut restores them.
using PieceLabels = std::map<PieceId, PieceLabel>;

/// Higher colour numbers repeat the hues in other shades.
inline constexpr int kHueCount = 12;

/// Gives every piece a colour of its own: its present one; else that of its predecessor if that no
/// longer exists; else another shade of that hue, or a new colour. Parts of a piece with a
/// user-given name are named after it.
/// @param before  null: the garment is new  Cost: that of `predecessors`. Pure.
PieceLabels withColours(PieceLabels labels, const Garment* before, const Garment& after);

/// One number per piece; a piece without a colour gets its index.
std::vector<int> coloursOf(const PieceLabels& labels, const Garment& garment);

/// The displayed name of a piece.
const std::string& nameOf(const PieceLabels& labels, const Piece& piece);
/// The subject with the user's name if it is a piece that has one.
Subject labelled(const PieceLabels& labels, Subject subject);

/// The results with excluded pieces marked as not flat (`isLeftOut`), so that they are in no
/// pattern, file or figure. A piece that is included again is null if it has no other result.
/// @param results   one per piece of the garment, null if there is none
/// @param settings  one per piece, or empty  Cost: negligible. Pure.
PieceResults withoutLeftOut(PieceResults results, const Garment& garment,
                            const std::vector<PieceSettings>& settings);

/// The area of a piece in 3D, mm2, by which small parts such as buttons are recognised.
double wornArea(const Piece& piece);

/// What a piece takes over from the previous version of the garment.
struct CarriedFrom {
    int piece = -1;                 ///< index into the pieces before; -1: the piece is new
    bool same = false;              ///< the very same piece, with the same flat coordinates
    std::vector<Anchor> anchors{};  ///< empty if `same`
    std::uint64_t flat = 0;         ///< flat points of the anchors, as in PieceSettings
    PieceId partOf{};               ///< as in PieceSettings
};

/// At most so many anchors are stored for a piece that is to be flattened again.
inline constexpr int kMaxAnchors = 128;

/// The predecessor of each piece (`predecessors`); both parts of a cut piece have the whole one.
/// @param settings, results  one per piece of `before`; results may be null or empty
/// @return one per piece of `after`  Cost: linear in the meshes, and that of `predecessors`. Pure.
std::vector<CarriedFrom> carriedFrom(const Garment& before,
                                     const std::vector<PieceSettings>& settings,
                                     const PieceResults& results, const Garment& after);

/// Transfers settings to the pieces after an edit; new pieces get defaults. Placements are fitted
/// once the pieces are flat (`anchoredSettings`).
/// @param settings  one per piece before  Cost: negligible. Pure.
std::vector<PieceSettings> carriedSettings(const std::vector<CarriedFrom>& from,
                                           const std::vector<PieceSettings>& settings);

/// The same for settings stored by id: a known piece keeps its settings.
/// @param before  one per piece before
void carrySettings(SettingsById& settings, const std::vector<PieceSettings>& before,
                   const std::vector<CarriedFrom>& from, const Garment& after);

}  // namespace toile
