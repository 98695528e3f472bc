// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QTest>

namespace toile::test {

/// Checks that a picture of the documentation exists. With TOILE_UPDATE_DOCS set, writes it first,
/// no wider than a page shows it.
/// @param name  file name in docs/images, without extension
inline void keepForDocs(const QString& name, QPixmap picture) {
    constexpr int kWidest = 1100;
    const QString file = TOILE_SOURCE_DIR "/docs/images/" + name + ".png";
    if (qEnvironmentVariableIsSet("TOILE_UPDATE_DOCS")) {
        if (picture.width() > kWidest) {
            picture = picture.scaledToWidth(kWidest, Qt::SmoothTransformation);
        }
        QVERIFY(picture.save(file));
    }
    QVERIFY2(!QPixmap(file).isNull(), qPrintable(file));
}

}  // namespace toile::test
