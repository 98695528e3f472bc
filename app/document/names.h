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

}  // namespace toile::app
