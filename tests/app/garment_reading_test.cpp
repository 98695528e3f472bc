// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <array>
#include <fstream>
#include <numbers>
#include <set>

#include "app/panels/pieces_model.h"
#include "app/render/scene.h"
#include "app/widgets/garment_card.h"
#include "app/widgets/number_edits.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"
#include "tests/core/support/shapes.h"

using namespace toile;
using namespace toile::app;

namespace {

/// Two sheets that touch, 240 by 220 in all, `scale` times as large, as islands of a UV map.
void writeWithUv(const std::string& path, double scale) {
    std::ofstream out(path);
    out << "o shirt\n";
    Eigen::Index first = 1;
    for (const auto& [name, mesh] :
         {std::pair{"left", test::makeSheet(150, 220, 6, 8)},
          std::pair{"right", test::makeSheet(90, 220, 4, 8, {150, 0, 0})}}) {
        for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
            out << "v " << scale * mesh.V(v, 0) << ' ' << scale * mesh.V(v, 1) << ' '
                << scale * mesh.V(v, 2) << "\nvt " << mesh.V(v, 0) / 500 << ' '
                << mesh.V(v, 1) / 500 << '\n';
        }
        out << "g " << name << '\n';
        for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
            out << 'f';
            for (int k = 0; k < 3; ++k) {
                out << ' ' << mesh.F(f, k) + first << '/' << mesh.F(f, k) + first;
            }
            out << '\n';
        }
        first += mesh.V.rows();
    }
}

/// A sheet of 400 by 600, closed: a copy 2 behind it that looks the other way, and rims.
MeshArrays thickSheet() {
    const MeshArrays sheet = test::makeSheet(400, 600, 8, 12);
    const auto n = static_cast<int>(sheet.V.rows());
    std::vector<std::array<int, 3>> faces;
    std::set<std::pair<int, int>> sides;
    for (const auto& f : sheet.F.rowwise()) {
        faces.push_back({f[0], f[1], f[2]});
        faces.push_back({f[0] + n, f[2] + n, f[1] + n});
        sides.insert({{f[0], f[1]}, {f[1], f[2]}, {f[2], f[0]}});
    }
    for (const auto& [a, b] : sides) {
        if (!sides.contains({b, a})) {
            faces.push_back({b, a, a + n});
            faces.push_back({b, a + n, b + n});
        }
    }
    MeshArrays thick{Points3(2 * n, 3), Triangles(std::ssize(faces), 3)};
    thick.V << sheet.V, sheet.V.rowwise() - Eigen::RowVector3d(0, 0, 2);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        thick.F.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
    }
    return thick;
}

/// The right half of a skirt, 600 high.
MeshArrays halfSkirt() {
    MeshArrays half = test::makeSheet(std::numbers::pi, 600, 20, 30);
    for (auto point : half.V.rowwise()) {
        const double angle = point[0];
        point[0] = 150 * std::sin(angle);
        point[2] = 150 * std::cos(angle);
    }
    return half;
}

}  // namespace

