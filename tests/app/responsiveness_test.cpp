// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMenu>
#include <QMenuBar>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/actions/project_actions.h"
#include "app/document/piece_edits.h"
#include "app/jobs/ready_checker.h"
#include "app/session/autosave.h"
#include "app/widgets/busy_sheet.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/processor_time.h"
#include "tests/app/support/window_fixture.h"
#include "tests/core/support/shapes.h"

using namespace toile;
using namespace toile::app;

namespace {

/// The window answers within this, whatever is going on.
constexpr double kBar = 50;  // milliseconds
constexpr std::size_t kRemembered = 6;
/// What is asked for shows something within this.
constexpr double kSeenBar = 100;  // milliseconds
constexpr int kSide = 354;        ///< squares: a quarter of a million triangles
constexpr int kPieces = 400;      ///< of another garment of a million triangles
constexpr int kSideOfMany = 35;   ///< of each of these

struct Event {
    double milliseconds = 0;
    QString what;
};

/// An application that knows how long each event has kept it. Painting counts apart: by a software
/// renderer a frame of a million triangles takes longer than all else, and says nothing of a
/// machine with a graphics card.
class TimedApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            noteSeen(receiver);
            if (qobject_cast<SceneView*>(receiver) && !isInView_) {
                return paintView(receiver, event);
            }
        }
        const bool paints = isPainting(event->type());
        if (isInside_ && !(paints && !isPainting_)) {
            return QApplication::notify(receiver, event);
        }
        const bool wasInside = std::exchange(isInside_, true);
        const bool wasPainting = std::exchange(isPainting_, paints);
        const QString what = QString("%1 to %2 %3")
                                 .arg(QString::number(event->type()),
                                      receiver->metaObject()->className(), receiver->objectName());
        const double painted = painted_, start = test::processorTime();
        const bool done = QApplication::notify(receiver, event);
        const double taken = test::processorTime() - start;
        isInside_ = wasInside;
        isPainting_ = wasPainting;
        if (paints) {
            painted_ += taken;
            longestPainting_ = std::max(longestPainting_, taken);
        } else {
            remember({taken - (painted_ - painted), what});
        }
        return done;
    }

    void reset() {
        longest_.clear();
        longestPainting_ = 0;
        events_ = 0;
    }
    /// The longest first.
    const std::vector<Event>& longest() const { return longest_; }
    double longestPainting() const { return longestPainting_; }
    int events() const { return events_; }

    /// From now on; see `seenAfter`.
    void watch(const QWidget& widget) {
        watched_ = &widget;
        seenAfter_.reset();
        watchedFrom_ = test::processorTime();
        views_ = 0;
    }
    /// What the thread has done, milliseconds, until the watched widget was painted, painting of
    /// the views aside; none: not yet.
    const std::optional<double>& seenAfter() const { return seenAfter_; }

private:
    static bool isPainting(QEvent::Type type) {
        return type == QEvent::Paint || type == QEvent::UpdateRequest ||
               type == QEvent::UpdateLater || type == QEvent::Expose;
    }

    void noteSeen(const QObject* receiver) {
        if (receiver == watched_ && !seenAfter_) {
            seenAfter_ = test::processorTime() - watchedFrom_ - views_;
        }
    }

    bool paintView(QObject* view, QEvent* event) {
        isInView_ = true;
        const double start = test::processorTime();
        const bool done = notify(view, event);
        views_ += test::processorTime() - start;
        isInView_ = false;
        return done;
    }

    void remember(Event event) {
        ++events_;
        const auto at = std::ranges::lower_bound(longest_, event.milliseconds, std::greater(),
                                                 &Event::milliseconds);
        longest_.insert(at, std::move(event));
        longest_.resize(std::min(longest_.size(), kRemembered));
    }

    std::vector<Event> longest_;
    double painted_ = 0, longestPainting_ = 0;
    int events_ = 0;
    bool isInside_ = false, isPainting_ = false;
    const QObject* watched_ = nullptr;
    std::optional<double> seenAfter_;
    double watchedFrom_ = 0, views_ = 0;
    bool isInView_ = false;
};

