// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace toile::app {

class Document;

/// What things are called on the screen: by the names that a person has given.

/// Precondition: of the garment.
QString pieceName(const Document& document, int piece);
QString seamName(const Document& document, int seam);
/// "front", or "3 pieces".
QString nameOfPieces(const Document& document, const std::vector<int>& pieces);
/// What was done to pieces, as the history says it: "Move front".
/// @param text  with %1 for their name: "Move %1"
QString stepOf(const Document& document, const QString& text, const std::vector<int>& pieces);

}  // namespace toile::app