/// How a garment is read, and what the window asks and offers about it.
class GarmentReadingTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    GarmentCard& card() { return fixture_.window().card(); }
    QString summary() { return fixture_.find<QToolButton>("garmentSummary").text(); }

    QPushButton* cardButton(const QString& text) {
        for (auto* button : card().findChildren<QPushButton*>()) {
            if (button->text() == text && button->isVisible()) {
                return button;
            }
        }
        return nullptr;
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        // 12 units wide: a shirt for a doll in centimetres?
        writeWithUv(fixture_.path("small.obj").toStdString(), 0.05);
        writeWithUv(fixture_.path("sure.obj").toStdString(), 2.0);
        test::writeObj(fixture_.path("thick.obj").toStdString(), {{"panel", thickSheet()}});
        test::writeObj(fixture_.path("half.obj").toStdString(), {{"skirt", halfSkirt()}});
        MeshArrays cushion = test::octahedron();
        cushion.V *= 300;
        test::writeObj(fixture_.path("cushion.obj").toStdString(), {{"cushion", cushion}});
        // 14.4 units, as MakeHuman's suits are.
        writeWithUv(fixture_.path("decimetres.obj").toStdString(), 0.06);
        // Flatter along y than along z, and not by enough.
        test::writeObj(fixture_.path("lying.obj").toStdString(),
                       {{"top", test::makeSheet(900, 260, 4, 4)},
                        {"far", test::makeSheet(900, 20, 4, 4, {0, 0, 520})}});
    }

    void init() { fixture_.open(); }

    void cleanup() { fixture_.close(); }

    void nothingIsAskedWhereThereIsNoDoubt() {
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        QVERIFY(!card().isVisible());
        QCOMPARE(summary(), QString("height 44.0 cm · mm (guessed) · 2 pieces by UV islands"));
        const QString reasons = fixture_.find<QToolButton>("garmentSummary").toolTip();
        QVERIFY(reasons.contains("largest extent 480, read as millimetres"));
        QVERIFY(reasons.contains("Up axis: "));
        QCOMPARE(reasons.section("\n\n", 0, 0).count('\n'), 2);
    }

    void aUnitThatTheFileStatesIsNoGuess() {
        std::ofstream(fixture_.path("stated.usda").toStdString())
            << "#usda 1.0\n( metersPerUnit = 0.01 upAxis = \"Y\" )\ndef Mesh \"panel\" {\n"
               " int[] faceVertexCounts = [3]\n int[] faceVertexIndices = [0, 1, 2]\n"
               " point3f[] points = [(0, 0, 0), (50, 0, 0), (0, 60, 0)]\n}\n";
        QVERIFY(fixture_.openAndWait(fixture_.path("stated.usda")));
        QVERIFY2(summary().startsWith("height 60.0 cm · cm (from the file) · 1 piece"),
                 qPrintable(summary()));
    }

    void aDoubtfulUnitIsAskedForAndTheAnswerReadsAgain() {
        QVERIFY(fixture_.openAndWait(fixture_.path("small.obj")));
        QVERIFY(card().isVisible());
        QVERIFY(card().sentence().contains("11.0 cm tall if the file is in centimetres"));
        QVERIFY(card().sentence().contains("(largest extent 12)"));
        QVERIFY(cardButton("cm: 11.0 cm")->isChecked());
        QVERIFY(!cardButton("in: 27.9 cm")->isChecked());
        QVERIFY(cardButton("m: 11.0 m") && cardButton("mm: 1.1 cm") && cardButton("dm: 1.10 m"));
        QVERIFY(!fixture_.find<QWidget>("upQuestion").isVisible());

        QTest::mouseClick(cardButton("in: 27.9 cm"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().garment()->files[0]->unit, LengthUnit::Inch);
        QVERIFY(!card().isVisible());
        QCOMPARE(summary(), QString("height 27.9 cm · in · 2 pieces by UV islands"));
        QVERIFY(fixture_.action(ActionId::UnitInch).isChecked());

        // Another garment has another unit.
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        QCOMPARE(document().garment()->files[0]->unit, LengthUnit::Millimetre);
        QVERIFY(fixture_.action(ActionId::UnitAuto).isChecked());
    }

    void keepHidesTheCardAlsoAfterReadingAgain() {
        QVERIFY(fixture_.openAndWait(fixture_.path("small.obj")));
        QTest::mouseClick(&fixture_.find<QPushButton>("keepGuess"), Qt::LeftButton);
        QVERIFY(!card().isVisible());
        QVERIFY(!fixture_.workspace().jobs().isBusy());
        fixture_.action(ActionId::Reload).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!card().isVisible());
        QCOMPARE(document().garment()->files[0]->unit, LengthUnit::Centimetre);
    }

    void aHeightIsTyped() {
        QVERIFY(fixture_.openAndWait(fixture_.path("decimetres.obj")));
        QVERIFY(cardButton("dm: 1.32 m")->isChecked());
        auto& field = fixture_.find<LengthEdit>("otherLength");
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, "180 cm");
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(std::abs(document().scene()->box.sizes().y() - 1800) < 1e-9 * 1800);
        QVERIFY(!document().garment()->files[0]->unit.named());
        QVERIFY(!card().isVisible());
        QVERIFY(summary().startsWith("height 1.80 m"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().garment()->files[0]->unit, FileUnit(LengthUnit::Decimetre));
    }

    void theSummaryAsksAgain() {
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        QVERIFY(!card().isVisible());
        const auto press = [this] {
            QTest::mouseClick(&fixture_.find<QToolButton>("garmentSummary"), Qt::LeftButton);
        };
        press();
        QVERIFY(card().isVisible());
        QTest::mouseClick(&fixture_.find<QPushButton>("keepGuess"), Qt::LeftButton);
        QVERIFY(!card().isVisible());
        press();
        QTest::mouseClick(cardButton("dm: 44.0 m"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!card().isVisible());
        QCOMPARE(summary(), QString("height 44.0 m · dm · 2 pieces by UV islands"));
    }

    void aDoubtfulUpAxisIsAskedFor() {
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        QVERIFY(fixture_.openAndWait(fixture_.path("lying.obj")));
        QVERIFY(document().garment()->files[0]->upInDoubt);
        QVERIFY(card().isVisible());
        QVERIFY(!fixture_.find<QWidget>("unitQuestion").isVisible());
        QVERIFY(cardButton("y up")->isChecked());
        QTest::mouseClick(cardButton("z up"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().garment()->files[0]->up, UpAxis::Z);
        QVERIFY(!card().isVisible());
        QVERIFY(fixture_.action(ActionId::UpZ).isChecked());
        QVERIFY(summary().startsWith("height 52.0 cm"));
    }

    void aThickShellIsAskedFor() {
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        QVERIFY(fixture_.openAndWait(fixture_.path("thick.obj")));
        const auto file = [this]() -> const SourceFile& { return *document().garment()->files[0]; };
        QCOMPARE(file().reading.kind, FileKind::Shell);
        QCOMPARE(document().pieceCount(), 1);
        QVERIFY(document().result(0)->flat);
        QVERIFY(!document().scene()->garmentLines.leftOut.empty());
        QVERIFY(card().isVisible());
        QVERIFY(fixture_.find<GarmentCard>("garmentCard").sentence().contains("2.0 mm"));
        QVERIFY(cardButton("Outer")->isChecked());
        const double outer = document().garment()->pieces[0]->mesh.V.col(2).maxCoeff();
        QTest::mouseClick(cardButton("Inner"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!card().isVisible());
        QVERIFY(fixture_.action(ActionId::ReadInner).isChecked());
        const double inner = document().garment()->pieces[0]->mesh.V.col(2).maxCoeff();
        QVERIFY(std::abs(std::abs(outer - inner) - 2) < 1e-9);
        QCOMPARE(document().history().undoText(), QString("Change import options"));
        fixture_.action(ActionId::ReadSheet).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().garment()->pieces[0]->defect->code, ErrorCode::ClosedSurface);
        QVERIFY(document().scene()->garmentLines.leftOut.empty());
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(!document().garment()->pieces[0]->defect);
    }

    void halfAGarmentIsCompleted() {
        QVERIFY(fixture_.openAndWait(fixture_.path("half.obj")));
        QVERIFY(card().isVisible());
        QVERIFY(card().sentence().contains("1.20 m"));
        QVERIFY(cardButton("Leave unchanged")->isChecked());
        const double width = document().scene()->box.sizes().x();
        QTest::mouseClick(cardButton("Complete"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!card().isVisible());
        QVERIFY(fixture_.action(ActionId::CompleteHalf).isChecked());
        QVERIFY(std::abs(document().scene()->box.sizes().x() - 2 * width) < 1e-6);
        QVERIFY(fixture_.find<QToolButton>("garmentSummary").toolTip().contains("Half a garment"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(std::abs(document().scene()->box.sizes().x() - width) < 1e-9);
        QVERIFY(!fixture_.action(ActionId::CompleteHalf).isChecked());
        QTest::mouseClick(cardButton("Leave unchanged"), Qt::LeftButton);
        QVERIFY(!card().isVisible());
        // What else is said of the file stays.
        fixture_.action(ActionId::CompleteHalf).trigger();
        fixture_.action(ActionId::ReadSheet).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(fixture_.action(ActionId::ReadSheet).isChecked());
        QVERIFY(document().garment()->files[0]->reading.half->isCompleted);
        // Another garment is another matter.
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        QVERIFY(!fixture_.action(ActionId::CompleteHalf).isChecked());
        QVERIFY(fixture_.action(ActionId::ReadAuto).isChecked());
    }

    void aSolidIsOfferedCuts() {
        QVERIFY(fixture_.openAndWait(fixture_.path("cushion.obj")));
        QCOMPARE(document().garment()->files[0]->reading.kind, FileKind::Solid);
        QVERIFY(document().garment()->pieces[0]->defect);
        QVERIFY(card().isVisible());
        QTest::mouseClick(cardButton("Cut open"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!document().loading().seams.cuts.empty(), test::kPatience);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!document().garment()->pieces[0]->defect);
        QVERIFY2(!card().isVisible(), qPrintable(card().sentence()));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(card().isVisible());
        QTest::mouseClick(cardButton("Leave unchanged"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!card().isVisible());
        QCOMPARE(fixture_.workspace().loading().preparing.as, std::optional(FileKind::Solid));
    }

    void whatIsNoShellIsNotReadAsOne() {
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        const int pieces = document().pieceCount();
        fixture_.action(ActionId::ReadMiddle).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), pieces);
        QCOMPARE(document().garment()->files[0]->problems.back().code, ErrorCode::CannotReadAs);
    }

    void menuDividesAgain() {
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        QVERIFY(fixture_.action(ActionId::SplitAuto).isChecked());
        QCOMPARE(document().pieceCount(), 2);
        fixture_.action(ActionId::Weld).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(fixture_.workspace().loading().weld);
        QCOMPARE(document().pieceCount(), 2);  // islands stay apart
        fixture_.action(ActionId::CloseSlits).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(fixture_.workspace().loading().closeSlits);
        QVERIFY(fixture_.action(ActionId::CloseSlits).isChecked());
        QCOMPARE(document().pieceCount(), 2);
        fixture_.action(ActionId::SplitComponents).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 1);
        QVERIFY(fixture_.action(ActionId::SplitComponents).isChecked());
        QVERIFY(!fixture_.action(ActionId::SplitAuto).isChecked());
        QVERIFY(summary().endsWith("1 piece by connected parts"));
        fixture_.action(ActionId::SplitGroups).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 2);
        QVERIFY(summary().endsWith("2 pieces by groups"));
    }

    void aReadingThatFailsLeavesTheMenuAsTheGarmentWasRead() {
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        QFile::copy(fixture_.path("sure.obj"), fixture_.path("gone.obj"));
        QVERIFY(fixture_.openAndWait(fixture_.path("gone.obj")));
        QVERIFY(QFile::remove(fixture_.path("gone.obj")));
        fixture_.action(ActionId::UnitMetre).trigger();  // of what was read
        QTRY_VERIFY_WITH_TIMEOUT(!fixture_.workspace().jobs().isBusy(), test::kPatience);
        QVERIFY(fixture_.action(ActionId::UnitMetre).isChecked());
        QCOMPARE(document().garment()->files[0]->unit, LengthUnit::Metre);
        const test::Moment before = test::momentOf(document());
        fixture_.workspace().reload();
        QTRY_VERIFY_WITH_TIMEOUT(!fixture_.workspace().jobs().isBusy(), test::kPatience);
        QVERIFY(test::momentOf(document()) == before);
        QVERIFY(fixture_.action(ActionId::UnitMetre).isChecked());
    }

    void aCutIsListedTakenBackAndWritten() {
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        QVERIFY(!fixture_.action(ActionId::SeamsToFile).isEnabled());
        SeamsFile seams;
        seams.cuts = {{"dart", UserCut::Kind::Dart, {{100, 0, 0}, {100, 200, 0}}, false},
                      {"across", UserCut::Kind::Path, {{0, 220, 0}, {300, 220, 0}}, true}};
        LoadOptions loading = fixture_.workspace().loading();
        loading.seams = seams;
        fixture_.workspace().setLoading(loading);
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 3);
        fixture_.action(ActionId::GoToSeams).trigger();
        auto& table = fixture_.find<QTreeWidget>("cutTable");
        QCOMPARE(table.topLevelItemCount(), 2);
        table.setCurrentItem(table.findItems("across", Qt::MatchExactly).front());
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_Delete);
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 2);
        QCOMPARE(document().garment()->cuts.size(), std::size_t(1));
        const auto path = fixture_.path("kept.seams.json").toStdU16String();
        QVERIFY(fixture_.workspace().cuts().writeSeams(path).ok());
        const auto kept = readSeamsFile(path);
        QVERIFY(kept.ok());
        QCOMPARE(kept->cuts.size(), std::size_t(1));
        QCOMPARE(kept->cuts[0].name, std::string("dart"));
    }

    void referencePanelsAreThereWhereTheFileHasThem() {
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        QAction& action = fixture_.action(ActionId::ReferencePanels);
        QVERIFY(action.isEnabled() && !action.isChecked());
        const Scene& scene = *document().scene();
        QCOMPARE(scene.patternLines.reference.size(), std::size_t(2));
        // A flat panel flattens to itself: the outline lies on the piece's, closed.
        const VertexRun run = scene.patternLines.reference[0];
        const auto& first = scene.lineVertices[run.first];
        const auto& last = scene.lineVertices[run.first + run.count - 1];
        QCOMPARE(first.flat[0], last.flat[0]);
        QVERIFY(std::abs(last.along - 2 * (300 + 440)) < 0.1F);
        Eigen::AlignedBox2d box;
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            const auto& flat = scene.lineVertices[i].flat;
            box.extend(Eigen::Vector2d(double(flat[0]), double(flat[1])));
        }
        QVERIFY((box.min() - scene.pieces[0].flatBox.min()).norm() < 0.1);
        QVERIFY((box.max() - scene.pieces[0].flatBox.max()).norm() < 0.1);

        const QImage without = fixture_.patternPicture();
        action.trigger();
        QVERIFY(document().view().referencePanels);
        QVERIFY(fixture_.patternPicture() != without);
        const auto& table = fixture_.find<QTreeView>("pieceTable");
        QVERIFY(!table.isColumnHidden(PiecesModel::ReferenceRms));
        QCOMPARE(table.model()->index(0, PiecesModel::ReferenceRms).data().toString(),
                 QString("0.00"));

        test::writeObj(fixture_.path("plain.obj").toStdString(),
                       {{"strip", test::makeSheet(300, 400, 4, 4)}});
        QVERIFY(fixture_.openAndWait(fixture_.path("plain.obj")));
        QVERIFY(!action.isEnabled());
        QVERIFY(table.isColumnHidden(PiecesModel::ReferenceMax));

        // A pattern file that is opened goes before the file's own panels.
        const auto pattern = fixture_.path("strip.svg").toStdU16String();
        fixture_.workspace().exportTo(pattern);
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(fixture_.openAndWait(fixture_.path("sure.obj")));
        fixture_.workspace().openReference(pattern);
        QTRY_VERIFY_WITH_TIMEOUT(document().reference(), test::kPatience);
        for (int piece = 0; piece < document().pieceCount(); ++piece) {
            const auto fit = document().referenceFit(piece);
            QVERIFY(document().result(piece)->quality->reference);
            QVERIFY(!fit || fit->max > 1);
        }
    }
};

TOILE_WINDOW_TEST(GarmentReadingTest)
#include "garment_reading_test.moc"
