// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/names.h"

#include "app/base/text.h"
#include "app/document/document.h"
#include "core/project/piece_names.h"

namespace toile::app {

QString pieceName(const Document& document, int piece) {
    return QString::fromStdString(nameOf(
        document.state().labels, *document.garment()->pieces[static_cast<std::size_t>(piece)]));
}

QString seamName(const Document& document, int seam) {
    const Garment& garment = *document.garment();
    return QString::fromStdString(nameOf(document.state().labels, garment,
                                         garment.seams.seams[static_cast<std::size_t>(seam)]));
}

QString nameOfPieces(const Document& document, const std::vector<int>& pieces) {
    return pieces.size() == 1 ? pieceName(document, pieces.front())
                              : tr("%n pieces", nullptr, static_cast<int>(pieces.size()));
}

QString stepOf(const Document& document, const QString& text, const std::vector<int>& pieces) {
    return QString(text).replace("%1", nameOfPieces(document, pieces));
}

}  // namespace toile::app