TimedApplication& application() {
    return static_cast<TimedApplication&>(*QApplication::instance());
}

}  // namespace

/// A garment of a million triangles is opened and flattened while a person goes on: no event may
/// keep the window longer than 50 ms of processor time.
class ResponsivenessTest : public QObject {
    Q_OBJECT

    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    SceneView& garmentView() { return *fixture_.window().views().garmentView(); }
    SceneView& patternView() { return *fixture_.window().views().patternView(); }

    /// A little of everything a person does meanwhile.
    void fidget(int round) {
        for (SceneView* view : {&garmentView(), &patternView()}) {
            const QPoint at(view->width() * (1 + round % 7) / 8,
                            view->height() * (1 + round % 5) / 6);
            test::moveTo(*view, at);
            test::moveTo(*view, at + QPoint(9, 4));
            test::turnWheel(*view, at, round % 2 ? 1 : -1);
            if (round % 3 == 0) {
                QTest::mouseClick(view, Qt::LeftButton, {}, at);
            }
            if (round % 8 == 5) {
                QTest::mouseDClick(view, Qt::LeftButton, {}, at);
            }
        }
        if (round % 10 == 7) {
            auto* menu = fixture_.window().menuBar()->findChild<QMenu*>("flattenMenu");
            menu->popup(fixture_.window().mapToGlobal(QPoint(40, 40)));
            QTest::keyClick(menu, Qt::Key_Down);
            menu->close();
        }
        QTest::qWait(5);
    }

    /// As an event of its own, so that it counts.
    template <class Does>
    static void asEvent(Does does) {
        QMetaObject::invokeMethod(QApplication::instance(), does, Qt::QueuedConnection);
        QApplication::processEvents();
    }

    bool isWorking() { return fixture_.workspace().isBusy(); }

    /// Until no job runs; and then some, for what follows on other threads.
    void fidgetUntilDone(int atLeast) {
        QElapsedTimer time;
        time.start();
        for (int round = 0; round < atLeast || isWorking(); ++round) {
            fidget(round);
            QVERIFY2(time.elapsed() < 600000, "it never ended");
        }
    }

    void demand(const char* when) {
        QStringList lines;
        for (const Event& event : application().longest()) {
            lines << QString("%1 ms %2").arg(event.milliseconds, 0, 'f', 1).arg(event.what);
        }
        qInfo("%s: %d events, the longest %s; painting %.0f ms", when, application().events(),
              qPrintable(lines.join("; ")), application().longestPainting());
        const bool any = !application().longest().empty();
        const double longest = any ? application().longest().front().milliseconds : 0;
        const QString worst = lines.join("; ");
        application().reset();
        QVERIFY2(longest <= kBar, qPrintable(QString("%1: %2").arg(when, worst)));
    }

    /// A garment of as many triangles in many pieces.
    void writeManyPieces() {
        std::vector<std::pair<std::string, MeshArrays>> pieces;
        for (int i = 0; i < kPieces; ++i) {
            const Eigen::Vector3d corner(60.0 * (i % 20), 60.0 * (i / 20), 0);
            pieces.emplace_back("piece " + std::to_string(i + 1),
                                test::makeSheet(50, 50, kSideOfMany, kSideOfMany, corner));
        }
        test::writeObj(fixture_.path("many.obj").toStdString(), pieces);
    }

    void trigger(ActionId id) {
        asEvent([this, id] { fixture_.action(id).trigger(); });
    }

