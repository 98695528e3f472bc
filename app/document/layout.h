// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>
#include <optional>
#include <vector>

#include "core/layout/arrange.h"
#include "core/mesh/mesh_arrays.h"
#include "core/project/piece_settings.h"

namespace toile::app {

class Document;

/// Where the document's flat pieces lie, and the edits that lay them elsewhere. All cost the
/// outlines of the pieces they look at, never their triangles; an edit is one step of the history.

/// By piece.
using PiecePlacements = std::map<int, Placement>;
using PieceGrains = std::map<int, std::optional<double>>;

/// The selected pieces that are flat, in order.
std::vector<int> selectedFlat(const Document& document);
/// All that are flat.
std::vector<int> allFlat(const Document& document);
/// The former; the latter where none is selected.
std::vector<int> selectedOrAllFlat(const Document& document);

/// Seam line, and the line that it is cut along, in the piece's own coordinates; empty where it is
/// not flat.
const Points2& flatOutline(const Document& document, int piece);
const Points2& cutOutline(const Document& document, int piece);
Placement placementOf(const Document& document, int piece);
/// How files draw the piece; the sheet always shows all of it.
CutAs cutAsOf(const Document& document, int piece);
/// Around the piece as it is cut, as it lies; empty where it is not flat.
Eigen::AlignedBox2d boxOnSheet(const Document& document, int piece);
Eigen::AlignedBox2d boxOnSheet(const Document& document, const std::vector<int>& pieces);

/// @param text  what is done, with %1 for whose places: see `stepOf`; so of all edits here
/// @param gesture  as for Document::edit
void place(Document& document, const QString& text, const PiecePlacements& placements,
           int gesture = -1);
/// Lays the pieces where they lay before a gesture, and forgets that somebody has moved them.
/// @param before  the settings of all pieces then
void placeBack(Document& document, const QString& text, const PiecePlacements& pieces,
               const std::vector<PieceSettings>& before, int gesture);
/// Turns the grain of mirrored pieces' counterparts too (`withMirroredGrains`).
void setGrain(Document& document, const QString& text, const PieceGrains& grains, int gesture = -1);

/// Turns the pieces together about the middle of the box around them.
void turnTogether(Document& document, const QString& text, const std::vector<int>& pieces,
                  double angle);
/// Mirrors the pieces together at the middle of the box around them.
void mirrorTogether(Document& document, const QString& text, const std::vector<int>& pieces,
                    Mirroring mirroring);
/// Turns each piece about its own middle so that its grain runs upwards on the sheet.
void turnGrainUpwards(Document& document, const std::vector<int>& pieces);
void align(Document& document, const std::vector<int>& pieces, Alignment alignment);
void distribute(Document& document, const std::vector<int>& pieces, Direction direction);
/// Lays the pieces in rows, turned as they are; beside the others where these are not all.
void layOutAgain(Document& document, const std::vector<int>& pieces);

}  // namespace toile::app
