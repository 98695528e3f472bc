// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of properties shows what is selected, and only that.
#include <QLabel>
#include <QWidget>

#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class SelectionPanelTest : public QObject {
    Q_OBJECT

    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    bool isShown(const char* name) { return fixture_.find<QWidget>(name).isVisible(); }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("cap.obj").toStdString(), test::sewnCapParts());
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("cap.obj")));
    }

    void cleanup() { fixture_.close(); }

    void thePropertiesFollowTheSelection() {
        QVERIFY(isShown("selectionGarment"));
        QVERIFY(fixture_.find<QLabel>("selectionGarment").text().contains("2 pieces"));
        QVERIFY(!isShown("pieceName") && !isShown("segmentLength"));
        document().setSelection({1});
        QVERIFY(isShown("pieceName") && isShown("positionX"));
        QVERIFY(!isShown("selectionGarment") && !isShown("segmentLength"));
        document().setSeam(0);
        QVERIFY(isShown("segmentLength") && fixture_.find<QWidget>("segmentLength").isEnabled());
        QVERIFY(!isShown("pieceName") && !isShown("selectionGarment"));
        const SeamSide& side = document().garment()->seams.seams[0].left;
        document().setMark(Feature{.kind = Feature::Kind::Run,
                                   .piece = side.piece,
                                   .first = side.first,
                                   .count = side.count});
        QVERIFY(isShown("segmentLength") && !isShown("pieceName"));
        document().selectNothing();
        QVERIFY(isShown("selectionGarment"));
    }

    void aHiddenPanelComputesNothingAndCatchesUp() {
        auto& dock = fixture_.find<QWidget>("propertiesDock");
        dock.hide();
        document().setSeam(0);
        QVERIFY(!fixture_.find<QWidget>("segmentLength").isEnabled());
        dock.show();
        QVERIFY(fixture_.find<QWidget>("segmentLength").isEnabled());
    }
};

TOILE_WINDOW_TEST(SelectionPanelTest)
#include "selection_panel_test.moc"
