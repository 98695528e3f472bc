// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

namespace toile {
struct PieceSettings;
}  // namespace toile

namespace toile::app {

class Document;

/// Usual names of materials, in the user's language.
QStringList proposedMaterials();

/// Edits of the settings of pieces apart from shape and place. Each is one step of the history,
/// none if it changes nothing. Indices outside the garment are ignored.

/// @param pieces  in the garment  @param gesture  as for Document::edit
void editSettings(Document& document, const QString& text, const std::vector<int>& pieces,
                  const std::function<void(int piece, PieceSettings&)>& change, int gesture = -1);
/// @param name  new name of the piece (`withName`); empty: as in its file
void renamePiece(Document& document, int piece, const QString& name);
/// @param quantity  how many of each are cut; clamped to 1 to kMaxCopies
void setQuantity(Document& document, const std::vector<int>& pieces, int quantity);
/// @param isPair  each of them is also cut mirrored
void setMirroredPair(Document& document, const std::vector<int>& pieces, bool isPair);

/// @param material  the name, at most kMaxLabelText characters; repeated blanks become one. Empty:
/// the
///                  garment's own fabric. A new material starts with that fabric. A material
///                  that no piece uses is removed, unless it has a fabric of its own.
void setMaterial(Document& document, const std::vector<int>& pieces, const QString& material);

/// Selects these pieces and all visible ones of the same material, or of the same layer of cloth
/// (`layersOf`) if the garment has several.
void selectSameMaterial(Document& document, const std::vector<int>& pieces);
void selectSameLayer(Document& document, const std::vector<int>& pieces);
bool hasLayers(const Document& document);

/// @param pieces  two that mirror each other, or one that is symmetric in itself
/// @param byHalf  only one half of them is drawn (Cutting::byHalf); mirrored pieces are made equal
///                if they are not yet
void setByHalf(Document& document, const std::vector<int>& pieces, bool byHalf);

/// Shows or hides pieces in the views. Hidden pieces are deselected, but stay in files and figures.
void hidePieces(Document& document, const std::vector<int>& pieces);
void showOnlyPieces(Document& document, const std::vector<int>& pieces);
void showAllPieces(Document& document);
bool isHidden(const Document& document, int piece);
bool isAnyHidden(const Document& document);

/// @param leftOut  they are not part of the pattern (PieceSettings::leftOut)
void setLeftOut(Document& document, const std::vector<int>& pieces, bool leftOut);
bool isLeftOut(const Document& document, int piece);
/// The pieces that are not left out and have a smaller area in 3D than this, mm2. Cost: linear in
/// the triangles.
std::vector<int> piecesBelow(const Document& document, double area);

/// The number of cut pieces of cloth: two for one mirrored pair.
int copiesOf(const Document& document, int piece);

}  // namespace toile::app