    /// What the menus of pieces and the dialogs do.
    void useIt() {
        for (const Overlay overlay : {Overlay::Area, Overlay::Warp, Overlay::Principal,
                                      Overlay::Dirichlet, Overlay::Normal, Overlay::Checker}) {
            asEvent([this, overlay] { document().setOverlay(overlay); });
            fidgetUntilDone(8);
        }
        demand("All overlays");
        asEvent([this] { document().setSelection({1}); });
        for (const ActionId id : {ActionId::HidePieces, ActionId::ShowAllPieces,
                                  ActionId::ShowOnlyThese, ActionId::ShowAllPieces}) {
            asEvent([this] { document().setSelection({1}); });
            trigger(id);
            fidgetUntilDone(4);
        }
        asEvent([this] { renamePiece(document(), 0, "Vorderteil"); });
        fidgetUntilDone(4);
        demand("Pieces shown, hidden and renamed");
        asEvent([this] { document().setSelection({1}); });
        trigger(ActionId::LeaveOut);
        fidgetUntilDone(20);
        trigger(ActionId::TakeIn);
        fidgetUntilDone(20);
        QVERIFY(document().isFlattened());
        demand("A piece left out and taken in");
        trigger(ActionId::GoToProblems);
        fidgetUntilDone(10);
        QVERIFY(QTest::qWaitFor([this] { return fixture_.window().checker().isUpToDate(); },
                                test::kPatience));
        fidgetUntilDone(10);
        demand("Findings");
        asEvent([this] {
            fixture_.window().garmentActions().project().session().save(
                std::filesystem::path(fixture_.path("kept.toile").toStdString()));
        });
        fidgetUntilDone(20);
        demand("Saving");
        for (const ActionId id : {ActionId::ExportPattern, ActionId::PrintPattern}) {
            trigger(id);
            QVERIFY(QApplication::activeModalWidget());
            fidgetUntilDone(30);
            asEvent([] { QApplication::activeModalWidget()->close(); });
            fidgetUntilDone(4);
        }
        demand("Export and print");
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        std::vector<std::pair<std::string, MeshArrays>> pieces;
        for (int i = 0; i < 4; ++i) {
            MeshArrays mesh = test::bentPanel(kSide);
            if (i % 2 == 1) {  // mirrored, so that its left edge is sewn to the right of the last
                mesh.V.col(0) = (600 - mesh.V.col(0).array()).matrix().eval();
                mesh.F.col(1).swap(mesh.F.col(2));
            }
            mesh.V.col(0).array() += 600.0 * i;
            pieces.emplace_back("panel " + std::to_string(i + 1), std::move(mesh));
        }
        fixture_.open();
        fixture_.window().keepRecoveryFiles(fixture_.path("recovery"), AutosaveTimes{30, 200, 100});
        // The views' first frame has the driver start, whatever is in it.
        QVERIFY(fixture_.openAndWait(TOILE_SOURCE_DIR "/resources/samples/cap.obj"));
        test::writeObj(fixture_.path("million.obj").toStdString(), pieces);
        fixture_.preferences().setChoices({.autoFlattenTriangles = 10'000'000});
    }

    void cleanupTestCase() { fixture_.close(); }

