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

/// Edits of one side of a garment that are done on its other side too: cuts and grain. All are one
/// step of the history with the edit itself.

/// Whether edits are mirrored: of a garment whose mirrored pieces are drawn equal, as the user has
/// chosen; by default only if the mesh is symmetric within tolerance (`isWithinTolerance`).
bool mirrorsEdits(const Document& document);
void setMirrorsEdits(Document& document, bool on);
/// By what; null where they are not to be, and as long as the mirror plane of the garment that the
/// person sees is not known.
const Symmetry* editSymmetry(const Document& document);

/// Adds a cut and its mirror image; that knows by its id what it mirrors.
void addMirroredCuts(std::vector<UserCut>& cuts, UserCut cut, UserCut image);
/// These cuts, and those that are their mirror images or whose mirror images they are.
/// Cost: the product of both numbers. Pure.
std::vector<CutId> withMirrorImages(const std::vector<UserCut>& cuts, std::vector<CutId> ids);

/// These pieces and, where edits are mirrored, their counterparts.
std::vector<int> withCounterparts(const Document& document, std::vector<int> pieces);
/// These pieces but, where edits are mirrored, of two that mirror each other only the first.
std::vector<int> withoutCounterparts(const Document& document, const std::vector<int>& pieces);

/// How the grain of pieces is to run, and with it that of their counterparts, where edits are
/// mirrored; what is said of both stays.
/// @param grains  by piece; none: unset
std::map<int, std::optional<double>> withMirroredGrains(
    const Document& document, std::map<int, std::optional<double>> grains);

}  // namespace toile::app
