// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QSignalSpy>
#include <QTreeView>
#include <QTreeWidget>
#include <cmath>
#include <numbers>

#include "app/actions/garment_actions.h"
#include "app/panels/seams_model.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/widgets/banner.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/pixels.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/warnings.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

namespace {

/// A tube that is 700 mm wide at the hem and 300 at the waist, 600 high.
MeshArrays skirt() {
    constexpr int kAround = 48, kAlong = 20;
    MeshArrays mesh{Points3(kAround * (kAlong + 1), 3), Triangles(2 * kAround * kAlong, 3)};
    for (int j = 0; j <= kAlong; ++j) {
        const double radius = 350 - 200.0 * j / kAlong;
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2 * std::numbers::pi * i / kAround;
            mesh.V.row(kAround * j + i) << radius * std::cos(angle), 30.0 * j,
                -0.6 * radius * std::sin(angle);
        }
    }
    for (int j = 0, f = 0; j < kAlong; ++j) {
        for (int i = 0; i < kAround; ++i) {
            const int a = kAround * j + i, b = kAround * j + (i + 1) % kAround;
            mesh.F.row(f++) << a, b, b + kAround;
            mesh.F.row(f++) << a, b + kAround, a + kAround;
        }
    }
    return mesh;
}

}  // namespace

