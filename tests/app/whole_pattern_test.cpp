// SPDX-License-Identifier: GPL-3.0-or-later
// One garment with everything that a pattern can have, saved and opened again, and taken back.
// With TOILE_UPDATE_DOCS set, the pictures of docs/patterns.md are taken on the way.
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QPixmap>
#include <QSlider>
#include <algorithm>

#include "app/document/layout.h"
#include "app/document/line_edits.h"
#include "app/export/export_dialog.h"
#include "app/export/print_dialog.h"
#include "app/jobs/file_jobs.h"
#include "core/layout/marker.h"
#include "core/pattern/darts.h"
#include "core/pattern/extension.h"
#include "core/project/project_file.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// The T-shirt of the samples with darts, pockets, facings and turn-ups.
class WholePatternTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    const LineSettings& lines() { return document().state().lines; }
    const Pattern& pattern() { return *document().derived().pattern; }
    const std::vector<Seam>& seams() { return document().garment()->seams.seams; }

    int pieceNamed(const char* name) {
        int piece = 0;
        while (document().garment()->pieces[std::size_t(piece)]->name != name) {
            ++piece;
        }
        return piece;
    }

    bool isDone() {
        return QTest::qWaitFor(
                   [this] { return document().isFlattened() && fixture_.waitUntilIdle(); },
                   test::kPatience) &&
               fixture_.waitForResults();
    }

    void type(const char* name, const QString& text) {
        auto& field = fixture_.find<QDoubleSpinBox>(name);
        QVERIFY2(field.isEnabled(), name);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(isDone());
    }

    /// The point of a piece on the garment that is nearest to a place on its flat box, as shares of
    /// its sides.
    Eigen::Vector3d placeOn(int piece, double across, double up, bool isOnRim = false) {
        const PieceResult& result = *document().result(piece);
        const Points2& Q = result.flat->Q;
        const Eigen::RowVector2d low = Q.colwise().minCoeff(), high = Q.colwise().maxCoeff();
        const Eigen::RowVector2d wanted =
            low + Eigen::RowVector2d((high - low).cwiseProduct(Eigen::RowVector2d(across, up)));
        Eigen::Index nearest = 0;
        if (isOnRim) {
            double least = HUGE_VAL;
            for (const int vertex : result.piece->boundary) {
                if ((Q.row(vertex) - wanted).norm() < least) {
                    least = (Q.row(vertex) - wanted).norm();
                    nearest = vertex;
                }
            }
        } else {
            (Q.rowwise() - wanted).rowwise().squaredNorm().minCoeff(&nearest);
        }
        return result.piece->mesh.V.row(nearest).transpose();
    }

    int freeEdgeOf(int piece) {
        const auto found = std::ranges::find_if(seams(), [piece](const Seam& seam) {
            return seam.kind == SeamKind::Free && seam.left.piece == piece;
        });
        return static_cast<int>(found - seams().begin());
    }

    /// A picture of the pattern view, or of a part of it around a piece.
    void keep(const char* name, QWidget& widget) {
        const QString file = QString(TOILE_SOURCE_DIR "/docs/images/") + name;
        if (qEnvironmentVariableIsSet("TOILE_UPDATE_DOCS")) {
            QVERIFY(widget.grab().save(file));
        }
        QVERIFY2(!QPixmap(file).isNull(), qPrintable(file));
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj",
                            fixture_.path("tshirt.obj")));
    }

    void aPatternWithEverythingIsSavedAndTakenBack() {
        fixture_.open({1400, 900}, NewGarment::Pattern);
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        QVERIFY(fixture_.openAndWait(fixture_.path("tshirt.obj")));
        QVERIFY(isDone());
        document().setOverlay(Overlay::None);
        const DocumentState before = document().state();
        const int front = pieceNamed("front"), sleeve = pieceNamed("sleeve_left");

        UserCut dart;
        dart.kind = UserCut::Kind::Dart;
        dart.points = {placeOn(front, 0, 0.58, true), placeOn(front, 0.27, 0.66)};
        fixture_.workspace().cuts().add(dart);
        QVERIFY(isDone());
        const auto isDart = [](const Seam& seam) { return seam.kind == SeamKind::Dart; };
        QCOMPARE(std::ranges::count_if(seams(), isDart), std::ptrdiff_t(2));

        fixture_.action(ActionId::GoToLines).trigger();
        document().setSeam(
            static_cast<int>(std::ranges::find_if(seams(), isDart) - seams().begin()));
        type("dartIntake", "25");
        for (const PieceDart& one : findDarts(pattern().pieces[std::size_t(front)])) {
            QVERIFY(std::abs(one.intake - 25) < 1e-6);
        }
        document().setSeam(freeEdgeOf(front));
        type("segmentFacing", "60");
        document().setSeam(freeEdgeOf(sleeve));
        type("segmentExtension", "35");
        QCOMPARE(pattern().facings.size(), std::size_t(1));

        LineSettings withPocket = lines();
        const Garment& garment = *document().garment();
        ClothPoints pocket;
        for (const auto& [x, y] :
             {std::pair(0.58, 0.62), {0.8, 0.62}, {0.8, 0.46}, {0.69, 0.42}, {0.58, 0.46}}) {
            pocket.push_back(placeOn(front, x, y));
        }
        withPocket = withInternalLine(withPocket, garment, "pocket", pocket, true);
        withPocket =
            withInternalLine(withPocket, garment, "button", {placeOn(front, 0.69, 0.58)}, false);
        document().setLines(withPocket, "Pocket");
        QVERIFY(isDone());
        QCOMPARE(pattern().pieces[std::size_t(front)].internals.size(), std::size_t(2));
        document().setSeam({});
        fixture_.action(ActionId::LayOutAgain).trigger();
        fixture_.patternView().frameAll();
        keep("pattern-added.png", fixture_.patternView());

        const auto walked = std::ranges::find(seams(), "front / sleeve_left", &Seam::name);
        QVERIFY(walked != seams().end());
        document().setSeam(static_cast<int>(walked - seams().begin()));
        fixture_.action(ActionId::WalkSeam).trigger();
        fixture_.find<QSlider>("walkSlider").setValue(600);
        keep("pattern-walk.png", fixture_.patternView());
        QTest::keyClick(&fixture_.patternView(), Qt::Key_Escape);

        fixture_.action(ActionId::ExportPattern).trigger();
        auto& exporting = fixture_.find<ExportDialog>("exportDialog");
        QVERIFY(fixture_.waitUntilIdle());
        exporting.findChild<QLineEdit*>("exportPath")->setText("/home/me/patterns/tshirt.pdf");
        emit exporting.findChild<QLineEdit*>("exportPath")->editingFinished();
        QApplication::processEvents();  // new fields are shown then
        keep("export-dialog.png", exporting);
        exporting.reject();

        auto& dialogs = fixture_.window().garmentActions().fileDialogs();
        dialogs.hasPrinter = [] { return true; };
        fixture_.action(ActionId::PrintPattern).trigger();
        auto& printing = fixture_.find<PrintDialog>("printDialog");
        QVERIFY(QTest::qWaitFor([&] { return printing.sheets() != nullptr; }, test::kPatience));
        QApplication::processEvents();
        keep("print-dialog.png", printing);
        printing.reject();

        const LaidOutPattern laid = cutAndPlace(pattern());
        QCOMPARE(laid.pattern.pieces.size(), std::size_t(document().pieceCount()) + 1);
        const auto read = parseProject(
            projectText(projectOf(document().state(), document().derived(), document().view()),
                        "/"),
            "a.toile", "/");
        QVERIFY(read && read->project.lines == lines());
        while (document().history().canUndo()) {
            fixture_.action(ActionId::Undo).trigger();
        }
        QVERIFY(isDone());
        QVERIFY(document().state() == before);
        fixture_.close();
    }
};

TOILE_WINDOW_TEST(WholePatternTest)
#include "whole_pattern_test.moc"
