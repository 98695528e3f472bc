// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTreeView>

#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// On a computer without OpenGL 3.3 the window says so and does all its other work.
class NoGlTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

private slots:
    void initTestCase() {
        if (glProblem().isEmpty()) {
            QSKIP("this platform offers OpenGL 3.3");
        }
        test::writeObj(fixture_.path("cap.obj").toStdString(), {{"cap", test::makeCap(0)}});
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("cap.obj")));
    }

    void cleanup() { fixture_.close(); }

    void windowSaysSoAndWorksOn() {
        QVERIFY(fixture_.find<QLabel>("glProblem").text().contains("OpenGL 3.3"));
        QVERIFY(fixture_.window().views().isUpToDate());
        fixture_.action(ActionId::Frame).trigger();
        QCOMPARE(fixture_.find<QTreeView>("pieceTable").model()->rowCount(), 1);

        QSignalSpy exported(&fixture_.workspace(), &Workspace::exported);
        fixture_.action(ActionId::ExportPattern).trigger();
        fixture_.find<QLineEdit>("exportPath").setText(fixture_.path("cap.dxf"));
        fixture_.find<QPushButton>("exportNow").click();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, test::kPatience);
    }

    void methodsAreComparedByTheTableAlone() {
        fixture_.action(ActionId::CompareMethods).trigger();
        auto& sentence = fixture_.find<QLabel>("compareNote");
        QVERIFY(sentence.isVisible());
        QVERIFY(sentence.text().contains("OpenGL 3.3"));
        const auto& figures = *fixture_.find<QTableView>("compareTable").model();
        QTRY_VERIFY_WITH_TIMEOUT(!figures.index(3, 3).data().toString().isEmpty(), test::kPatience);
    }
};

TOILE_WINDOW_TEST(NoGlTest)
#include "no_gl_test.moc"
