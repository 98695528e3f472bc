// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/base/match_versions.h"
#include "core/flatten/base/outline_targets.h"
#include "core/flatten/isometric/isometric_descent.h"

namespace toile {

struct FlatteningMemory;
struct Piece;

}  // namespace toile

namespace toile::isometric {

struct KktModel;

/// A start of the isometric descent of a piece.
struct IsometricStart {
    Points2 Q;
    Eigen::VectorXd multipliers{};  ///< of the boundary lengths; empty if unknown
    bool isHopeless = false;        ///< the coarse descent was hopeless
};

/// A start near the minimum for a strongly strained piece: the descent of a piece with a tenth of
/// its inner vertices (coarsening.h), which itself starts from one with a tenth, and so on, then
/// prolonged to the full piece. Most of the descent happens on small pieces. The boundary keeps all
/// its vertices and its exact lengths.
/// @param mesh, table, outline  a disk without degenerate triangles
/// @param Q  exact lengths, no flipped triangle
/// @param fine  options of the descent that follows: its tolerance, target distortion and
/// `keepOutlineSimple` apply to the coarse descents too
/// @return no flipped triangle, exact lengths, energy at most that of Q; Q itself if it is only
/// slightly strained, the piece is small, or prolongation fails. After a cancel unspecified, but
/// with these properties.
/// Cost: about a fifth of a factorisation of size 2 #V.
IsometricStart coarseToFine(const MeshArrays& mesh, const EdgeTable& table,
                            const EdgeLoops& outline, const Points2& Q, const DescentOptions& fine,
                            const Progress& progress);

/// The descent from such a start: `lowerIsometricEnergy`, with its errors.
/// @param options  without multipliers
Result<DescentResult> lowerFromCoarse(const MeshArrays& mesh, const EdgeTable& table,
                                      const EdgeLoops& outline, const Points2& Q,
                                      DescentOptions options, const Progress& progress);

/// Parts the two sides of a cut if they overlap in the plane. Boundary vertices at the same point
/// in space are mates; each moves into its own cloth by half of the length missing to a small gap.
/// Lengths change, by little if the overlap is narrow relative to its length. Vertices that three
/// or more sides share stay.
/// @param Q  #V x 2, mm  @param gap  per boundary vertex, between it and its mate
/// Cost: n log n of the boundary.
void partCutSides(const Piece& piece, const Eigen::VectorXd& gap, Points2& Q);

/// The result of the isometric descent of an earlier version, carried over to a later one.
class WarmStart {
public:
    /// @param memory  with positions (`Q`). Must outlive this object, as must the piece
    /// @param targets  of the present version's outline, independent of earlier ones
    /// @param energy  of the piece, the same as the earlier version's
    WarmStart(const Piece& piece, const FlatteningMemory& memory, OutlineTargets targets = {},
              EnergyModel energy = {});

    /// A start from the flat positions. They are carried over vertex by vertex, the outline is
    /// moved to the new lengths, the interior follows harmonically, which avoids the folds of
    /// moving the outline alone, and single vertices are relaxed. If the last outline was moved
    /// apart, the positions before that are tried first, then those after.
    /// @return positions without flipped triangles and with exact boundary lengths; nothing if this
    /// fails, if they are strained much more than before the edit, or if cancelled
    /// Cost: a factorisation of the interior if the outline moves, some linear passes.
    std::optional<Points2> positions(const Progress& progress) const;

    /// A start whose outline does not cross itself: sides of cuts are parted where they overlap
    /// (`partCutSides`). If it also crosses elsewhere, the same from the positions after the last
    /// outline was moved apart.
    /// @param crossing  the present version's, exact lengths, no flipped triangle
    /// @return as `positions`
    std::optional<Points2> simplePositions(const Points2& crossing, const Progress& progress) const;

    /// A start for an edit that moves the outline too far for `positions`, such as a dart that
    /// opens a strained piece. A coarse piece is flattened from scratch, and the vertices that it
    /// lacks follow from their carried positions.
    /// @param tolerance  of the fine descent (DescentOptions)
    /// @return as `positions`, with the multipliers; nothing if most vertices have moved in space,
    /// the piece is small, its coarse piece cannot be flattened, or cancelled
    /// Cost: half a factorisation of size 2 #V.
    std::optional<IsometricStart> fromCoarse(double tolerance, const Progress& progress) const;

    /// Multipliers of the boundary lengths; 0 for lengths that the earlier version did not have.
    Eigen::VectorXd multipliers() const;
    /// The earlier version's model if the triangles are the same, or null.
    std::shared_ptr<const KktModel> model() const;

private:
    bool isSmallEdit() const;
    std::optional<Points2> startFrom(const Points2& before, bool apart,
                                     const Progress& progress) const;
    std::optional<Points2> fitted(const Points2& warm, bool apart, const Progress& progress) const;

    const Piece& piece_;
    const FlatteningMemory& memory_;
    OutlineTargets targets_;
    EnergyModel energy_;
    VersionMatch match_;
};

}  // namespace toile::isometric
