// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/id.h"

namespace toile {

/// The role of a stretch of outline in sewing.
enum class SeamKind {
    Seam,  ///< two stretches sewn together, of two pieces or of one
    Dart,  ///< two stretches of one piece that meet at a point inside the cloth
    Fold,  ///< two stretches of one piece that meet at a point of a plain edge: a pleat
    Free,  ///< not sewn: a hem, an opening, or a seam that was not recognised
};

/// A directed stretch of a piece's outline, or of the rim of a hole in it. Positions on the outline
/// are arc lengths in mm along the loop (`loopOf`), in its direction, 0 at its first vertex; they
/// continue past the last vertex if the stretch passes it, so that |end - start| is always the 3D
/// length.
struct SeamSide {
    int piece = -1;         ///< index of the piece; -1: no such side
    int first = 0;          ///< first edge touched; edge k runs from vertex k of the loop to k + 1
    int count = 0;          ///< edges touched, wholly or in part; continues past the last edge
    bool reversed = false;  ///< runs against the outline: start > end
    double start = 0;
    double end = 0;
    int loop = 0;  ///< 0: Piece::boundary; k: Piece::holes[k - 1]

    double length() const { return reversed ? start - end : end - start; }
};

/// Two corresponding positions, as arc lengths on either side.
struct SeamMatch {
    double left = 0;
    double right = 0;
};

/// A stretch of a rim of the division, or of a side of a cut, as shares of its length
/// (`EdgeOrigin`): this identifies a side after cuts, joins and renumbering. A rim is closed, so
/// positions a whole turn apart are equal.
struct LineStretch {
    LineId line;  ///< none: unknown
    double from = 0, to = 0;

    bool operator==(const LineStretch&) const = default;
};

/// A seam, or a part of one, as the two sewn stretches; the second has no line if the edge is free.
struct SeamPlace {
    LineStretch left, right;

    bool operator==(const SeamPlace&) const = default;
};

/// A part of a seam, as shares of its length from its start.
struct SeamPart {
    double from = 0, to = 1;

    bool operator==(const SeamPart&) const = default;
};

/// The user's settings of a seam, or of the part of one that existed then.
struct SeamSettings {
    SeamPlace place;
    /// As Seam::ease, of the left side of `place`; empty: from the 3D lengths.
    std::optional<double> ease{};
    std::string name{};               ///< replaces the generated name; empty: keep that
    std::optional<SeamPart> drawn{};  ///< as Seam::drawn

    bool operator==(const SeamSettings&) const = default;
};

/// Which edge is sewn to which. The left side runs along its outline; the right side starts at the
/// start of the left one, so between two pieces of the same winding it runs against its own.
struct Seam {
    SeamKind kind = SeamKind::Seam;
    std::string name;  ///< "front / sleeve_left", "back, dart 2", "front, free edge 1"
    SeamSide left;
    SeamSide right;  ///< piece -1 if the edge is free
    /// From start to end, monotone on both sides, at least one for every vertex of either side;
    /// between two of them the sides correspond linearly. Empty if the edge is free.
    std::vector<SeamMatch> matches;
    double length3d[2] = {0, 0};  ///< mm, left and right; right is 0 if the edge is free
    double gap = 0;               ///< mean distance between the sides in 3D, mm
    /// How much longer the left side is meant to be than the right, as a part of the right (0.1 =
    /// 10 %), if the user has set it; else the 3D lengths decide.
    std::optional<double> ease;
    /// The part where the longer side is drawn longer in the pattern to include the set ease;
    /// empty: the ease is only documented.
    std::optional<SeamPart> drawn{};
    /// The right side lies on a stretch that another seam already uses: a third layer.
    bool stacked = false;
    bool closed = false;        ///< the seam is a closed line: it ends at its start
    SeamId id{};                ///< unique in the graph
    SeamPlace place{};          ///< identifies it in another version of the garment
    std::vector<CutId> cuts{};  ///< those whose left or right side is its own left side, if any
};

/// All seams and free edges of a garment: seams first, ordered by pieces.
struct SeamGraph {
    std::vector<Seam> seams;
    /// Per piece and edge of its outline: the seams that touch it, ascending. Two or more if a seam
    /// ends inside the edge or layers are stacked; none if a remainder was too short to matter.
    std::vector<std::vector<std::vector<int>>> seamsOfEdge;
    /// Per piece: the seams that touch the rim of one of its holes, ascending. A rim that is not
    /// sewn is not a free edge and has none.
    std::vector<std::vector<int>> seamsOfHoles;
    Problems notes{};  ///< EdgesCrowd: places where seams were not searched
};

}  // namespace toile
