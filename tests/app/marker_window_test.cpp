// SPDX-License-Identifier: GPL-3.0-or-later
// The window of the marker: real keys and clicks, what lies on the cloth then, what the history and
// the project keep of it, and what is written.
#include "app/marker/marker_window.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineF>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/marker/cloth_view.h"
#include "app/settings/language.h"
#include "app/widgets/number_edits.h"
#include "core/marker/marker_settings.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class MarkerWindowTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    MarkerWindow& window() { return fixture_.find<MarkerWindow>("markerWindow"); }
    MarkerDesk& desk() { return window().desk(); }
    ClothView& view() { return window().view(); }
    const MarkerPlan& plan() { return document().state().markers.of(desk().material()); }

    template <class Widget>
    Widget& find(const char* name) {
        return *window().findChild<Widget*>(name);
    }

    template <class Holds>
    bool comes(const Holds& holds) {
        return QTest::qWaitFor(holds, test::kPatience);
    }

    /// Laid, and nothing is searched any more.
    bool rests() {
        return comes([this] { return desk().marker() && !desk().isRunning(); });
    }

    /// Four sheets of two sizes.
    void openSheets() {
        QVERIFY(fixture_.openAndWait(fixture_.path("sheets.obj")));
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(fixture_.waitForResults());
    }

    void layOnCloth() {
        fixture_.action(ActionId::LayOnCloth).trigger();
        QVERIFY(window().isVisible());
        QVERIFY(QTest::qWaitForWindowExposed(&window(), test::kPatience));
        QApplication::setActiveWindow(&window());
        QVERIFY(rests());
    }

    void click(const char* button) {
        QTest::mouseClick(&find<QPushButton>(button), Qt::LeftButton);
    }

    void type(QAbstractSpinBox& field, const QString& text) {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

    Placement placementOf(int copy) {
        return desk().marker()->copies[static_cast<std::size_t>(copy)].placement;
    }

    /// Where the mouse is to be for a place of the cloth to be the middle of a copy's name.
    void dragCopy(int copy, const QPointF& by, Qt::KeyboardModifiers modifiers = Qt::AltModifier) {
        const QPointF from = view().placeOf(copy);
        test::drag(view(), from, from + by, Qt::LeftButton, modifiers);
    }

    /// Along the warp, so that a copy lies behind all others.
    QPointF beyondAll() {
        double end = 0;
        for (std::size_t copy = 0; copy < desk().marker()->copies.size(); ++copy) {
            end = std::max(end, view().placeOf(static_cast<int>(copy)).x());
        }
        return {end, 0};
    }

    /// From one copy's middle to another's.
    QPointF way(int from, int to) { return view().placeOf(to) - view().placeOf(from); }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("sheets.obj").toStdString(),
                       {{"front", test::makeSheet(300, 200, 6, 4)},
                        {"back", test::makeSheet(300, 220, 6, 4, {400, 0, 0})},
                        {"sleeve", test::makeSheet(150, 120, 4, 4, {800, 0, 0})},
                        {"collar", test::makeSheet(200, 60, 4, 2, {1000, 0, 0})}});
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj",
                            fixture_.path("tshirt.obj")));
    }

    void init() { fixture_.open(); }
    void cleanup() { fixture_.close(); }

    void allPiecesAreLaidWithoutOverlap() {
        openSheets();
        layOnCloth();
        QCOMPARE(desk().marker()->copies.size(), std::size_t(4));
        QVERIFY(misplacedCopies(*desk().pattern(), *desk().marker(), desk().settings()).empty());
        QCOMPARE(desk().marker()->width, kUsualClothWidth);
        QVERIFY(find<QLabel>("markerFigures").text().contains("% used"));
        QVERIFY(find<QLabel>("markerDetails").text().contains("4 pieces"));
    }

    void withoutAGarmentASentenceSaysWhatToDo() {
        QVERIFY(!fixture_.action(ActionId::LayOnCloth).isEnabled());
        openSheets();
        QVERIFY(fixture_.action(ActionId::LayOnCloth).isEnabled());
    }

    void whatIsNotFlatIsNotLaid() {
        test::writeObj(fixture_.path("closed.obj").toStdString(),
                       {{"closed", test::makeTetrahedron(100)}});
        QVERIFY(fixture_.openAndWait(fixture_.path("closed.obj")));
        fixture_.action(ActionId::LayOnCloth).trigger();
        QVERIFY(comes([this] { return desk().stage() == MarkerDesk::Stage::Nothing; }));
        QVERIFY(desk().problem().contains("no flat pieces"));
        QVERIFY(!find<QPushButton>("markerSave").isEnabled());
    }

    void itIsImprovedUntilItIsStopped() {
        openSheets();
        layOnCloth();
        type(find<QDoubleSpinBox>("markerGarments"), "5");
        QCOMPARE(plan().settings.garments, 5);
        QVERIFY(rests());
        QCOMPARE(desk().marker()->copies.size(), std::size_t(20));
        const int before = desk().marker()->rounds;
        const double length = desk().marker()->length;
        if (desk().marker()->isOptimal) {
            QVERIFY(!find<QPushButton>("markerImprove").isEnabled());
            return;
        }
        click("markerImprove");
        QVERIFY(desk().isRunning());
        QVERIFY(comes([&] { return desk().marker()->rounds > before || !desk().isRunning(); }));
        QVERIFY(desk().marker()->length <= length);
        if (desk().isRunning()) {
            QCOMPARE(find<QPushButton>("markerImprove").text(), QString("&Stop"));
            click("markerImprove");
        }
        QVERIFY(rests());
        QCOMPARE(find<QPushButton>("markerImprove").text(), QString("&Improve"));
    }

    void whatIsTypedIsLeftAloneWhileItIsImproved() {
        openSheets();
        layOnCloth();
        type(find<QDoubleSpinBox>("markerGarments"), "7");
        auto& width = find<LengthEdit>("markerWidth");
        width.setFocus();
        width.selectAll();
        QTest::keyClicks(&width, "77");
        QSignalSpy better(&desk(), &MarkerDesk::changed);
        desk().improve();
        QVERIFY(comes([&] { return better.count() > 3 || !desk().isRunning(); }));
        desk().stop();
        QVERIFY(width.text().startsWith("77"));
        QTest::keyClick(&width, Qt::Key_0);
        QTest::keyClick(&width, Qt::Key_Return);
        QCOMPARE(plan().settings.width, 770.0);
        QVERIFY(comes([this] { return view().hasFocus(); }));
    }

    void aDraggedPieceIsKeptInOneStep() {
        openSheets();
        layOnCloth();
        const int steps = document().history().count();
        const Placement before = placementOf(0);
        const Placement other = placementOf(1);
        dragCopy(0, {150, 0});
        QCOMPARE(plan().kept.size(), std::size_t(1));
        QCOMPARE(document().history().count(), steps + 1);
        QVERIFY(desk().marker()->copies[0].isKept);
        QVERIFY(placementOf(0).offset.x() > before.offset.x());
        QCOMPARE(placementOf(1), other);  // what was not touched stays until it is asked for
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(plan().kept.empty());
        QCOMPARE(placementOf(0), before);
        fixture_.action(ActionId::Redo).trigger();
        QCOMPARE(plan().kept.size(), std::size_t(1));
        QVERIFY(desk().marker()->copies[0].isKept);
    }

    void whatIsKeptStaysWhileTheRestIsImproved() {
        openSheets();
        layOnCloth();
        dragCopy(0, {0, 8});
        dragCopy(0, beyondAll());
        const Placement kept = placementOf(0);
        QVERIFY(desk().misplaced().empty());
        const int before = desk().marker()->rounds;
        click("markerImprove");
        QVERIFY(desk().isRunning());
        QVERIFY(comes([&] {
            return !desk().isRunning() || (desk().isCurrent() && desk().marker()->rounds != before);
        }));
        desk().stop();
        QVERIFY(rests());
        const auto& copies = desk().marker()->copies;
        const auto found = std::ranges::find(copies, true, &LaidCopy::isKept);
        QVERIFY(found != copies.end());
        QVERIFY((found->placement.offset - kept.offset).norm() < 1e-6);
        QVERIFY(desk().misplaced().empty());
    }

    void whatIsKeptOnOtherThingsStaysRed() {
        openSheets();
        layOnCloth();
        const CopyKey first = desk().marker()->copies[0].key;
        const auto indexOf = [this](const CopyKey& key) {
            const auto& copies = desk().marker()->copies;
            return static_cast<int>(std::ranges::find(copies, key, &LaidCopy::key) -
                                    copies.begin());
        };
        dragCopy(1, {0, 8});
        dragCopy(1, {0, -8});
        dragCopy(0, way(0, 1));
        QCOMPARE(plan().kept.size(), std::size_t(2));
        QVERIFY(desk().misplaced().size() >= 2);
        click("markerImprove");
        QVERIFY(comes([this] { return desk().marker()->rounds > 0 || !desk().isRunning(); }));
        desk().stop();
        QVERIFY(rests());
        QVERIFY(std::ranges::find(desk().misplaced(), indexOf(first)) != desk().misplaced().end());
        QVERIFY(!find<QPushButton>("markerSave").isEnabled());
    }

    void overlapsAreShownWhileOneDrags() {
        openSheets();
        layOnCloth();
        const QPointF from = view().placeOf(0), to = from + way(0, 1);
        test::moveTo(view(), from);
        test::sendMouse(view(), QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        test::sendMouse(view(), QEvent::MouseMove, 0.5 * (from + to), Qt::NoButton, Qt::LeftButton);
        test::sendMouse(view(), QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
        QVERIFY(view().isDragging());
        QVERIFY(desk().misplaced().size() >= 2);
        QVERIFY(plan().kept.empty());
        QVERIFY(!find<QPushButton>("markerSave").isEnabled());
        QVERIFY(find<QLabel>("markerFigures").text().contains("overlap others"));
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(!view().isDragging());
        QVERIFY(window().isVisible());
        QVERIFY(desk().misplaced().empty());
        test::sendMouse(view(), QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
        QVERIFY(plan().kept.empty());
        QVERIFY(find<QPushButton>("markerSave").isEnabled());
    }

    void aDragEndsWithItsOwnButton() {
        openSheets();
        layOnCloth();
        const QPointF from = view().placeOf(0), to = from + QPointF(150, 0);
        test::moveTo(view(), from);
        test::sendMouse(view(), QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        test::sendMouse(view(), QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
        QVERIFY(view().isDragging());
        const Qt::MouseButtons both = Qt::LeftButton | Qt::MiddleButton;
        test::sendMouse(view(), QEvent::MouseButtonPress, to, Qt::MiddleButton, both);
        test::sendMouse(view(), QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::MiddleButton);
        QVERIFY(!view().isDragging());
        test::sendMouse(view(), QEvent::MouseButtonRelease, to, Qt::MiddleButton, Qt::NoButton);
        QCOMPARE(plan().kept.size(), std::size_t(1));
    }

    void aDoubleClickReleasesWhatIsKept() {
        openSheets();
        layOnCloth();
        dragCopy(0, {150, 0});
        QCOMPARE(plan().kept.size(), std::size_t(1));
        test::doubleClick(view(), view().placeOf(0));
        QVERIFY(plan().kept.empty());
    }

    void keysTurnAsTheRuleAllows() {
        openSheets();
        layOnCloth();
        test::click(view(), view().placeOf(0));
        QCOMPARE(view().selected(), 0);
        QCOMPARE(document().selection().size(), std::size_t(1));
        const double before = placementOf(0).turn;
        QTest::keyClick(&view(), Qt::Key_R);
        QVERIFY(std::abs(std::abs(wrappedAngle(placementOf(0).turn - before)) - std::numbers::pi) <
                1e-9);
        QVERIFY(!view().handle());
        auto& turns = find<QComboBox>("markerTurns");
        turns.setFocus();
        QTest::keyClick(&turns, Qt::Key_Down);  // one way
        QCOMPARE(plan().settings.turns, TurnRule::OneWay);
        QVERIFY(rests());
        const std::size_t kept = plan().kept.size();
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_R);
        QCOMPARE(plan().kept.size(), kept);
        QVERIFY(find<QLabel>("markerSaid").text().contains("one direction"));
    }

    void theHandleTurnsWithinTheTolerance() {
        openSheets();
        layOnCloth();
        type(find<AngleEdit>("markerTolerance"), "10");
        QVERIFY(std::abs(plan().settings.tolerance - std::numbers::pi / 18) < 1e-9);
        QVERIFY(rests());
        test::click(view(), view().placeOf(0));
        QVERIFY(view().handle());
        const QPointF at = *view().handle();
        test::drag(view(), at, at + QPointF(400, 300));
        QCOMPARE(plan().kept.size(), std::size_t(1));
        const double grain = grainOf(
            desk().pattern()->pieces[static_cast<std::size_t>(desk().marker()->copies[0].piece)]);
        const double off =
            std::remainder(directionOnSheet(placementOf(0), grain), std::numbers::pi);
        QVERIFY2(std::abs(std::abs(off) - std::numbers::pi / 18) < 1e-6,
                 qPrintable(QString::number(off)));
    }

    void theMouseSchemeOfTheUserMovesTheCloth() {
        openSheets();
        layOnCloth();
        const auto movedBy = [this](Qt::MouseButton button) -> QPointF {
            const QPointF before = view().placeOf(0);
            const QPointF empty(view().width() / 2.0, view().height() - 12.0);
            test::drag(view(), empty, empty + QPointF(-40, -25), button);
            return view().placeOf(0) - before;
        };
        const auto choose = [this](Navigation navigation) {
            Choices choices = fixture_.preferences().choices();
            choices.navigation = navigation;
            fixture_.preferences().setChoices(choices);
        };
        const auto isMove = [](const QPointF& by) {
            return QLineF(by, QPointF(-40, -25)).length() < 1;
        };
        choose(Navigation::Rhino);
        QVERIFY(isMove(movedBy(Qt::RightButton)));
        QVERIFY(!view().findChild<QMenu*>("clothMenu"));
        choose(Navigation::Clo);
        QVERIFY(isMove(movedBy(Qt::MiddleButton)));
        // A click of the right button, which moves nothing, shows the menu.
        test::sendMouse(view(), QEvent::MouseButtonPress, {60, 60}, Qt::RightButton,
                        Qt::RightButton);
        QVERIFY(!view().findChild<QMenu*>("clothMenu"));
        test::sendMouse(view(), QEvent::MouseButtonRelease, {60, 60}, Qt::RightButton, {});
        QVERIFY(view().findChild<QMenu*>("clothMenu"));
        view().findChild<QMenu*>("clothMenu")->close();
    }

    void settingsAreStepsAndComeBackWithTheProject() {
        openSheets();
        layOnCloth();
        type(find<LengthEdit>("markerWidth"), "700");
        QCOMPARE(plan().settings.width, 700.0);
        QVERIFY(rests());
        QCOMPARE(desk().marker()->width, 700.0);
        type(find<LengthEdit>("markerGap"), "5");
        QVERIFY(rests());
        QVERIFY(misplacedCopies(*desk().pattern(), *desk().marker(), desk().settings()).empty());
        fixture_.action(ActionId::Undo).trigger();
        QCOMPARE(plan().settings.gap, 0.0);
        fixture_.action(ActionId::Redo).trigger();
        QVERIFY(rests());
        dragCopy(0, {40, 10});
        const MarkerPlan said = plan();
        QCOMPARE(said.kept.size(), std::size_t(1));
        const QString project = fixture_.path("laid.toile");
        fixture_.window().garmentActions().fileDialogs().saveProject =
            [&](QWidget*, const QString&) { return project; };
        fixture_.action(ActionId::SaveAs).trigger();
        QVERIFY(comes([&] { return QFile::exists(project) && !fixture_.workspace().isBusy(); }));
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(project));
        QVERIFY(document().state().markers.of("") == said);
        layOnCloth();
        QCOMPARE(desk().marker()->width, 700.0);
        QVERIFY(std::ranges::any_of(desk().marker()->copies, &LaidCopy::isKept));
    }

    void itFollowsThePattern() {
        openSheets();
        layOnCloth();
        dragCopy(0, {150, 0});
        document().setSelection({0});
        DocumentState next = document().state();
        next.settings[document().garment()->pieces[1]->id].quantity = 3;
        document().edit("Quantity", std::move(next));
        QVERIFY(comes([this] {
            return desk().marker() && desk().marker()->copies.size() == 6 && !desk().isRunning();
        }));
        QCOMPARE(std::ranges::count(desk().marker()->copies, true, &LaidCopy::isKept), 1);
    }

    void sheetsTakeTheRollsPlace() {
        openSheets();
        layOnCloth();
        auto& kind = find<QComboBox>("markerKind");
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_Down);
        QVERIFY(plan().settings.sheet);
        QVERIFY(find<LengthEdit>("markerSheetAlong").isVisible());
        QVERIFY(!find<LengthEdit>("markerWidth").isVisible());
        QVERIFY(comes([this] {
            return !desk().isRunning() && (desk().marker() || !desk().problem().isEmpty());
        }));
    }

    void sheetsThatAreTakenByHandCount() {
        openSheets();
        layOnCloth();
        auto& kind = find<QComboBox>("markerKind");
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_Down);
        type(find<LengthEdit>("markerSheetAlong"), "900");
        type(find<LengthEdit>("markerSheetAcross"), "700");
        const Eigen::Vector2d size(900, 700);
        QCOMPARE(*plan().settings.sheet, size);
        emit kind.activated(kind.currentIndex());  // chosen again
        QCOMPARE(*plan().settings.sheet, size);
        QVERIFY(rests());
        QCOMPARE(desk().marker()->sheets, 1);
        const double use = desk().marker()->use;
        Placement there = placementOf(0);
        there.offset.x() += 950;  // a sheet and what is between two
        there.turn += 4 * std::numbers::pi;
        desk().keep(0, there, "%1");
        QCOMPARE(desk().marker()->sheets, 2);
        QCOMPARE(desk().marker()->parts.size(), std::size_t(2));
        QVERIFY(desk().misplaced().empty());
        QVERIFY(std::abs(desk().marker()->use - use / 2) < 1e-9);
        QVERIFY(std::abs(plan().kept.front().placement.turn) <= std::numbers::pi);
        desk().release(0);
        QCOMPARE(desk().marker()->sheets, 1);
    }

    void hidesComeFromDrawings() {
        QFile drawing(fixture_.path("hide.svg"));
        QVERIFY(drawing.open(QIODevice::WriteOnly));
        drawing.write(
            "<svg xmlns='http://www.w3.org/2000/svg' width='900mm' height='700mm' "
            "viewBox='0 0 900 700'><path d='M0 0H900V700H0Z'/>"
            "<path d='M400 300h60v60h-60Z'/></svg>");
        drawing.close();
        openSheets();
        layOnCloth();
        QStringList answer;
        fixture_.window().garmentActions().fileDialogs().openHides = [&](QWidget*, const QString&) {
            return answer;
        };
        auto& kind = find<QComboBox>("markerKind");
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_End);
        QVERIFY(plan().settings.hides.empty());
        QCOMPARE(kind.currentIndex(), 0);  // nothing was chosen
        answer << fixture_.path("missing.svg") << drawing.fileName();
        QTest::keyClick(&kind, Qt::Key_End);
        QCOMPARE(plan().settings.hides.size(), std::size_t(1));
        QVERIFY(find<QLabel>("markerSaid").text().contains("missing.svg"));
        QVERIFY(comes([this] {
            return desk().marker() && desk().marker()->areHides && !desk().isRunning();
        }));
        QVERIFY(misplacedCopies(*desk().pattern(), *desk().marker(), desk().settings()).empty());
        QVERIFY(find<QLabel>("markerFigures").text().contains("hide"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(plan().settings.hides.empty());
        QCOMPARE(kind.currentIndex(), 0);
    }

    void whatIsHalfTypedHarmsNothingAtTheEnd() {
        openSheets();
        layOnCloth();
        for (const char* name : {"markerWidth", "markerRate"}) {
            auto& field = find<QDoubleSpinBox>(name);
            field.setFocus();
            field.selectAll();
            QTest::keyClicks(&field, "77");
        }
        fixture_.close();
        fixture_.open();
        openSheets();
        layOnCloth();
    }

    void whatCannotBeLaidIsNotSaved() {
        openSheets();
        layOnCloth();
        MarkerSettings settings = desk().settings();
        settings.border = desk().marker()->width;  // no cloth is left
        desk().setSettings("Border", settings);
        QVERIFY(comes([this] { return desk().stage() == MarkerDesk::Stage::Failed; }));
        QVERIFY(!find<QPushButton>("markerSave").isEnabled());
        QVERIFY(!find<QPushButton>("markerImprove").isEnabled());
        QVERIFY(find<QPushButton>("markerAgain").isEnabled());
        QVERIFY(find<QLabel>("markerFigures").text().isEmpty());
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(rests());
        QVERIFY(find<QPushButton>("markerSave").isEnabled());
    }

    void aSearchThatIsStoppedAtOnceBeginsAgain() {
        openSheets();
        layOnCloth();
        MarkerSettings settings = desk().settings();
        settings.gap = 3;
        desk().setSettings("Gap", settings);
        desk().stop();
        QVERIFY(!desk().isCurrent());  // what is seen is of before
        QVERIFY(!find<QPushButton>("markerSave").isEnabled());
        QVERIFY(desk().problem().contains("stopped"));
        click("markerAgain");
        QVERIFY(rests());
        QVERIFY(desk().problem().isEmpty());
        QVERIFY(find<QPushButton>("markerSave").isEnabled());
    }

    void whatIsOutOfDateIsToBeFlattenedFirst() {
        openSheets();
        fixture_.workspace().setAutoFlatten(false);
        layOnCloth();
        DocumentState next = document().state();
        next.options.method = next.options.method == Method::Lscm ? Method::Natural : Method::Lscm;
        document().edit("Method", std::move(next));
        QVERIFY(comes([this] { return desk().stage() == MarkerDesk::Stage::Nothing; }));
        QVERIFY2(desk().problem().contains("out of date"), qPrintable(desk().problem()));
    }

    void seamsMatchWhereThereIsARepeat() {
        test::writeObj(fixture_.path("sewn.obj").toStdString(), test::sewnCapParts());
        QVERIFY(fixture_.openAndWait(fixture_.path("sewn.obj")));
        layOnCloth();
        auto& seams = find<QListWidget>("markerMatched");
        QVERIFY(!seams.isVisible());
        type(find<LengthEdit>("markerRepeatWarp"), "40");
        QVERIFY(rests());
        QVERIFY(seams.isVisible());
        QVERIFY(seams.count() > 0);
        seams.setFocus();
        seams.setCurrentRow(0);
        QTest::keyClick(&seams, Qt::Key_Space);
        QVERIFY(comes([this] { return plan().settings.matched.size() == 1; }));
        QCOMPARE(QString::fromStdString(plan().settings.matched.front()), seams.item(0)->text());
        QVERIFY(rests());
        MarkerSettings settings = desk().settings();
        settings.matched = {"of another piece"};
        desk().setSettings("Seams", settings);
        QTest::keyClick(&seams, Qt::Key_Space);
        QVERIFY(comes([this] { return plan().settings.matched.size() == 2; }));
        fixture_.action(ActionId::Undo).trigger();
        QCOMPARE(plan().settings.matched.size(), std::size_t(1));
        fixture_.action(ActionId::Undo).trigger();
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(plan().settings.matched.empty());
        QCOMPARE(seams.item(0)->checkState(), Qt::Unchecked);
    }

    void minutesGoByTheRateThatIsTyped() {
        test::writeObj(fixture_.path("sewn.obj").toStdString(), test::sewnCapParts());
        QVERIFY(fixture_.openAndWait(fixture_.path("sewn.obj")));
        layOnCloth();
        QVERIFY(!fixture_.preferences().sewingRate());
        type(find<QDoubleSpinBox>("markerRate"), "100");
        QCOMPARE(fixture_.preferences().sewingRate().value_or(0), 100.0);
        const QString minutes = QString::number(100 * desk().figures().seamMetres, 'f', 0);
        QVERIFY(find<QLabel>("markerDetails").text().contains(minutes + " min"));
    }

    void aFileIsWritten() {
        openSheets();
        layOnCloth();
        const QString path = fixture_.path("cloth.svg");
        QString suggested;
        fixture_.window().garmentActions().fileDialogs().save =
            [&](QWidget*, const QString& suggestion, const QString&) {
                suggested = suggestion;
                return path;
            };
        click("markerSave");
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(suggested.endsWith("sheets-marker.pdf"));
        QVERIFY(QFileInfo(path).size() > 1000);
        QVERIFY(comes([this] { return find<QLabel>("markerSaid").text().contains("cloth.svg"); }));
    }

    void itWorksNoMoreOnceItIsClosed() {
        openSheets();
        layOnCloth();
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(!window().isVisible());
        QVERIFY(!desk().marker());
        QVERIFY(!desk().isRunning());
    }

    /// The last: what has been translated stays.
    void itSpeaksGerman() {
        useLanguage(Language::German);
        fixture_.close();
        fixture_.open();
        openSheets();
        layOnCloth();
        QCOMPARE(window().windowTitle(), QString::fromUtf8("Schnittbild"));
        QVERIFY(find<QLabel>("markerDetails").text().contains("Teile"));
    }
};

TOILE_WINDOW_TEST(MarkerWindowTest)

#include "marker_window_test.moc"
