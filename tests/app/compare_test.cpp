// SPDX-License-Identifier: GPL-3.0-or-later
// The window that compares methods: its figures, its pictures, and how it follows the document.
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/compare/compare_window.h"
#include "app/render/scene.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/views/colour_bar.h"
#include "core/toile/pipeline.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

namespace {

using Stage = MethodComparison::Stage;

/// Below the cloth, where the scale bar is.
constexpr int kScaleBarRows = 44;

/// A sheet that is raised in the middle, fine enough to keep a solver busy.
MeshArrays makeHill(int columns) {
    MeshArrays mesh = test::makeSheet(200, 200, columns, columns);
    for (Eigen::Index i = 0; i < mesh.V.rows(); ++i) {
        const double x = (mesh.V(i, 0) - 100) / 60, y = (mesh.V(i, 1) - 100) / 60;
        mesh.V(i, 2) = 60 * std::exp(-x * x - y * y);
    }
    return mesh;
}

/// A deep, narrow bag with one opening. The angles of ABF find no solution there.
MeshArrays makeBag() {
    constexpr int kAround = 6, kRings = 60;
    MeshArrays mesh;
    mesh.V.resize(kAround * kRings + 1, 3);
    mesh.F.resize(kAround * (2 * kRings - 1), 3);
    Eigen::Index face = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2 * std::numbers::pi * i / kAround;
            const int here = ring * kAround + i, next = ring * kAround + (i + 1) % kAround;
            mesh.V.row(here) << 5 * std::cos(angle), 5 * std::sin(angle), 10 * ring;
            if (ring + 1 < kRings) {
                mesh.F.row(face++) << here, next, next + kAround;
                mesh.F.row(face++) << here, next + kAround, here + kAround;
            } else {
                mesh.F.row(face++) << here, next, kAround * kRings;
            }
        }
    }
    mesh.V.row(kAround * kRings) << 0, 0, 10 * kRings;
    return mesh;
}

/// Around what is not backdrop, device pixels.
QRect clothIn(const QImage& picture) {
    QRect found;
    for (int y = 4; y < picture.height() - kScaleBarRows; ++y) {
        const QColor backdrop = picture.pixelColor(4, y);
        for (int x = 5; x < picture.width() - 4; ++x) {
            const QColor pixel = picture.pixelColor(x, y);
            if (std::abs(pixel.red() - backdrop.red()) +
                    std::abs(pixel.green() - backdrop.green()) +
                    std::abs(pixel.blue() - backdrop.blue()) >
                24) {
                found |= QRect(x, y, 1, 1);
            }
        }
    }
    return found;
}

}  // namespace

class CompareTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("sewn.obj").toStdString(), test::sewnCapParts());
        test::writeObj(fixture_.path("sheet.obj").toStdString(),
                       {{"sheet", test::makeSheet(200, 100, 8, 4)}});
        test::writeObj(fixture_.path("hill.obj").toStdString(), {{"hill", makeHill(60)}});
        test::writeObj(fixture_.path("closed.obj").toStdString(),
                       {{"closed", test::makeTetrahedron(100)}, {"cap", test::makeCap(300)}});
        test::writeObj(fixture_.path("bag.obj").toStdString(), {{"bag", makeBag()}});
    }

    void init() { fixture_.open(); }
    void cleanup() { fixture_.close(); }

    void figuresAreThoseOfTheCore() {
        openAndCompare("sewn.obj");
        const std::vector<Method> methods{Method::Isometric, Method::Curvature, Method::Wang2005,
                                          Method::Lscm};
        Progress progress;
        const Comparison expected =
            compareMethods(*document().garment(), methods, document().options(), progress);
        QCOMPARE(table().model()->columnCount(), 4);
        const auto shown = std::ranges::count_if(
            allCriteria(), [](const CriterionTraits& criterion) { return criterion.title; });
        // Three rows of widgets, and no reference panel.
        QCOMPARE(table().model()->rowCount(), 3 + static_cast<int>(shown) - 1);
        for (int m = 0; m < 4; ++m) {
            const ComparedMethod& method = expected.methods[static_cast<std::size_t>(m)];
            const ComparedFigures& figures = method.pieceFigures.front();
            const PieceQuality& quality = *method.results.front()->quality;
            QCOMPARE(box(m).currentText(), methodName(method.method));
            QCOMPARE(cell("Mean strain, %", m), percent(*quality.strainMeanAbs));
            QCOMPARE(cell("Max. stretch, %", m), signedPercent(*quality.strainMax));
            QCOMPARE(cell("Max. surplus, %", m), signedPercent(*quality.strainMin));
            QCOMPARE(cell("Seam Δ, mm", m), fineLength(*figures[Criterion::SeamMismatch]));
            QCOMPARE(cell("Outline length error, %", m),
                     boundaryError(*figures[Criterion::LengthError]));
            QCOMPARE(cell("Area error, %", m), percent(*figures[Criterion::PiA]));
            QCOMPARE(cell("Flipped triangles", m),
                     QString::number(*figures[Criterion::FlippedTriangles]));
            QCOMPARE(cell("Outline crossings", m),
                     QString::number(*figures[Criterion::OutlineCrossings]));
            QVERIFY(!cell("Time, ms", m).isEmpty());
        }
        // A free outline does not fit the piece beside it; the others do.
        QVERIFY(cell("Seam Δ, mm", 3) != cell("Seam Δ, mm", 0));
    }

    void whatTheDocumentKnowsIsTakenOver() {
        openAndCompare("sewn.obj");
        QCOMPARE(entry(0).method, Method::Isometric);
        QCOMPARE(entry(0).made.result.get(), document().result(0));
    }

    void theBestOfARowIsBoldAndHasAStar() {
        openAndCompare("sewn.obj");
        const QAbstractItemModel& model = *table().model();
        int marked = 0;
        for (int row = 3; row < model.rowCount(); ++row) {
            int best = 0;
            for (int column = 0; column < 4; ++column) {
                const QModelIndex index = model.index(row, column);
                const bool bold = index.data(Qt::FontRole).value<QFont>().bold();
                QCOMPARE(index.data().toString().startsWith(QChar(0x2605)), bold);
                QCOMPARE(index.data(Qt::AccessibleTextRole).toString().contains("best"), bold);
                best += bold;
            }
            QVERIFY(best < 4);  // where all are alike nothing is marked
            marked += best;
        }
        QVERIFY(marked > 0);
        QVERIFY(model.index(rowOf("Mean strain, %"), 0).data(Qt::FontRole).value<QFont>().bold());
        QVERIFY(!model.index(rowOf("Flipped triangles"), 0).data(Qt::FontRole).isValid());
    }

    void picturesHaveOneScaleAndMoveTogether() {
        document().setView(&ViewState::grid, false);
        openAndCompare("sheet.obj");
        const auto extents = [this] {
            std::vector<QRect> found;
            for (int i = 0; i < 4; ++i) {
                found.push_back(clothIn(picture(i).grabFramebuffer()));
            }
            return found;
        };
        const double ratio = picture(0).devicePixelRatioF();
        const auto expected = [&](double millimetres) {
            return millimetres * ratio *
                   window().camera().seenIn(picture(0).size()).pixelsPerMillimetre();
        };
        // The reader may have taken the file's numbers for another unit.
        const Eigen::Vector2d size = entry(0).made.scene->pieces.front().flatBox.sizes();
        QVERIFY(std::abs(size.x() - 2 * size.y()) < 1e-3 * size.x());
        const std::vector<QRect> before = extents();
        for (const QRect& cloth : before) {
            QVERIFY(std::abs(cloth.width() - expected(size.x())) <= 3);  // the outline's own width
            QVERIFY(std::abs(cloth.height() - expected(size.y())) <= 3);
            QVERIFY(std::abs(cloth.width() - before.front().width()) <= 1);
            QVERIFY(std::abs(cloth.height() - before.front().height()) <= 1);
        }
        const QPointF middle = QRectF(picture(2).rect()).center();
        test::turnWheel(picture(2), middle, -3);
        const std::vector<QRect> zoomed = extents();
        for (const QRect& cloth : zoomed) {
            QVERIFY(cloth.width() < before.front().width() - 20);
            QVERIFY(std::abs(cloth.width() - zoomed.front().width()) <= 1);
        }
        test::drag(picture(1), {60, 60}, {75, 60});
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(std::abs(extents()[i].left() - zoomed[i].left() - 15 * ratio) <= 1);
        }
        QTest::mouseDClick(&picture(3), Qt::LeftButton);
        QCOMPARE(extents().front(), before.front());
    }

    void picturesShareTheColoursOfTheOverlay() {
        openAndCompare("sewn.obj");
        auto& legend = *window().findChild<ColourBar*>("compareLegend");
        // The checkerboard of the main window says nothing here: strain stands in for it.
        QVERIFY(legend.summary().startsWith("Edge strain"));
        document().setOverlay(Overlay::Area);
        double most = 0;
        for (const auto& entry : window().comparison().entries()) {
            most = std::max(most, entry.made.scene->scale(Overlay::Area).high);
        }
        QVERIFY(legend.summary().startsWith("Area change"));
        QVERIFY2(legend.summary().contains(QString("+%1 %").arg(most)),
                 qPrintable(legend.summary()));
    }

    void methodsAreChosenPerColumn() {
        openAndCompare("sewn.obj");
        QCOMPARE(entry(3).method, Method::Lscm);
        const auto solved = entry(1).made.result;
        box(3).setFocus();
        QTest::keyClick(&box(3), Qt::Key_Home);
        QVERIFY(waitUntilDone());
        const auto first = static_cast<Method>(box(3).itemData(0).toInt());
        QCOMPARE(entry(3).method, first);
        QCOMPARE(entry(3).made.result->options.method, first);
        QCOMPARE(entry(1).made.result, solved);  // the other columns were not solved again
        QVERIFY(picture(3).isVisible());
    }

    void thePieceFollowsTheSelection() {
        openAndCompare("sewn.obj");
        const auto shown = [this] {
            return table().model()->headerData(0, Qt::Vertical).toString();
        };
        QCOMPARE(shown(), QString("narrow"));
        for (const int piece : {1, 0}) {
            document().setSelection({piece});
            QTRY_COMPARE_WITH_TIMEOUT(window().comparison().piece(), piece, test::kPatience);
            QVERIFY(waitUntilDone());
            QCOMPARE(shown(), QString(piece == 1 ? "wide" : "narrow"));
            QCOMPARE(entry(1).made.result->piece,
                     document().garment()->pieces[static_cast<std::size_t>(piece)]);
        }
    }

    void aMethodIsTakenOverAsOneStep() {
        openAndCompare("sewn.obj");
        QVERIFY(!button("compareUse0").isEnabled());
        const auto kept = entry(2).made.result;
        const int steps = document().history().count();
        QTest::mouseClick(&button("compareUse2"), Qt::LeftButton);
        QCOMPARE(document().options().method, Method::Wang2005);
        QCOMPARE(document().history().count(), steps + 1);
        QVERIFY(!button("compareUse2").isEnabled());
        QVERIFY(button("compareUse0").isEnabled());
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().result(0)->options.method, Method::Wang2005);
        QVERIFY(waitUntilDone());
        QCOMPARE(entry(2).made.result, kept);  // nothing was solved again
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().options().method, Method::Isometric);
        QVERIFY(!button("compareUse0").isEnabled());
    }

    void figuresAreCopied() {
        openAndCompare("sewn.obj");
        table().setFocus();
        table().clearSelection();
        QStringList lines;
        // The clipboard is the display's: another program may fill it between two calls.
        const auto copied = [&] {
            QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
            lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
            return lines.size();
        };
        QTRY_COMPARE_WITH_TIMEOUT(copied(), qsizetype(table().model()->rowCount() - 3 + 1),
                                  test::kPatience);
        for (const QString& line : lines) {
            QCOMPARE(line.count('\t'), qsizetype(4));
        }
        QCOMPARE(lines[1].section('\t', 0, 1),
                 "Mean strain, %\t" + percent(*document().result(0)->quality->strainMeanAbs));
        table().selectRow(rowOf("Seam Δ, mm"));
        QTRY_COMPARE_WITH_TIMEOUT(copied(), qsizetype(2), test::kPatience);
        QVERIFY(lines[1].startsWith("Seam Δ, mm\t"));
    }

    void anotherMethodStopsTheOneInWork() {
        QVERIFY(fixture_.openAndWait(fixture_.path("hill.obj")));
        openCompareWindow();
        QCOMPARE(entry(0).stage, Stage::Working);
        const Method dropped = entry(0).method;
        box(0).setCurrentIndex(box(0).findData(static_cast<int>(Method::Curvature)));
        emit box(0).activated(box(0).currentIndex());
        QVERIFY(waitUntilDone());
        for (const auto& entry : window().comparison().entries()) {
            QVERIFY(entry.method != dropped);
            QCOMPARE(entry.stage, Stage::Done);
            QCOMPARE(entry.made.result->options.method, entry.method);
        }
    }

    void aChangeWhileItWorksIsComparedAgain() {
        QVERIFY(fixture_.openAndWait(fixture_.path("hill.obj")));
        openCompareWindow();
        QCOMPARE(entry(0).stage, Stage::Working);
        workspace().setQuality(Quality::Draft);
        QTRY_VERIFY_WITH_TIMEOUT(entry(0).stage == Stage::Done &&
                                     entry(0).made.result->options.quality == Quality::Draft,
                                 test::kPatience);
        QVERIFY(waitUntilDone());
        for (const auto& entry : window().comparison().entries()) {
            QCOMPARE(entry.made.result->options.quality, Quality::Draft);
        }
        // The document's own flattening was neither stopped nor done twice.
        QCOMPARE(document().result(0)->options, document().options());
        QCOMPARE(entry(0).made.result.get(), document().result(0));
    }

    void easeChangesTheFiguresAlone() {
        openAndCompare("sewn.obj");
        const auto solved = entry(3).made.result;
        const QString before = cell("Seam Δ, mm", 0);
        int seam = 0;
        while (document().garment()->seams.seams[std::size_t(seam)].kind == SeamKind::Free) {
            ++seam;
        }
        document().setSeamEase(seam, 0.1);
        QTRY_VERIFY_WITH_TIMEOUT(
            cell("Seam Δ, mm", 0) != before && !cell("Seam Δ, mm", 3).isEmpty(), test::kPatience);
        QCOMPARE(entry(3).made.result, solved);
    }

    void closingStopsAndResets() {
        QVERIFY(fixture_.openAndWait(fixture_.path("hill.obj")));
        openCompareWindow();
        QVERIFY(window().comparison().isBusy());
        QTest::keyClick(&window(), Qt::Key_Escape);
        QVERIFY(!window().isVisible());
        QVERIFY(window().comparison().entries().empty());
        document().setSelection({0});
        workspace().setQuality(Quality::Draft);  // is not followed any more
        QVERIFY(window().comparison().entries().empty());
        compare();
        QVERIFY(waitUntilDone());
        QCOMPARE(entry(3).stage, Stage::Done);
    }

    void aPieceThatCannotBeFlatSaysWhy() {
        openAndCompare("closed.obj");
        // The first that is flat was chosen.
        QCOMPARE(window().comparison().piece(), 1);
        document().setSelection({0});
        QTRY_COMPARE_WITH_TIMEOUT(window().comparison().piece(), 0, test::kPatience);
        QVERIFY(waitUntilDone());
        for (int i = 0; i < 4; ++i) {
            QVERIFY(entry(i).made.result->error);
            QCOMPARE(label(qPrintable(QString("compareMessage%1").arg(i))).text(),
                     errorText(*entry(i).made.result->error));
            QVERIFY(!picture(i).isVisible());
            QCOMPARE(cell("Mean strain, %", i), QString(QChar(0x2013)));
        }
    }

    void aFailedMethodLeavesTheOthers() {
        openAndCompare("bag.obj");
        const auto solved = entry(1).made.result;
        QVERIFY(!cell("Flipped triangles", 3).isEmpty());
        box(3).setCurrentIndex(box(3).findData(static_cast<int>(Method::Abf)));
        emit box(3).activated(box(3).currentIndex());
        QVERIFY(waitUntilDone());
        const auto message = [this](int i) -> QLabel& {
            return label(qPrintable(QString("compareMessage%1").arg(i)));
        };
        const QString none(QChar(0x2013));
        QVERIFY(entry(3).made.result->error);
        QCOMPARE(message(3).text(), errorText(*entry(3).made.result->error));
        QVERIFY(message(3).isVisible());
        QVERIFY(!picture(3).isVisible());
        QCOMPARE(cell("Flipped triangles", 3), none);
        for (int i = 0; i < 3; ++i) {
            QVERIFY(entry(i).made.result->flat);
            QVERIFY(picture(i).isVisible());
            QVERIFY(!message(i).isVisible());
            QVERIFY(cell("Flipped triangles", i) != none);
        }
        QCOMPARE(entry(1).made.result, solved);
    }

