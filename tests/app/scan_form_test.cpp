// SPDX-License-Identifier: GPL-3.0-or-later
// The form that prepares a scan: real keys and clicks, what the garment is meanwhile, and what the
// history keeps of it.
#include "app/panels/scan_form.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>

#include "app/widgets/garment_card.h"
#include "app/widgets/number_edits.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"
#include "tests/core/prepare/scan_shapes.h"

using namespace toile;
using namespace toile::app;

namespace {

/// A skirt with a hole, and six fragments about it.
MeshArrays scannedSkirt() {
    MeshArrays scan = test::withHole(test::skirt(), 0, 300, 30);
    for (int k = 0; k < 6; ++k) {
        scan = test::beside(scan, test::planeGrid(1 + k % 3, 1 + k / 3, 2.0 + k),
                            {100.0 * k, 50, 400});
    }
    return scan;
}

}  // namespace

class ScanFormTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    ScanForm* form() { return fixture_.window().findChild<ScanForm*>(); }
    const Preparation& said() { return fixture_.workspace().loading().preparing; }
    QString effect() { return fixture_.find<QLabel>("scanEffect").text(); }

    void click(const char* button) {
        QTest::mouseClick(&fixture_.find<QPushButton>(button), Qt::LeftButton);
    }

    /// At its box: beside the text is nothing to click at.
    void toggle(const char* name) {
        auto& box = fixture_.find<QCheckBox>(name);
        QTest::mouseClick(&box, Qt::LeftButton, {}, {8, box.height() / 2});
    }

    void type(const char* name, const QString& text) {
        auto& field = fixture_.find<LengthEdit>(name);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

    /// Whether the form shows what came of what it says.
    bool isShown(const QString& text) {
        return QTest::qWaitFor([&] { return document().isCurrent() && effect().contains(text); },
                               test::kPatience);
    }

    bool isGone() {
        return QTest::qWaitFor([this] { return !form(); }, test::kPatience) &&
               fixture_.waitForResults();
    }

    void openForm() {
        fixture_.action(ActionId::ReadScan).trigger();
        QVERIFY(form() && form()->isVisible());
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("scan.obj").toStdString(), {{"scan", scannedSkirt()}});
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("scan.obj")));
        QCOMPARE(document().garment()->files[0]->reading.kind, FileKind::Scan);
    }

    void cleanup() { fixture_.close(); }

    void isOpenedFromTheCardAndFlattensWhenItIsDone() {
        const int before = document().history().index();
        const int pieces = document().pieceCount();
        for (auto* button : fixture_.window().card().findChildren<QPushButton*>()) {
            if (button->text().startsWith("Prepare the scan") && button->isVisible()) {
                QTest::mouseClick(button, Qt::LeftButton);
                break;
            }
        }
        QVERIFY(form());
        QVERIFY(isShown("6 fragments"));
        QVERIFY(effect().contains("1 hole closed"));
        QCOMPARE(document().pieceCount(), 1);
        QVERIFY(document().scene());
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(!document().isFlattened());  // as long as values are tried
        click("scanDone");
        QVERIFY(isGone());
        QVERIFY(document().isFlattened());
        QVERIFY(!fixture_.window().card().isVisible());
        QVERIFY(fixture_.action(ActionId::ReadScan).isChecked());
        QCOMPARE(document().history().index(), before + 1);
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), pieces);
        QVERIFY(!said().as);
    }

    void aStepThatIsOffShowsTheLengthThatItWouldHave() {
        openForm();
        const auto& length = fixture_.find<LengthEdit>("scanEdgeLength");
        QVERIFY(!length.isEnabled());
        QCOMPARE(length.value(), 10.0);
        toggle("scanEdgeLengthOn");
        type("scanEdgeLength", "25");
        toggle("scanEdgeLengthOn");
        QCOMPARE(length.value(), 25.0);
        QVERIFY(!length.isEnabled());
        QVERIFY(isShown("6 fragments"));
        QCOMPARE(said().scan.edgeLength, 0.0);
        click("scanCancel");
    }

    void everyStepIsOptionalAndAllAreOneOfTheHistory() {
        const int before = document().history().index();
        openForm();
        QVERIFY(isShown("1 hole closed"));
        toggle("scanLargestHoleOn");
        QVERIFY(!fixture_.find<LengthEdit>("scanLargestHole").isEnabled());
        QVERIFY(isShown("3 openings"));
        QVERIFY(!effect().contains("closed"));
        toggle("scanDropDebris");
        QTRY_VERIFY_WITH_TIMEOUT(document().isCurrent() && !effect().contains("fragments"),
                                 test::kPatience);
        toggle("scanDropDebris");
        toggle("scanEdgeLengthOn");
        type("scanEdgeLength", "2 cm");
        QVERIFY(form()->isVisible());  // Enter takes the value, no more
        QVERIFY(isShown("remeshed to"));
        QCOMPARE(said().scan, (ScanSteps{true, 0, 1, 20}));
        QCOMPARE(document().history().index(), before + 1);
        toggle("scanSmoothingOn");
        click("scanDone");  // at once
        QVERIFY(isGone());
        QCOMPARE(said().scan, (ScanSteps{true, 0, 0, 20}));
        // Opened again it has these values.
        openForm();
        QVERIFY(!fixture_.find<QCheckBox>("scanLargestHoleOn").isChecked());
        QCOMPARE(fixture_.find<LengthEdit>("scanEdgeLength").value(), 20.0);
        QCOMPARE(document().history().index(), before + 1);
        click("scanCancel");
        QVERIFY(isGone());
        QCOMPARE(document().history().index(), before + 1);
    }

    void cancelLeavesNothing() {
        const int before = document().history().count();
        const auto garment = document().garment();
        openForm();
        QVERIFY(isShown("1 hole closed"));
        click("scanCancel");
        QVERIFY(isGone());
        QCOMPARE(document().history().count(), before);
        QVERIFY(!said().as);
        QVERIFY(document().isFlattened());
        QCOMPARE(document().garment(), garment);
        QVERIFY(!fixture_.action(ActionId::ReadScan).isChecked());
        QVERIFY(fixture_.window().card().isVisible());
    }

    void whatIsDoneElsewhereClosesIt() {
        openForm();
        QVERIFY(isShown("1 hole closed"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(isGone());
        QVERIFY(!said().as);
        openForm();
        QVERIFY(isShown("1 hole closed"));
        fixture_.action(ActionId::SplitComponents).trigger();
        QVERIFY(isGone());
        QCOMPARE(said().as, std::optional(FileKind::Scan));
        openForm();
        fixture_.close();  // with the form open
        fixture_.open();
    }
};

TOILE_WINDOW_TEST(ScanFormTest)
#include "scan_form_test.moc"
