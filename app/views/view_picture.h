// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QImage>
#include <QPalette>
#include <optional>

#include "app/document/view_state.h"

namespace toile::app {

class Document;

/// Options for a picture of a document.
struct PictureOptions {
    QSize size{1600, 800};  ///< device pixels, equal to logical pixels
    ViewsShown views = ViewsShown::Both;
    std::optional<ViewDirection> direction{};  ///< of the garment; nullopt: the initial view
    double morph = 0;                          ///< position in the morph to the pattern, 0 to 1
    double sewn = 0;     ///< position to the sewn cloth, if the document has a proof
    bool legend = true;  ///< the colour bar below
    bool plain = false;  ///< without names and axes, and the garment as large as possible
    QFont font{};
    QPalette palette{};
};

/// Draws the views of a document into an image, framed to show everything: for documentation, tests
/// and thumbnails. Requires a current OpenGL context of Qt or of offscreen.h. The same document
/// gives the same image on the same machine.
/// @param problem  receives a message if the returned image is null
QImage drawViews(const Document& document, const PictureOptions& options, QString& problem);

}  // namespace toile::app
