// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/cut/user_cuts.h"

namespace toile {
struct Symmetry;
}  // namespace toile

namespace toile::app {

class Document;

/// Edits of one side of a garment that are also made on its other side: cuts and grain. Both are
/// one step of the history.

/// Whether edits are mirrored: of a garment whose mirrored pieces are drawn equal, as the user has
/// chosen; by default only if the mesh is symmetric within tolerance (`isWithinTolerance`).
bool mirrorsEdits(const Document& document);
void setMirrorsEdits(Document& document, bool on);
/// The symmetry that edits are mirrored by; null if they are not mirrored, or if the mirror plane
/// of the shown garment is not known.
const Symmetry* editSymmetry(const Document& document);

/// Adds a cut and its mirror image, which stores the id of the cut.
void addMirroredCuts(std::vector<UserCut>& cuts, UserCut cut, UserCut image);
/// These cuts, their mirror images, and the cuts that they mirror. Cost: the product of both
/// numbers. Pure.
std::vector<CutId> withMirrorImages(const std::vector<UserCut>& cuts, std::vector<CutId> ids);

/// These pieces and, if edits are mirrored, their counterparts.
std::vector<int> withCounterparts(const Document& document, std::vector<int> pieces);
/// These pieces; if edits are mirrored, only the first of two that mirror each other.
std::vector<int> withoutCounterparts(const Document& document, const std::vector<int>& pieces);

/// The grain of these pieces and, if edits are mirrored, of their counterparts; the stated ones of
/// both stay.
/// @param grains  by piece; none: unset
std::map<int, std::optional<double>> withMirroredGrains(
    const Document& document, std::map<int, std::optional<double>> grains);

}  // namespace toile::app
