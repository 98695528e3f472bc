// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/drawing_words.h"

#include <QCoreApplication>

namespace toile {

DrawingWords drawingWords() {
    const auto told = [](const QString& text) { return text.toStdString(); };
    return {
        .noAllowance = told(QCoreApplication::translate("toile", "net outline, no allowance")),
        .mirrored =
            told(QCoreApplication::translate("toile", "mirrored: wrong side of the fabric up")),
        .cut = told(QCoreApplication::translate("toile", "cut %1")),
        .cutPair = told(QCoreApplication::translate("toile", "cut 1 pair")),
        .cutPairs = told(QCoreApplication::translate("toile", "cut %1 pairs")),
        .checkSquare = told(QCoreApplication::translate("toile", "check square 100 mm x 100 mm"))};
}

}  // namespace toile