/// The ledger in the window: a cap of two parts, freely flattened, so that its seam does not match.
class SeamLedgerTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    QTreeView& table() { return fixture_.find<QTreeView>("seamTable"); }
    QModelIndex cell(int row, int column) { return table().model()->index(row, column); }
    QPoint middleOf(const QModelIndex& index) { return table().visualRect(index).center(); }

    /// With no seam, so that no row stays.
    void showAnotherGarment() {
        test::editGarment(document(), "Another",
                          test::makeGarment({{"alone", test::makeSheet(50, 40, 5, 4)}}));
    }

    /// Opens the editor of the first seam's ease and types there.
    QPointer<QLineEdit> typeEase(const QString& text) {
        table().setFocus();
        table().setCurrentIndex(cell(0, SeamsModel::Name));
        QTest::keyClick(&table(), Qt::Key_F2);
        QPointer<QLineEdit> editor = table().findChild<QLineEdit*>("easeEditor");
        if (editor) {
            QTest::keyClicks(editor, text);
        }
        return editor;
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("cap.obj").toStdString(), test::sewnCapParts());
        test::writeObj(fixture_.path("skirt.obj").toStdString(), {{"skirt", skirt()}});
        test::writeObj(fixture_.path("tube.obj").toStdString(),
                       {{"tetrahedron", test::makeTetrahedron(300)}});
        test::writeObj(fixture_.path("alone.obj").toStdString(),
                       {{"strip", test::makeBentStrip(0)}});
    }

    void init() {
        fixture_.open();
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        fixture_.workspace().setMethod(Method::Natural);
        QVERIFY(fixture_.openAndWait(fixture_.path("cap.obj")));
        fixture_.action(ActionId::GoToSeams).trigger();
    }

    void cleanup() { fixture_.close(); }

    void anEditorGoesWithItsRowWhoeverHasTheKeyboard() {
        const test::Warnings warnings;
        for (const bool elsewhere : {false, true}) {
            const QPointer<QLineEdit> editor = typeEase("7");
            QVERIFY(editor);
            if (elsewhere) {  // the person looks at another window: nothing of this one has it
                QApplication::setActiveWindow(nullptr);
            }
            showAnotherGarment();
            QTRY_VERIFY_WITH_TIMEOUT(!editor, test::kPatience);
            QApplication::setActiveWindow(&fixture_.window());
            document().history().undo();
            QVERIFY(fixture_.waitForResults());
        }
        QVERIFY2(warnings.texts().isEmpty(), qPrintable(warnings.texts().join('\n')));
    }

    void anEaseThatIsOnlyLookedAtStaysAsItIs() {
        fixture_.document().setSeamEase(0, 0.0254);  // shown as 2.5
        const int steps = document().history().count();
        const QPointer<QLineEdit> editor = typeEase("");
        QVERIFY(editor);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!editor, test::kPatience);
        QCOMPARE(document().garment()->seams.seams[0].ease, std::optional(0.0254));
        QCOMPARE(document().history().count(), steps);
    }

    void whatIsEnteredCountsBeforeWhatComesNext() {
        const test::Warnings warnings;
        const QPointer<QLineEdit> editor = typeEase("7");
        QVERIFY(editor);
        QTest::keyClick(editor, Qt::Key_Return);
        showAnotherGarment();  // before any other event
        QTRY_VERIFY_WITH_TIMEOUT(!editor, test::kPatience);
        document().history().undo();
        QCOMPARE(document().garment()->seams.seams[0].ease, std::optional(0.07));
        QVERIFY2(warnings.texts().isEmpty(), qPrintable(warnings.texts().join('\n')));
    }

    void seamsAreListedAndFreeEdgesOnDemand() {
        QVERIFY(table().isVisible());
        QCOMPARE(table().model()->rowCount(), 1);
        auto& summary = fixture_.find<QLabel>("seamSummary");
        QVERIFY(summary.text().contains("1 does not match"));
        QTest::mouseClick(&fixture_.find<QCheckBox>("showFreeEdges"), Qt::LeftButton, {}, {8, 8});
        QVERIFY(table().model()->rowCount() > 1);
        // The seam is the worst and so the first, whatever free edges there are.
        QCOMPARE(cell(0, SeamsModel::Kind).data().toString(), QString("seam"));
        fixture_.action(ActionId::MethodWang2005).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(summary.text() == "1 seam · worst 0.00 mm", test::kPatience);
    }

    void aSelectedSeamLightsUpInBothViews() {
        constexpr int kTolerance = 19;
        const QColor yellow = renderStyle(fixture_.window().palette()).seam;
        const int before3d = test::countPixels(fixture_.garmentPicture(), yellow, kTolerance);
        const int before2d = test::countPixels(fixture_.patternPicture(), yellow, kTolerance);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                          middleOf(cell(0, SeamsModel::Name)));
        QCOMPARE(document().seam(), std::optional(0));
        QVERIFY(test::countPixels(fixture_.garmentPicture(), yellow, kTolerance) > before3d + 200);
        QVERIFY(test::countPixels(fixture_.patternPicture(), yellow, kTolerance) > before2d + 400);
        fixture_.action(ActionId::SelectNone).trigger();
        QVERIFY(!document().seam());
        QCOMPARE(test::countPixels(fixture_.patternPicture(), yellow, kTolerance), before2d);
        QVERIFY(table().selectionModel()->selectedRows().isEmpty());
    }

    void arrowKeysWalkThroughTheSeams() {
        fixture_.find<QCheckBox>("showFreeEdges").setChecked(true);
        table().setFocus();
        table().setCurrentIndex(cell(0, SeamsModel::Name));
        QCOMPARE(document().seam(), std::optional(0));
        QTest::keyClick(&table(), Qt::Key_Down);
        QVERIFY(document().seam() && *document().seam() > 0);
        // Hiding the free edges hides the selected one: the next row there is takes its place.
        fixture_.find<QCheckBox>("showFreeEdges").setChecked(false);
        QCOMPARE(document().seam(), std::optional(0));
    }

    void enterAndDoubleClickFrameBothSides() {
        auto& view = fixture_.patternView();
        const auto showsSeam = [&] {
            return view.camera().visible().contains(
                placedBox(document().scene()->seams[0], placesOf(document().settings())));
        };
        const auto lookAway = [&view] { test::turnWheel(view, {5, 5}, 10); };
        (void)fixture_.patternPicture();
        lookAway();
        QVERIFY(!showsSeam());
        table().setFocus();
        table().setCurrentIndex(cell(0, SeamsModel::Name));
        QTest::keyClick(&table(), Qt::Key_Return);
        QVERIFY(showsSeam());
        lookAway();
        const QPoint onName = middleOf(cell(0, SeamsModel::Name));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, onName);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, onName);
        QVERIFY(showsSeam());
        lookAway();
        QTest::keyClick(&table(), Qt::Key_F);  // no piece is selected
        QVERIFY(showsSeam());
    }

    void statedEaseTurnsTheErrorGreenAndKeepsTheResults() {
        const auto results = document().results();
        const auto scene = document().scene();
        table().setFocus();
        table().setCurrentIndex(cell(0, SeamsModel::Name));
        const auto& seam = document().garment()->seams.seams[0];
        const auto measure = measureSeam(seam, *results[std::size_t(seam.left.piece)]->piece,
                                         *results[std::size_t(seam.left.piece)]->flat,
                                         *results[std::size_t(seam.right.piece)]->piece,
                                         *results[std::size_t(seam.right.piece)]->flat);

        QTest::keyClick(&table(), Qt::Key_F2);
        auto* editor = table().findChild<QLineEdit*>("easeEditor");
        QVERIFY(editor);
        // Figures are typed, not taken as the keys of the overlays.
        const Overlay overlay = document().view().overlay;
        QTest::keyClicks(
            editor,
            QString::number(100 * (measure.length2dLeft / measure.length2dRight - 1), 'f', 4));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(cell(0, SeamsModel::Fit).data().toString(), QString("matches"),
                                  test::kPatience);
        QCOMPARE(document().view().overlay, overlay);
        QVERIFY(document().results() == results);
        QCOMPARE(document().scene(), scene);
        QCOMPARE(document().seam(), std::optional(0));
        QVERIFY(!fixture_.workspace().jobs().isBusy());
        QCOMPARE(fixture_.workspace().loading().seamSettings.size(), std::size_t(1));

        // A reading keeps it.
        fixture_.action(ActionId::Reload).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(document().garment()->seams.seams[0].ease);
        QCOMPARE(cell(0, SeamsModel::Fit).data().toString(), QString("matches"));

        table().setFocus();
        table().setCurrentIndex(cell(0, SeamsModel::Name));
        QTest::keyClick(&table(), Qt::Key_Delete);
        QVERIFY(!document().garment()->seams.seams[0].ease);
        QVERIFY(fixture_.workspace().loading().seamSettings.empty());
        QCOMPARE(cell(0, SeamsModel::Fit).data().toString(), QString("does not match"));
    }

    void whatIsTypedOutlivesResults() {
        const QPointer<QLineEdit> editor = typeEase("2");
        QVERIFY(editor);
        const auto before = document().results();
        fixture_.workspace().setMethod(Method::Wang2005);  // other figures, another order
        QVERIFY(fixture_.waitForResults());
        QVERIFY(document().results() != before);
        QVERIFY(editor && editor->isVisible());
        QCOMPARE(editor->text(), QString("2"));
        QTest::keyClicks(editor, ".5");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(document().garment()->seams.seams[0].ease, std::optional(0.025),
                                  test::kPatience);
    }

    void whatIsTypedOutlivesAReadingWithTheSameSeams() {
        const QPointer<QLineEdit> editor = typeEase("2");
        QVERIFY(editor);
        const auto before = document().garment();
        fixture_.workspace().setUnit(LengthUnit::Centimetre);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(document().garment() != before);
        QVERIFY(editor && editor->isVisible());
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(document().garment()->seams.seams[0].ease, std::optional(0.02),
                                  test::kPatience);
        QCOMPARE(document().history().count(), 2);
    }

    void whatIsTypedForASeamThatIsNoMoreIsNotAskedFor() {
        const QPointer<QLineEdit> editor = typeEase("2");
        QVERIFY(editor);
        QVERIFY(fixture_.openAndWait(fixture_.path("alone.obj")));
        QTRY_VERIFY_WITH_TIMEOUT(!editor || !editor->isVisible(), test::kPatience);
        QVERIFY(!document().history().canUndo());
    }

    void easeGoesWithTheGarment() {
        fixture_.document().setSeamEase(0, 0.1);
        QVERIFY(fixture_.openAndWait(fixture_.path("alone.obj")));
        QVERIFY(fixture_.workspace().loading().seams.empty());
        QVERIFY(fixture_.workspace().loading().seamSettings.empty());
        QVERIFY(document().garment()->problems.empty());
        // Nothing is sewn here, and the panel says so.
        QVERIFY(fixture_.find<QLabel>("seamsEmpty").isVisible());
        QVERIFY(!fixture_.find<QTreeWidget>("cutTable").isVisible());
    }

    void cutsAreListedWhereThereAreAny() {
        QVERIFY(fixture_.openAndWait(fixture_.path("tube.obj")));
        fixture_.action(ActionId::AutoCut).trigger();
        QVERIFY(fixture_.action(ActionId::AutoCut).isChecked());
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!document().garment()->cuts.empty());
        auto& cuts = fixture_.find<QTreeWidget>("cutTable");
        QVERIFY(cuts.isVisible());
        QCOMPARE(cuts.topLevelItemCount(), int(document().garment()->cuts.size()));
        QCOMPARE(cuts.topLevelItem(0)->text(1), QString("Toile"));
        QCOMPARE(cuts.topLevelItem(0)->text(2), QString("tetrahedron"));
    }

    void aSkirtIsCutAsTailorsDo() {
        QVERIFY(fixture_.openAndWait(fixture_.path("skirt.obj")));
        fixture_.action(ActionId::TailorCuts).trigger();
        QVERIFY(fixture_.action(ActionId::TailorCuts).isChecked());
        QVERIFY(fixture_.action(ActionId::AutoCut).isChecked());
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 2);  // front and back
        auto& cuts = fixture_.find<QTreeWidget>("cutTable");
        QCOMPARE(cuts.topLevelItemCount(), 2);
        QVERIFY(cuts.topLevelItem(0)->text(0).endsWith("side"));
        QVERIFY(cuts.topLevelItem(0)->toolTip(0).contains(": "));
        fixture_.action(ActionId::TailorCuts).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 1);  // one cut is enough
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 2);
    }

    void seamsFileIsReadAndABadOneIsSaid() {
        const auto write = [this](const QString& name, const QByteArray& text) {
            QFile file(fixture_.path(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
        };
        SeamsFile seams;
        seams.ease[document().garment()->seams.seams[0].name] = 0.05;
        write("good.json", QByteArray::fromStdString(writeSeamsFile(seams)));
        write("bad.json", "{");
        FileDialogs dialogs = FileDialogs::native();
        QString answer = fixture_.path("bad.json");
        dialogs.openSeams = [&](QWidget*, const QString&) { return answer; };
        fixture_.window().garmentActions().setFileDialogs(dialogs);
        fixture_.action(ActionId::SeamsFromFile).trigger();
        QVERIFY(fixture_.window().banner().isVisible());
        QVERIFY(fixture_.window().banner().sentence().contains("bad.json"));
        answer = fixture_.path("good.json");
        fixture_.action(ActionId::SeamsFromFile).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().garment()->seams.seams[0].ease, std::optional(0.05));
        QVERIFY(!fixture_.window().banner().isVisible());
    }
};

TOILE_WINDOW_TEST(SeamLedgerTest)
#include "seam_ledger_test.moc"
