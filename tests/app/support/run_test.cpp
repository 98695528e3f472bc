// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/run_test.h"

#include <QLocale>
#include <QSurfaceFormat>

#include "app/resources.h"

namespace toile::test {

void prepareApplication() {
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat());
    // Letters have one size on every display.
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
}

void prepareTest() {
    loadResources();
    QLocale::setDefault(QLocale::c());
}

}  // namespace toile::test
