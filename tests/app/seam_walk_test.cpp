// SPDX-License-Identifier: GPL-3.0-or-later
// The walk of a seam: real keys and drags, and where the rolled piece is then.
#include <QLabel>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/views/rolled_piece.h"
#include "app/views/walk_bar.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class SeamWalkTest : public QObject {
    Q_OBJECT

    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    PatternView& view() { return fixture_.patternView(); }
    WalkBar& bar() { return *fixture_.window().views().walkBar(); }
    QAction& action() { return fixture_.action(ActionId::WalkSeam); }
    QSlider& slider() { return fixture_.find<QSlider>("walkSlider"); }
    QString reading() { return fixture_.find<QLabel>("walkReading").text(); }
    const std::vector<Seam>& seams() { return document().garment()->seams.seams; }

    int seamNamed(const std::string& name) {
        return static_cast<int>(std::ranges::find(seams(), name, &Seam::name) - seams().begin());
    }
    int freeEdge() {
        return static_cast<int>(std::ranges::find(seams(), SeamKind::Free, &Seam::kind) -
                                seams().begin());
    }

    /// Where the rolled piece is apart from the other at a share of both, mm.
    double gapAt(double share) {
        const RolledPiece& rolled = *view().rolled();
        DrawnLoops loops(document().results());
        const Seam& seam = seams()[static_cast<std::size_t>(rolled.seam())];
        const SeamMatch at = placeAtShare(seam, share);
        const Eigen::Vector2d left = loops.of(seam.left).pointAt(at.left).transpose();
        const Eigen::Vector2d right = loops.of(seam.right).pointAt(at.right).transpose();
        return (rolled.now().motion.applied(right) - left).norm();
    }

    void begin(int seam) {
        document().setSeam(seam);
        QVERIFY(action().isEnabled());
        action().trigger();
        QVERIFY(!bar().isHidden());
        QCOMPARE(view().rolled()->seam(), seam);
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj"));
        LineSettings lines = document().state().lines;
        lines.notches = NotchRules{};
        document().setLines(lines, "Notches");
        QVERIFY(QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience));
        QVERIFY(fixture_.waitForResults());
    }

    void init() {
        SKIP_WITHOUT_GL();
        bar().end();
        document().setSeam({});
    }

    void cleanupTestCase() { fixture_.close(); }

    void aSeamIsWalkedFromItsStartToItsEnd() {
        const int steps = document().history().count();
        const int seam = seamNamed("front / sleeve_left");
        fixture_.action(ActionId::ToolSelect).trigger();
        test::click(view(), *view().onSeam(seam, 0, 0.5));
        QCOMPARE(document().seam(), std::optional(seam));
        action().trigger();
        QVERIFY(!bar().isHidden());
        QCOMPARE(view().rolled()->share(), 0.0);
        QVERIFY(gapAt(0) < 1e-9);
        QVERIFY(reading().startsWith("sleeve_left on front · "));
        const QImage before = fixture_.patternPicture();
        const double middle = slider().height() / 2.0;
        QVERIFY(reading().contains("before notch 1 of "));
        test::drag(slider(), {5, middle}, {slider().width() + 50.0, middle});
        QCOMPARE(view().rolled()->share(), 1.0);
        QVERIFY(gapAt(1) < 1e-9);
        QVERIFY(gapAt(0) > 1);  // it has been turned away from there
        const auto notches = view().rolled()->notches().size();
        QVERIFY(notches > 0);
        QVERIFY(reading().contains(QString("notch %1 of %1").arg(notches)));
        QVERIFY2(reading().endsWith("difference 0.00 mm (ease 0.00)"), qPrintable(reading()));
        QVERIFY(fixture_.patternPicture() != before);
        QTest::keyClick(&slider(), Qt::Key_Escape);
        QVERIFY(bar().isHidden());
        QVERIFY(!view().rolled());
        QCOMPARE(document().seam(), std::optional(seam));
        QCOMPARE(document().history().count(), steps);
    }

    void notchesAreStoppedAt() {
        begin(seamNamed("back / sleeve_left"));
        const std::vector<double> notches = view().rolled()->notches();
        QVERIFY(!notches.empty());
        slider().setValue(qRound(notches[0] * slider().maximum()));
        QCOMPARE(view().rolled()->share(), notches[0]);
        QVERIFY(reading().contains(QString("at notch 1 of %1").arg(notches.size())));
        QTest::keyClick(&slider(), Qt::Key_Left);
        QVERIFY(view().rolled()->share() < notches[0]);
        QVERIFY(reading().contains(QString("before notch 1 of %1").arg(notches.size())));
    }

    void keysAndDragsStopAtEveryNotch() {
        begin(seamNamed("back / sleeve_left"));
        const std::vector<double> notches = view().rolled()->notches();
        QVERIFY(!notches.empty());
        slider().setFocus();
        const auto stopsOnTheWay = [&](Qt::Key key, double end) {
            std::vector<double> met;
            for (int press = 0; press < 200; ++press) {
                const double share = view().rolled()->share();
                if (std::ranges::find(notches, share) != notches.end()) {
                    met.push_back(share);
                }
                if (share == end) {
                    break;
                }
                QTest::keyClick(&slider(), key);
            }
            std::ranges::sort(met);
            return met;
        };
        for (const auto& [there, back] : {std::pair(Qt::Key_Right, Qt::Key_Left),
                                          std::pair(Qt::Key_PageUp, Qt::Key_PageDown)}) {
            QVERIFY(stopsOnTheWay(there, 1) == notches);
            QVERIFY(stopsOnTheWay(back, 0) == notches);
        }
        const double middle = slider().height() / 2.0;
        QTest::keyClick(&slider(), Qt::Key_End);
        QCOMPARE(view().rolled()->share(), 1.0);
        slider().setValue(qRound(notches.front() * slider().maximum()));
        QStyleOptionSlider option;
        option.initFrom(&slider());
        option.orientation = Qt::Horizontal;
        option.maximum = slider().maximum();
        option.sliderPosition = slider().value();
        const QRectF handle = slider().style()->subControlRect(QStyle::CC_Slider, &option,
                                                               QStyle::SC_SliderHandle, &slider());
        test::drag(slider(), {handle.center().x(), middle}, {handle.center().x() + 2, middle});
        QCOMPARE(view().rolled()->share(), notches.front());
        test::drag(slider(), {handle.center().x(), middle}, {handle.center().x() + 40, middle});
        QVERIFY(view().rolled()->share() > notches.front());
    }

    void escapeInTheViewEndsItAndKeepsTheSelection() {
        begin(seamNamed("front / sleeve_left"));
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(bar().isHidden());
        QVERIFY(document().seam());
        QTest::keyClick(&view(), Qt::Key_Escape);  // as ever
        QVERIFY(!document().seam());
    }

    void anotherSeamIsWalkedInItsPlaceAndNoneEndsIt() {
        begin(seamNamed("front / sleeve_left"));
        slider().setValue(700);
        const int other = seamNamed("back / sleeve_right");
        document().setSeam(other);
        QVERIFY(!bar().isHidden());
        QCOMPARE(view().rolled()->seam(), other);
        QCOMPARE(view().rolled()->share(), 0.0);
        document().setSeam(freeEdge());
        QVERIFY(bar().isHidden() && !view().rolled());
        QVERIFY(!action().isEnabled());
        begin(other);
        fixture_.find<QToolButton>("walkClose").click();
        QVERIFY(bar().isHidden() && !view().rolled());
    }

    void everySewnSeamCanBeWalked() {
        for (int seam = 0; seam < document().seamCount(); ++seam) {
            if (seams()[static_cast<std::size_t>(seam)].kind == SeamKind::Free) {
                continue;
            }
            begin(seam);
            for (const int step : {1, 250, 500, 999, 1000}) {
                slider().setValue(step);
                QVERIFY(gapAt(view().rolled()->share()) < 1e-9);
                QVERIFY(std::isfinite(view().rolled()->now().motion.turn));
            }
        }
        // Whatever becomes of the garment.
        fixture_.workspace().setMethod(Method::Lscm);
        QVERIFY(QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience));
        QVERIFY(!bar().isHidden());
        QVERIFY(gapAt(view().rolled()->share()) < 1e-9);
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience));
    }

    void playGoesToTheEnd() {
        begin(seamNamed("front / sleeve_left"));
        slider().setValue(950);
        fixture_.find<QToolButton>("walkPlay").click();  // back from there
        QVERIFY(QTest::qWaitFor([this] { return view().rolled()->share() < 0.95; }, 20000));
        fixture_.find<QToolButton>("walkPlay").click();
        const double stopped = view().rolled()->share();
        QApplication::processEvents();
        QCOMPARE(view().rolled()->share(), stopped);
    }
};

TOILE_WINDOW_TEST(SeamWalkTest)
#include "seam_walk_test.moc"
