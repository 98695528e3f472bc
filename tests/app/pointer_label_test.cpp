// SPDX-License-Identifier: GPL-3.0-or-later
// What is written at the pointer and of what is selected, and that it can be read.
#include <QScreen>
#include <QSet>
#include <QToolTip>
#include <algorithm>

#include "app/settings/length_display.h"
#include "app/views/colour_bar.h"
#include "app/views/ruler.h"
#include "app/views/sewn_run.h"
#include "core/seam/seam_measure.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/pointer_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;
using test::countPixels;

class PointerLabelTest : public test::PointerBench {
    Q_OBJECT

private slots:
    void theLabelTellsWhatIsUnderThePointer() {
        const int seam = firstSeam();
        const Seam& sewn = document().garment()->seams.seams[std::size_t(seam)];
        moveTo(patternView(), onPatternSeam(seam, 0));
        QVERIFY(label(patternView()).isVisible());
        const QString text = label(patternView()).text();
        QVERIFY2(text.startsWith(QString::fromStdString(sewn.name)), qPrintable(text));
        QVERIFY2(text.contains(QString::number(sewn.length3d[0], 'f', 1) + " / " +
                               QString::number(sewn.length3d[1], 'f', 1) + " mm"),
                 qPrintable(text));
        QVERIFY2(text.contains("Δ"), qPrintable(text));

        moveTo(patternView(), onPatternPiece(0));
        QVERIFY(label(patternView()).text().startsWith("narrow · "));
        QVERIFY(label(patternView()).text().endsWith(" cm²"));
        moveTo(patternView(), {3, patternView().height() - 90.0});
        QVERIFY(!label(patternView()).isVisible());
        QVERIFY(!document().hover());
    }

