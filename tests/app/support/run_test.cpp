// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/run_test.h"

#include <QLocale>
#include <QSurfaceFormat>

#include "app/resources.h"

namespace toile::test {

namespace {

constexpr char kLimit[] = "QTEST_FUNCTION_TIMEOUT";

}  // namespace

void prepareApplication() {
    // Qt ends a test function after five minutes, which a slow machine that does much else may
    // take. How long a program may take is CTest's affair.
    if (!qEnvironmentVariableIsSet(kLimit)) {
        qputenv(kLimit, QByteArray::number(60 * kPatience));
    }
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat());
    // Letters have one size on every display.
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
}

void prepareTest() {
    loadResources();
    QLocale::setDefault(QLocale::c());
}

}  // namespace toile::test