private:
    void openAndCompare(const QString& file) {
        QVERIFY(fixture_.openAndWait(fixture_.path(file)));
        compare();
        QVERIFY(waitUntilDone());
    }

    /// At once: no event is handled meanwhile, so that no job can be done.
    void openCompareWindow() {
        QApplication::setActiveWindow(&fixture_.window());
        QTest::keyClick(&fixture_.window(), Qt::Key_M, Qt::ControlModifier);
    }

    void compare() {
        openCompareWindow();
        QVERIFY(QTest::qWaitForWindowExposed(&window(), test::kPatience));
        QApplication::setActiveWindow(&window());
    }

    bool waitUntilDone() {
        return QTest::qWaitFor([this] { return !window().comparison().isBusy(); },
                               4 * test::kPatience);
    }

    CompareWindow& window() { return fixture_.find<CompareWindow>("compareWindow"); }
    Document& document() { return fixture_.document(); }
    Workspace& workspace() { return fixture_.workspace(); }
    const MethodComparison::Entry& entry(int i) {
        return window().comparison().entries()[static_cast<std::size_t>(i)];
    }
    QTableView& table() { return *window().findChild<QTableView*>("compareTable"); }
    ComparedPicture& picture(int i) {
        return *window().findChild<ComparedPicture*>(QString("comparePicture%1").arg(i));
    }
    QComboBox& box(int i) {
        return *window().findChild<QComboBox*>(QString("compareMethod%1").arg(i));
    }
    QPushButton& button(const char* name) { return *window().findChild<QPushButton*>(name); }
    QLabel& label(const char* name) { return *window().findChild<QLabel*>(name); }

    int rowOf(const QString& title) {
        const QAbstractItemModel& model = *table().model();
        for (int row = 0; row < model.rowCount(); ++row) {
            if (model.headerData(row, Qt::Vertical).toString() == title) {
                return row;
            }
        }
        return -1;
    }

    QString cell(const QString& title, int column) {
        return table()
            .model()
            ->index(rowOf(title), column)
            .data(CompareWindow::PlainRole)
            .toString();
    }

    test::WindowFixture fixture_;
};

TOILE_WINDOW_TEST(CompareTest)
#include "compare_test.moc"