    void theLabelLeavesNoPictureOfItselfBehind() {
        // On the screen: what the view itself draws is not what a person sees.
        QWidget& view = patternView();
        const QColor ground = QToolTip::palette().color(QPalette::ToolTipBase);
        const auto screenshot = [&]() -> QImage {
            return fixture_.window().screen()->grabWindow(fixture_.window().winId()).toImage();
        };
        const auto labelPixels = [&] { return countPixels(screenshot(), ground, 0); };
        const auto isThere = [&] {
            const QPoint corner = label(view).mapTo(&fixture_.window(), QPoint(3, 3));
            return screenshot().pixelColor(corner) == ground;
        };
        const int before = labelPixels();
        const QPointF middle = onPatternPiece(0);
        const auto onPiece = [&](double y) { return middle + QPointF(0, y); };
        moveTo(view, onPiece(-60));
        QTRY_VERIFY_WITH_TIMEOUT(isThere(), test::kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(labelPixels() > before + 200, test::kPatience);
        const int one = labelPixels() - before;
        for (const double y : {-20.0, 20.0, 60.0}) {
            moveTo(view, onPiece(y));
            QVERIFY(label(view).isVisible());
            QTRY_VERIFY_WITH_TIMEOUT(isThere(), test::kPatience);
            QTRY_VERIFY2_WITH_TIMEOUT(labelPixels() - before <= 1.2 * one,
                                      "one label, at the pointer", test::kPatience);
        }
        leave(view);
        QTRY_COMPARE_WITH_TIMEOUT(labelPixels(), before, test::kPatience);
    }

    void theLabelDoesNotStayWhereTheCameraMoves() {
        const auto isGone = [&](QWidget& view) {
            return !label(view).isVisible() && !document().hover();
        };
        const auto point = [&] {
            moveTo(patternView(), onPatternPiece(0));
            return label(patternView()).isVisible();
        };
        QVERIFY(point());
        fixture_.action(ActionId::Frame).trigger();
        QVERIFY(isGone(patternView()));
        QVERIFY(point());
        fixture_.window().resize(fixture_.window().size() - QSize(120, 60));
        QTRY_VERIFY_WITH_TIMEOUT(isGone(patternView()), test::kPatience);
        moveTo(garmentView(), garmentView().rect().center());
        QVERIFY(label(garmentView()).isVisible());
        garmentView().look(ViewKey::Opposite);
        QVERIFY(isGone(garmentView()));
        // The wheel turns where the pointer is: what is there now is told.
        (void)fixture_.patternPicture();
        QVERIFY(point());
        zoomIn(patternView(), 40);
        const auto there = patternView().hitAt(patternView().rect().center());
        QVERIFY(there ? label(patternView()).isVisible() : isGone(patternView()));
    }

    void theLabelTellsTheOverlaysValueAsTheBarDoes() {
        const auto& bar = fixture_.find<ColourBar>("colourBar");
        const auto tellsTheSame = [&](QWidget& view) {
            return !bar.valueText().isEmpty() && label(view).text().contains(bar.valueText());
        };
        const QPointF middle = onPatternPiece(0);
        fixture_.action(overlayAction(Overlay::Area)).trigger();
        QSet<QString> texts;
        for (int i = -5; i <= 5; ++i) {
            moveTo(patternView(), middle + QPointF(0, 20 * i));
            if (document().hover() && document().hover()->kind == Feature::Kind::Piece) {
                QVERIFY2(tellsTheSame(patternView()), qPrintable(label(patternView()).text()));
                texts << label(patternView()).text();
            }
        }
        QVERIFY2(texts.size() > 1, "it is another value at another place");
        moveTo(patternView(), middle);
        QVERIFY(!label(patternView()).text().contains("limit"));  // no fabric limits areas
        DocumentState next = document().state();
        next.fabric = *fabricPreset("woven");
        document().edit("Fabric", std::move(next));
        fixture_.action(overlayAction(Overlay::Warp)).trigger();
        QVERIFY(tellsTheSame(patternView()));
        QVERIFY(label(patternView()).text().contains("Strain along warp"));
        QVERIFY(label(patternView()).text().contains("(limit "));
        moveTo(garmentView(), garmentView().rect().center());
        QVERIFY(tellsTheSame(garmentView()));
        fixture_.action(overlayAction(Overlay::Checker)).trigger();
        QVERIFY(label(garmentView()).text().endsWith("cm²"));

        // From near by, of a vertex.
        fixture_.action(overlayAction(Overlay::Area)).trigger();
        const int face = static_cast<int>(document().garment()->pieces[0]->mesh.F.rows() / 2);
        const auto near = [&](double share) {
            return *patternView().onScreen(0, face,
                                           Eigen::Vector3d(1 - share, share / 2, share / 2));
        };
        const auto corner = [&] { return near(0.005); };
        for (int i = 0; i < 20; ++i) {
            QWheelEvent event(corner(), patternView().mapToGlobal(corner()), {}, {0, 120},
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&patternView(), &event);
        }
        moveTo(patternView(), near(0.01));
        QVERIFY(document().hover());
        QCOMPARE(document().hover()->kind, Feature::Kind::Vertex);
        QVERIFY2(tellsTheSame(patternView()), qPrintable(label(patternView()).text()));
        QVERIFY(label(patternView()).text().contains("Area change"));
        const QString atVertex = bar.valueText();
        moveTo(patternView(), near(0.002));
        QCOMPARE(document().hover()->kind, Feature::Kind::Vertex);
        QCOMPARE(bar.valueText(), atVertex);
    }

    void verticesAreNamedWhereTheyAreSeenApart() {
        const Piece& piece = *document().garment()->pieces[0];
        const int middle = static_cast<int>(piece.mesh.F.rows() / 2);
        const auto corner = [&] {
            return *patternView().onScreen(0, middle, Eigen::Vector3d(0.995, 0.003, 0.002));
        };
        for (int i = 0; i < 20; ++i) {  // nearer, with the wheel
            QWheelEvent event(corner(), patternView().mapToGlobal(corner()), {}, {0, 120},
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&patternView(), &event);
        }
        moveTo(patternView(), corner());
        QVERIFY(document().hover());
        QCOMPARE(document().hover()->kind, Feature::Kind::Vertex);
        QCOMPARE(document().hover()->vertex, piece.mesh.F(middle, 0));
        const QString text = label(patternView()).text();
        QVERIFY2(text.startsWith("Vertex ") && text.contains("strain"), qPrintable(text));
        QVERIFY(highlightedInPattern() > 10);
        QVERIFY(highlightedInGarment() > 10);
        click(patternView(), corner());
        QVERIFY(document().mark());
        QCOMPARE(document().mark()->vertex, piece.mesh.F(middle, 0));
    }

    void theLabelFollowsWhatItTells() {
        moveTo(patternView(), onPatternSeam(firstSeam(), 0));
        QVERIFY(label(patternView()).text().contains(" mm"));
        LengthDisplay::instance().choose(LengthUnit::Inch);
        const QString inches = label(patternView()).text();
        LengthDisplay::instance().choose(LengthUnit::Millimetre);
        QVERIFY2(inches.contains(" in"), qPrintable(inches));
        QVERIFY(!label(patternView()).text().contains("in 3D"));
        test::setResults(document(), PieceResults(2), document().scene());
        QVERIFY(label(patternView()).text().contains("in 3D"));  // nothing is flat
    }

    void aStretchIsSewnToWhatLiesOnIt() {
        const Garment& garment = *document().garment();
        const int seam = firstSeam();
        const Seam& sewn = garment.seams.seams[std::size_t(seam)];
        const auto places = [&](const Feature& run) {
            const Piece& piece = *garment.pieces[std::size_t(run.piece)];
            std::vector<Eigen::Vector3d> points;
            for (int k = run.first; k <= run.first + run.count; ++k) {
                const std::size_t at = std::size_t(k) % piece.boundary.size();
                points.emplace_back(piece.mesh.V.row(piece.boundary[at]));
            }
            return points;
        };
        for (const SeamSide* side : {&sewn.left, &sewn.right}) {
            const int size =
                static_cast<int>(garment.pieces[std::size_t(side->piece)]->boundary.size());
            Feature run;
            run.kind = Feature::Kind::Run;
            run.piece = side->piece;
            run.first = (side->first + 1) % size;
            run.count = 2;
            const auto parts = sewnParts(garment, run);
            QCOMPARE(parts.size(), std::size_t{1});
            QCOMPARE(parts[0].seam, seam);
            QVERIFY(!parts[0].whole);
            QVERIFY(!seamOfRun(garment, run));
            document().setMark(run);
            const auto lit = markedFeatures(document());
            QCOMPARE(lit.size(), std::size_t{2});
            QCOMPARE(lit[1].count, 2);
            // The parts of the cap have the same vertices along the line between them.
            auto here = places(lit[0]), there = places(lit[1]);
            std::ranges::reverse(there);
            for (std::size_t i = 0; i < here.size(); ++i) {
                QVERIFY((here[i] - there[i]).norm() < 1e-3);
            }
            const RunLengths lengths = runLengths(garment, document().results(), run);
            QVERIFY(lengths.flat);
            QVERIFY(lengths.sewn > 0 && lengths.free < 1e-6);
            QVERIFY(std::abs(lengths.sewn - lengths.partner) < 1e-3 * lengths.sewn);

            run.first = side->first % size;
            run.count = side->count;
            QCOMPARE(seamOfRun(garment, run), std::optional(seam));
            const RunLengths all = runLengths(garment, document().results(), run);
            const auto measure = measureSeam(sewn, *garment.pieces[std::size_t(sewn.left.piece)],
                                             *document().result(sewn.left.piece)->flat,
                                             *garment.pieces[std::size_t(sewn.right.piece)],
                                             *document().result(sewn.right.piece)->flat);
            const bool left = side == &sewn.left;
            QVERIFY(std::abs(all.sewn - (left ? measure.length2dLeft : measure.length2dRight)) <
                    1e-6);
            QVERIFY(std::abs(all.partner - (left ? measure.length2dRight : measure.length2dLeft)) <
                    1e-6);
            // The whole outline: some of it is a hem.
            run.first = 0;
            run.count = size;
            QVERIFY(runLengths(garment, document().results(), run).free > 1);
        }
    }

    void theCaptionHasAPlateOverTheCloth() {
        const auto beside = [&](const QImage& image, int x) {
            return image.pixelColor(QPoint(kRulerBreadth + x, kRulerBreadth + 21));
        };
        constexpr int kInside = 9, kOutside = 3;  // of the label, left of the words
        const auto difference = [&](const QImage& image) {
            const QColor a = beside(image, kInside), b = beside(image, kOutside);
            return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                   std::abs(a.blue() - b.blue());
        };
        QVERIFY(difference(fixture_.patternPicture()) < 12);
        const QPointF at = onPatternPiece(1);
        for (int i = 0; i < 30; ++i) {
            QWheelEvent event(at, patternView().mapToGlobal(at), {}, {0, 120}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&patternView(), &event);
        }
        document().setView(&ViewState::grid, false);
        QVERIFY(patternView().hitAt({kRulerBreadth + 9.0, kRulerBreadth + 21.0}));
        QVERIFY(difference(fixture_.patternPicture()) > 30);
    }
};

TOILE_WINDOW_TEST(PointerLabelTest)
#include "pointer_label_test.moc"
