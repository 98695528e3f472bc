// SPDX-License-Identifier: GPL-3.0-or-later
// Extensions, facings, ease and notches in the form of a segment.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "app/document/line_edits.h"
#include "app/jobs/file_jobs.h"
#include "core/layout/marker.h"
#include "core/pattern/extension.h"
#include "core/project/project_file.h"
#include "core/symmetry/symmetry.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// The T-shirt of the samples, as a pattern.
class StripsTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    const LineSettings& lines() { return document().state().lines; }
    int steps() { return document().history().index(); }
    QDoubleSpinBox& field(const char* name) { return fixture_.find<QDoubleSpinBox>(name); }
    QToolButton& button(const char* name) { return fixture_.find<QToolButton>(name); }

    void type(const char* name, const QString& text) {
        field(name).setFocus();
        field(name).selectAll();
        QTest::keyClicks(&field(name), text);
        QTest::keyClick(&field(name), Qt::Key_Return);
    }

    bool isDone() {
        return QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience) &&
               fixture_.waitForResults();
    }

    /// Of a piece that mirrors another, where there is one.
    int seamOf(SeamKind kind, bool isPaired) {
        const auto& counterpart = document().derived().symmetry->pieces.counterpart;
        const auto& seams = document().garment()->seams.seams;
        const auto found = std::ranges::find_if(seams, [&](const Seam& seam) {
            const int piece = seam.left.piece;
            const int other = counterpart[static_cast<std::size_t>(piece)];
            return seam.kind == kind && (other >= 0 && other != piece) == isPaired;
        });
        return found == seams.end() ? -1 : static_cast<int>(found - seams.begin());
    }

    /// How many segments of the pattern are drawn out.
    std::ptrdiff_t drawnOut() {
        std::ptrdiff_t count = 0;
        for (const PatternPiece& piece : document().derived().pattern->pieces) {
            count += std::ranges::count_if(
                piece.segments, [](const auto& segment) { return extensionOf(segment) > 0; });
        }
        return count;
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj",
                            fixture_.path("tshirt.obj")));
    }

    void init() {
        fixture_.open({1400, 900}, NewGarment::Pattern);
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        fixture_.workspace().setMethod(Method::Curvature);  // the quickest
        QVERIFY(fixture_.openAndWait(fixture_.path("tshirt.obj")));
        QVERIFY(isDone());
        fixture_.action(ActionId::GoToLines).trigger();
    }

    void cleanup() { fixture_.close(); }

    void aFreeEdgeIsDrawnOutAndItsMirrorImageToo() {
        const int sewn = seamOf(SeamKind::Seam, true), hem = seamOf(SeamKind::Free, true);
        QVERIFY(sewn >= 0 && hem >= 0);
        document().setSeam(sewn);
        QVERIFY(!field("segmentExtension").isEnabled());
        document().setSeam(hem);
        QVERIFY(field("segmentExtension").isEnabled());
        type("segmentExtension", "25");
        QCOMPARE(steps(), 1);
        QVERIFY(isDone());
        QCOMPARE(drawnOut(), std::ptrdiff_t(2));  // both sleeves
        QVERIFY(field("segmentExtension").font().bold());
        type("segmentExtension", "0");
        QVERIFY(isDone());
        QCOMPARE(drawnOut(), std::ptrdiff_t(0));
        QVERIFY(lines() == withPattern({}));
    }

    void lessThanTheLeastIsTheLeastAndShownSo() {
        document().setSeam(seamOf(SeamKind::Free, true));
        for (const char* name : {"segmentExtension", "segmentFacing"}) {
            for (int time = 0; time < 2; ++time) {
                type(name, "0.5");
                QVERIFY(isDone());
                QCOMPARE(field(name).value(), kMinStrip);
            }
        }
        QCOMPARE(steps(), 2);
    }

    void undoIsTheDocumentsInAFieldThatSaysNone() {
        const int hem = seamOf(SeamKind::Free, true);
        document().setSeam(hem);
        type("segmentFacing", "40");
        QVERIFY(isDone());
        QCOMPARE(steps(), 1);
        field("segmentExtension").setFocus();
        QCOMPARE(field("segmentExtension").text(), field("segmentExtension").specialValueText());
        QTest::keySequence(&field("segmentExtension"), QKeySequence::Undo);
        QCOMPARE(steps(), 0);
        QVERIFY(isDone());
    }

    void theKindOfAFreeEdgeIsShownAndChosen() {
        document().setSeam(seamOf(SeamKind::Free, true));
        auto& kind = fixture_.find<QComboBox>("segmentEdge");
        QVERIFY(kind.isEnabled());
        QCOMPARE(kind.currentIndex(), 0);
        QCOMPARE(kind.itemText(0), QString("found: Hem"));
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_Down);  // the first kind is that of hems
        QVERIFY(isDone());
        QTest::keyClick(&kind, Qt::Key_Down);
        QVERIFY(isDone());
        QVERIFY(lines().segments.at(0).edge == EdgeKind::Cuff);
        QCOMPARE(field("segmentAllowance").value(), AllowanceWidths{}.widthOf(EdgeKind::Cuff));
        document().setSeam(seamOf(SeamKind::Seam, false));
        QVERIFY(!kind.isEnabled());
    }

    void aFacingIsAPieceOfItsOwnInFiles() {
        document().setSeam(seamOf(SeamKind::Free, true));
        const double hem = field("segmentAllowance").value();
        QCOMPARE(hem, AllowanceWidths{}.hem);
        type("segmentFacing", "40");
        QCOMPARE(steps(), 1);
        QVERIFY(isDone());
        QCOMPARE(field("segmentAllowance").value(), AllowanceWidths{}.seam);  // it is sewn now
        QCOMPARE(document().derived().pattern->facings.size(), std::size_t(2));
        const LaidOutPattern laid = cutAndPlace(*document().derived().pattern);
        QCOMPARE(laid.pattern.pieces.size(), std::size_t(document().pieceCount()) + 2);
        QVERIFY(laid.pattern.pieces.back().name.find("facing") != std::string::npos);
        type("segmentFacing", "60");
        QVERIFY(isDone());
        QCOMPARE(lines().facings.size(), std::size_t(2));
        QCOMPARE(lines().facings.front().width, 60.0);
        type("segmentFacing", "0");
        QVERIFY(isDone());
        QVERIFY(lines() == withPattern({}));
        QCOMPARE(steps(), 3);  // each that was taken by Enter
        for (int k = 0; k < 3; ++k) {
            fixture_.action(ActionId::Undo).trigger();
        }
        QVERIFY(lines() == withPattern({}));
    }

    void aProjectKeepsStrips() {
        document().setSeam(seamOf(SeamKind::Free, false));
        type("segmentFacing", "40");
        type("segmentExtension", "15");
        QVERIFY(isDone());
        const LineSettings said = lines();
        const QString file = fixture_.path("strips.toile");
        QVERIFY(writeProject(file.toStdString(), projectOf(document().state(), document().derived(),
                                                           document().view())));
        fixture_.close();
        fixture_.open({1400, 900}, NewGarment::Exact);
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(lines() == said);
    }

    void easeIsStatedInTheForm() {
        const int seam = seamOf(SeamKind::Seam, true);
        document().setSeam(seam);
        QVERIFY(field("segmentEase").isEnabled() && !button("segmentEaseReset").isEnabled());
        type("segmentEase", "3");
        const auto& graph = [this]() -> const SeamGraph& { return document().garment()->seams; };
        QCOMPARE(graph().seams[static_cast<std::size_t>(seam)].ease.value(), 0.03);
        QTest::mouseClick(&button("segmentEaseReset"), Qt::LeftButton);
        QVERIFY(!graph().seams[static_cast<std::size_t>(seam)].ease);
        document().setSeam(seamOf(SeamKind::Free, true));
        QVERIFY(!field("segmentEase").isEnabled());
    }

    void notchesAreAddedAndTakenAwayInTheForm() {
        const int seam = seamOf(SeamKind::Seam, true);
        document().setSeam(seam);
        const auto shown = [this] {
            return fixture_.find<QLabel>("segmentNotches").text().toInt();
        };
        const int before = shown();
        QTest::mouseClick(&button("segmentNotchAdd"), Qt::LeftButton);
        QVERIFY(isDone());
        QCOMPARE(shown(), before + 1);
        QCOMPARE(steps(), 1);
        QTest::mouseClick(&button("segmentNotchRemove"), Qt::LeftButton);
        QVERIFY(isDone());
        QCOMPARE(shown(), before);
    }
};

TOILE_WINDOW_TEST(StripsTest)
#include "strips_test.moc"
