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

/// What materials are usually called, in the person's language.
QStringList proposedMaterials();

/// Edits of what is said about pieces beyond their shape and place. Each is one step of the
/// history, nothing where all is so already; indices outside the garment are left out.

/// @param pieces  in the garment  @param gesture  as for Document::edit
void editSettings(Document& document, const QString& text, const std::vector<int>& pieces,
                  const std::function<void(int piece, PieceSettings&)>& change, int gesture = -1);
/// @param name  what the piece is called from now on (`withName`); empty: as its file has it
void renamePiece(Document& document, int piece, const QString& name);
/// @param quantity  how many of each are cut, 1 to kMaxCopies; others are brought there
void setQuantity(Document& document, const std::vector<int>& pieces, int quantity);
/// @param isPair  each of them is also cut mirrored
void setMirroredPair(Document& document, const std::vector<int>& pieces, bool isPair);

/// @param material  what they are cut from, at most kMaxLabelText characters of it, its blanks
///                  simplified; empty: the garment's own fabric. One that is new begins with that;
///                  one that no piece has any more goes, unless it has a fabric of its own.
void setMaterial(Document& document, const std::vector<int>& pieces, const QString& material);

/// Selects, with these pieces, all seen ones that are cut from the same material; of the same layer
/// of cloth (`layersOf`), where the garment has several.
void selectSameMaterial(Document& document, const std::vector<int>& pieces);
void selectSameLayer(Document& document, const std::vector<int>& pieces);
bool hasLayers(const Document& document);

/// @param pieces  two that mirror each other, or one that is symmetric in itself
/// @param byHalf  only one half of them is drawn (Cutting::byHalf); mirrored pieces are made equal
///                for it where they are not yet
void setByHalf(Document& document, const std::vector<int>& pieces, bool byHalf);

/// What is drawn in the views: hidden pieces are not, and are not selected any more. Files and
/// figures have them.
void hidePieces(Document& document, const std::vector<int>& pieces);
void showOnlyPieces(Document& document, const std::vector<int>& pieces);
void showAllPieces(Document& document);
bool isHidden(const Document& document, int piece);
bool isAnyHidden(const Document& document);

/// @param leftOut  they are no part of the pattern (PieceSettings::leftOut)
void setLeftOut(Document& document, const std::vector<int>& pieces, bool leftOut);
bool isLeftOut(const Document& document, int piece);
/// The pieces that are not left out and smaller than that as they are worn, mm2.
/// Cost: linear in the triangles.
std::vector<int> piecesBelow(const Document& document, double area);

/// How many pieces of cloth are cut from it: two for one mirrored pair.
int copiesOf(const Document& document, int piece);

}  // namespace toile::app
