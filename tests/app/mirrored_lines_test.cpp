// SPDX-License-Identifier: GPL-3.0-or-later
// Internal lines where edits are mirrored: drawn, moved and taken away on both sides at once.
#include <QFile>

#include "app/document/line_edits.h"
#include "app/document/mirrored_edits.h"
#include "app/views/tools/tool_box.h"
#include "core/symmetry/symmetry.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// A sleeve of the T-shirt of the samples.
class MirroredLinesTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;
    int sleeve_ = 0;

    Document& document() { return fixture_.document(); }
    SceneView& view() { return fixture_.patternView(); }
    int steps() { return document().history().index(); }
    const std::vector<InternalLine>& lines() { return document().state().lines.internalLines; }
    int counterpart(int piece) {
        return document().derived().symmetry->pieces.counterpart[std::size_t(piece)];
    }
    std::size_t drawnOn(int piece) { return document().patternPiece(piece)->internals.size(); }

    bool isDone() {
        return QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience) &&
               fixture_.waitForResults();
    }

    /// The centre of a triangle of the sleeve, in the view.
    QPointF centre(double share) {
        const Triangles& F = document().garment()->pieces[std::size_t(sleeve_)]->mesh.F;
        const int face = static_cast<int>(share * static_cast<double>(F.rows()));
        return *view().onScreen(sleeve_, face, Eigen::Vector3d::Constant(1.0 / 3));
    }

    /// Where the line on the sleeve ends, in the view.
    QPointF end() {
        const SurfacePoint& last = document().patternPiece(sleeve_)->internals.at(0).way.back();
        return *view().onScreen(sleeve_, last.face, last.barycentric);
    }

    bool areMirrored() {
        const Symmetry& symmetry = *editSymmetry(document());
        return lines().size() == 2 &&
               imageOfInternalLine(document().state().lines, *document().garment(),
                                   document().results(), symmetry, 0) == std::size_t(1);
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj",
                            fixture_.path("tshirt.obj")));
        fixture_.open({1400, 900}, NewGarment::Pattern);
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        fixture_.workspace().setMethod(Method::Curvature);  // the quickest
        QVERIFY(fixture_.openAndWait(fixture_.path("tshirt.obj")));
        QVERIFY(isDone());
        while (counterpart(sleeve_) < 0 || counterpart(sleeve_) == sleeve_) {
            ++sleeve_;
        }
        QVERIFY(editSymmetry(document()));
        fixture_.action(ActionId::ToolInternalLine).trigger();
    }

    void cleanupTestCase() { fixture_.close(); }

    void aLineIsDrawnMovedAndTakenAwayOnBothSides() {
        test::click(view(), centre(0.3));
        test::click(view(), centre(0.6));
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Return);
        QVERIFY(isDone());
        QCOMPARE(steps(), 1);
        QVERIFY(areMirrored());
        QCOMPARE(drawnOn(sleeve_), std::size_t(1));
        QCOMPARE(drawnOn(counterpart(sleeve_)), std::size_t(1));
        test::drag(view(), end(), centre(0.7));
        QVERIFY(isDone());
        QCOMPARE(steps(), 2);
        QVERIFY(areMirrored());
        QTest::keyClick(&view(), Qt::Key_Delete);
        QVERIFY(isDone());
        QCOMPARE(steps(), 3);
        QVERIFY(lines().empty());
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(isDone());
        QVERIFY(areMirrored());
        // Edits that are not mirrored are about the one line.
        setMirrorsEdits(document(), false);
        test::click(view(), end() + 0.5 * (centre(0.3) - end()));
        QTest::keyClick(&view(), Qt::Key_Delete);
        QVERIFY(isDone());
        QCOMPARE(lines().size(), std::size_t(1));
    }
};

TOILE_WINDOW_TEST(MirroredLinesTest)
#include "mirrored_lines_test.moc"
