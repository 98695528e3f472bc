// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <vector>

class QPainter;

namespace toile::app {

class Document;
class SheetMap;
struct RenderStyle;

/// The fold of every piece that files show as a half, dash-dotted over the whole piece as it lies,
/// with its word.
/// @return what the words take, logical pixels
std::vector<QRectF> paintFolds(QPainter& painter, const RenderStyle& style,
                               const SheetMap& onScreen, const Document& document);

}  // namespace toile::app
