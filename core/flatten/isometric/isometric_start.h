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

/// Where the isometric descent of a piece may begin.
struct IsometricStart {
    Points2 Q;
    Eigen::VectorXd multipliers{};  ///< of the boundary lengths; empty where none are known
    bool isHopeless = false;        ///< the coarse descent was
};

/// A start near the end for a piece that is strained much: the descent of a piece with a tenth of
/// its inner vertices (coarsening.h), which itself begins with one of a tenth, and so on, and then
/// the way back. The long way down is gone on small pieces. The boundary keeps all its vertices and
/// its exact lengths.
/// @param mesh, table, outline  a disk without degenerate triangles
/// @param Q  exact lengths, no flipped triangle
/// @param fine  of the descent that follows: its tolerance, whether the outline is kept simple, and
///              what is wanted are those of the coarse descents too
/// @return no flipped triangle, exact lengths, energy at most that of Q; Q itself where it is
///         strained little, the piece small, or no way back is found. Once cancelled unspecified,
///         but of that kind.
/// Cost: a fifth of a factorisation of size 2 #V, about.
IsometricStart coarseToFine(const MeshArrays& mesh, const EdgeTable& table,
                            const EdgeLoops& outline, const Points2& Q, const DescentOptions& fine,
                            const Progress& progress);

/// The descent from such a start: `lowerIsometricEnergy`, with its errors.
/// @param options  without multipliers
Result<DescentResult> lowerFromCoarse(const MeshArrays& mesh, const EdgeTable& table,
                                      const EdgeLoops& outline, const Points2& Q,
                                      DescentOptions options, const Progress& progress);

/// Parts the two sides of a cut where they overlap in the plane. Boundary vertices at one place in
/// space are mates; each goes into its own cloth by half of what is missing of a small gap. Lengths
/// change on the way, by little where the overlap is narrow against its length. Vertices that three
/// or more sides share stay.
/// @param Q  #V x 2, mm  @param gap  per boundary vertex, between it and its mate
/// Cost: n log n of the boundary.
void partCutSides(const Piece& piece, const Eigen::VectorXd& gap, Points2& Q);

/// What the isometric descent of an earlier version left behind, carried over to a later one.
class WarmStart {
public:
    /// @param memory  with positions (`Q`). Outlives this, as does the piece
    /// @param targets  of the present version's outline, whatever those before were
    WarmStart(const Piece& piece, const FlatteningMemory& memory, OutlineTargets targets = {});

    /// A start from the flat positions: they are carried over vertex by vertex, the outline is
    /// moved to the new lengths, the interior follows harmonically, which restores what moving the
    /// outline alone would fold, and single vertices are given room. Where the last outline was
    /// moved apart, positions before that come first, and then those after.
    /// @return positions without flipped triangles and with exact boundary lengths; nothing where
    ///         that does not come out, where they are strained much more than before the edit, or
    ///         cancelled
    /// Cost: a factorisation of the interior where the outline moves, some linear passes.
    std::optional<Points2> positions(const Progress& progress) const;

    /// A start whose outline does not cross itself: the sides of cuts that overlap are parted where
    /// they do (`partCutSides`). Where it crosses elsewhere too, the same from the positions after
    /// the last outline was moved apart.
    /// @param crossing  the present version's, exact lengths, no flipped triangle
    /// @return as `positions`
    std::optional<Points2> simplePositions(const Points2& crossing, const Progress& progress) const;

    /// A start where the edit moves the outline too far for `positions`, as a dart does that lets a
    /// strained piece open: a coarse piece is flattened as if nothing were known, and the vertices
    /// that it lacks follow it from their carried places.
    /// @param tolerance  of the fine descent (DescentOptions)
    /// @return as `positions`, with the multipliers; nothing where most vertices have moved in
    ///         space, the piece is small, its coarse one cannot be flattened, or cancelled
    /// Cost: half a factorisation of size 2 #V.
    std::optional<IsometricStart> fromCoarse(double tolerance, const Progress& progress) const;

    /// Of the boundary lengths: 0 for those that the earlier version did not have.
    Eigen::VectorXd multipliers() const;
    /// The earlier version's model where the triangles are the same, or null.
    std::shared_ptr<const KktModel> model() const;

private:
    bool isSmallEdit() const;
    std::optional<Points2> startFrom(const Points2& before, bool apart,
                                     const Progress& progress) const;
    std::optional<Points2> fitted(const Points2& warm, bool apart, const Progress& progress) const;

    const Piece& piece_;
    const FlatteningMemory& memory_;
    OutlineTargets targets_;
    VersionMatch match_;
};

}  // namespace toile::isometric
