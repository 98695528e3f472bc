// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QDebug>

#include "app/settings/language.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// The window on the small screens of laptops and of rooms where people are taught.
class WindowSizeTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

private slots:
    void initTestCase() { SKIP_WITHOUT_GL(); }
    void cleanup() { fixture_.close(); }

    void fitsASmallScreen() {
        fixture_.open({1280, 680});
        QVERIFY(fixture_.openAndWait(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj"));
        for (const auto* dock : fixture_.window().findChildren<QDockWidget*>()) {
            qDebug() << dock->objectName() << dock->minimumSizeHint() << dock->widget()->minimumSizeHint()<< dock->size();
        }
        qDebug() << fixture_.window().minimumSizeHint() << fixture_.window().size();
        const QSize size = fixture_.window().size();
        QVERIFY(size.width() <= 1280);
        QVERIFY(size.height() <= 680);
    }
};

TOILE_WINDOW_TEST(WindowSizeTest)
#include "window_size_test.moc"
