// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>

#include "app/document/document.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// The window on the small screens of laptops and of rooms where people are taught.
class WindowSizeTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    QList<QDockWidget*> docks() { return fixture_.window().findChildren<QDockWidget*>(); }
    int dockWidth(const char* name) { return fixture_.find<QDockWidget>(name).width(); }

private slots:
    void initTestCase() { SKIP_WITHOUT_GL(); }
    void cleanup() { fixture_.close(); }

    /// What a screen of 1280 x 720 leaves of itself.
    void fitsASmallScreen() {
        constexpr QSize kSmall(1280, 680);
        fixture_.open(kSmall);
        for (const char* sample : {"tshirt", "trousers"}) {
            QVERIFY(fixture_.openAndWait(
                QString(TOILE_SOURCE_DIR "/resources/samples/%1.obj").arg(QLatin1String(sample))));
            for (QDockWidget* dock : docks()) {
                for (const int pieces : {0, 1, 2}) {
                    fixture_.document().setSelection(pieces == 0   ? Document::Selection{}
                                                     : pieces == 1 ? Document::Selection{0}
                                                                   : Document::Selection{0, 1});
                    dock->raise();
                    QCoreApplication::processEvents();
                    const QSize least = fixture_.window().minimumSizeHint();
                    QVERIFY2(least.width() <= kSmall.width() && least.height() <= kSmall.height(),
                             qPrintable(QString("%1: %2 x %3")
                                            .arg(dock->objectName())
                                            .arg(least.width())
                                            .arg(least.height())));
                }
            }
            QCOMPARE(fixture_.window().size(), kSmall);
        }
    }

    void columnsKeepTheirWidthWhateverIsSelected() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj"));
        const int before = fixture_.patternView().width();
        const int column = dockWidth("propertiesDock");
        for (const Document::Selection& pieces :
             {Document::Selection{0}, Document::Selection{1, 2}, Document::Selection{}}) {
            fixture_.document().setSelection(pieces);
            QCoreApplication::processEvents();
            QCOMPARE(dockWidth("propertiesDock"), column);
            QCOMPARE(fixture_.patternView().width(), before);
        }
        fixture_.document().setSeam(0);
        QCoreApplication::processEvents();
        QCOMPARE(dockWidth("propertiesDock"), column);
    }
};

TOILE_WINDOW_TEST(WindowSizeTest)
#include "window_size_test.moc"