    void theWindowAnswersWhileAMillionTrianglesFlatten() {
        FlattenOptions options;
        options.method = Method::Curvature;
        document().setOptions(options);
        // Without frames in between there are far more events.
        fixture_.window().setUpdatesEnabled(false);
        application().reset();
        asEvent([this] { fixture_.window().openFiles({fixture_.path("million.obj")}); });
        fidgetUntilDone(10);
        QVERIFY(document().isFlattened());
        demand("Opening and flattening");
        fidgetUntilDone(40);
        demand("Looking at it");
        fixture_.window().setUpdatesEnabled(true);
        QVERIFY(fixture_.waitForResults());
        fixture_.window().setUpdatesEnabled(false);
        demand("Frames between");

        asEvent([this] { document().setOverlay(Overlay::Strain); });
        fidgetUntilDone(40);
        demand("An overlay of numbers");

        QTest::keyClick(&patternView(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(&patternView(), Qt::Key_BracketLeft);
        QTest::keyClick(&patternView(), Qt::Key_L, Qt::ControlModifier);
        QTest::keyClick(&patternView(), Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&patternView(), Qt::Key_Z, Qt::ControlModifier);
        demand("Moves and steps back");

        asEvent([this] { fixture_.action(ActionId::MethodNatural).trigger(); });
        fidgetUntilDone(20);
        QVERIFY(document().isFlattened());
        QTest::keyClick(&patternView(), Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&patternView(), Qt::Key_Y, Qt::ControlModifier);
        fidgetUntilDone(10);
        demand("Another method, back and forth");

        asEvent([this] { fixture_.action(ActionId::ToolCut).trigger(); });
        for (int step = 0; step < 40; ++step) {  // a click would cut
            for (SceneView* view : {&garmentView(), &patternView()}) {
                test::moveTo(*view, QPointF(view->width() * (step % 10) / 10,
                                            view->height() * (step % 7) / 7));
            }
            QTest::qWait(1);
        }
        asEvent([this] { fixture_.action(ActionId::ToolSelect).trigger(); });
        demand("A tool that looks for edges");

        asEvent([this] { fixture_.document().setSeamEase(0, 0.01); });
        asEvent([this] {
            UserCut cut;
            cut.points = {{100, 0, 0}, {100, 600, 0}};
            fixture_.workspace().cuts().add(cut);
        });
        fidgetUntilDone(20);
        QVERIFY(!document().loading().seams.cuts.empty());
        demand("A cut");

        useIt();

        asEvent([this] {
            fixture_.window().openFiles({TOILE_SOURCE_DIR "/resources/samples/cap.obj"});
        });
        fidgetUntilDone(20);
        demand("Another garment, and all that was kept of this one goes");
    }

    void theWindowAnswersWithFourHundredPieces() {
        writeManyPieces();
        fixture_.window().setUpdatesEnabled(false);
        application().reset();
        asEvent([this] { fixture_.window().openFiles({fixture_.path("many.obj")}); });
        fidgetUntilDone(10);
        QCOMPARE(document().pieceCount(), kPieces);
        demand("Opening and flattening");
        QTest::keyClick(&patternView(), Qt::Key_A, Qt::ControlModifier);
        fidgetUntilDone(10);
        demand("Selecting all");
        useIt();
    }

    void whatIsGoingOnIsSeenSoon() {
        fixture_.close();
        fixture_.open();
        auto& page = fixture_.find<BusySheet>("busyPage");
        const auto seen = [] { return application().seenAfter().has_value(); };
        application().watch(page);
        fixture_.window().openFiles({fixture_.path("million.obj")});
        QVERIFY(QTest::qWaitFor(seen, test::kPatience));
        QVERIFY(page.task().contains("million.obj"));
        const double reading = *application().seenAfter();

        double firstFrame = -1;
        connect(&document(), &Document::opened, &page,
                [this] { application().watch(garmentView()); });
        QVERIFY(QTest::qWaitFor([this, &seen] { return document().garment() && seen(); },
                                test::kPatience));
        firstFrame = *application().seenAfter();
        QVERIFY(fixture_.waitForResults());

        application().watch(fixture_.find<QWidget>("colourBar"));
        document().setOverlay(Overlay::Warp);
        QVERIFY(QTest::qWaitFor(seen, test::kPatience));
        const double overlay = *application().seenAfter();
        qInfo("Seen after: what is read %.1f ms, the first frame %.1f ms, the overlay %.1f ms",
              reading, firstFrame, overlay);
        QVERIFY2(std::max({reading, firstFrame, overlay}) <= kSeenBar,
                 qPrintable(QString("%1, %2, %3 ms").arg(reading).arg(firstFrame).arg(overlay)));
    }
};

TOILE_WINDOW_TEST(ResponsivenessTest, TimedApplication)
#include "responsiveness_test.moc"
