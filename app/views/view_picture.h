// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QImage>
#include <QPalette>
#include <optional>

#include "app/document/view_state.h"

namespace toile::app {

class Document;

/// What a picture shows of a document.
struct PictureOptions {
    QSize size{1600, 800};  ///< pixels, which are logical ones too
    ViewsShown views = ViewsShown::Both;
    std::optional<ViewDirection> direction{};  ///< of the garment; none: as the window begins
    double morph = 0;                          ///< the garment's way to the pattern, 0 to 1
    double sewn = 0;     ///< and to the cloth sewn of it, where the document has been proved
    bool legend = true;  ///< the colour bar below
    bool plain = false;  ///< no names and no axes, and the garment as large as there is room
    QFont font{};
    QPalette palette{};
};

/// The views of a document as they are in the window that shows everything of it, drawn into an
/// image: for documentation, tests and thumbnails. Needs a current OpenGL context of Qt's or of
/// offscreen.h. The same document gives the same image on the same machine.
/// @param problem  receives a sentence where a null image is returned
QImage drawViews(const Document& document, const PictureOptions& options, QString& problem);

}  // namespace toile::app
