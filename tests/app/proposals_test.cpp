// SPDX-License-Identifier: GPL-3.0-or-later
// Proposed cuts in the window: real keys and clicks, what the garment is then, and what the history
// keeps of it.
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyleOptionViewItem>
#include <QTreeWidget>
#include <algorithm>

#include "app/document/document.h"
#include "app/panels/cut_chart.h"
#include "app/panels/proposals_form.h"
#include "app/session/cut_proposals.h"
#include "app/settings/language.h"
#include "app/text/proposed_name.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"
#include "tests/core/support/shapes.h"
#include "tests/core/tailor/worn_shapes.h"

using namespace toile;
using namespace toile::app;

class ProposalsTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    CutProposals& proposals() { return fixture_.workspace().proposals(); }
    QTreeWidget& table() { return fixture_.find<QTreeWidget>("proposalTable"); }
    CutChart& chart() { return fixture_.find<CutChart>("cutChart"); }
    bool isThere() {
        for (const auto* form : fixture_.window().findChildren<ProposalsForm*>()) {
            if (form->isVisible()) {
                return true;
            }
        }
        return false;
    }
    QString saying() { return fixture_.find<QLabel>("proposalsSaying").text(); }

    void open(const char* file) { QVERIFY(fixture_.openAndWait(fixture_.path(file))); }

    bool isKnown() {
        return QTest::qWaitFor([this] { return proposals().state() == CutProposals::State::Known; },
                               test::kPatience);
    }

    void propose() {
        fixture_.action(ActionId::ProposeCuts).trigger();
        QVERIFY(isThere());
        QApplication::setActiveWindow(table().window());
        QVERIFY(isKnown());
    }

    void click(const char* button) {
        QTest::mouseClick(&fixture_.find<QPushButton>(button), Qt::LeftButton);
    }

    int rowOf(const QString& name) {
        const auto found = table().findItems(name, Qt::MatchExactly);
        return found.isEmpty() ? -1 : table().indexOfTopLevelItem(found.front());
    }

    /// On the screen, of a point of a cut that is seen; the garment is looked at from ahead.
    QPointF onScreen(const Eigen::Vector3d& point) {
        return fixture_.garmentView().wornPlace(point)->at;
    }

    /// A point of a cut that nothing hides.
    std::optional<Eigen::Vector3d> seenOf(std::size_t cut) {
        const auto line = proposals().shaper()->drawn(proposals().lines()[cut], 5);
        for (std::size_t k = line.size() / 3; k < line.size(); ++k) {
            const auto place = fixture_.garmentView().wornPlace(line[k]);
            if (place && !place->isHidden) {
                return line[k];
            }
        }
        return std::nullopt;
    }

    /// A handle of a cut that nothing hides.
    std::optional<int> seenHandle(std::size_t cut, bool onRim) {
        for (const int k : handlesOf(proposals().lines(), cut)) {
            const Eigen::Vector3d& point = proposals().lines()[cut].points[std::size_t(k)];
            const auto place = fixture_.garmentView().wornPlace(point);
            if (place && !place->isHidden && proposals().shaper()->isOnRim(point) == onRim) {
                return k;
            }
        }
        return std::nullopt;
    }

    /// A handle that only its own line has, and a cut that has one.
    std::pair<std::size_t, int> loneHandle() {
        const auto& lines = proposals().lines();
        for (std::size_t cut = 0; cut < lines.size(); ++cut) {
            for (const int handle : handlesOf(lines, cut)) {
                const Eigen::Vector3d& point = lines[cut].points[std::size_t(handle)];
                const auto others = std::ranges::count_if(lines, [&point](const UserCut& line) {
                    return std::ranges::find(line.points, point) != line.points.end();
                });
                if (others == 1) {
                    return {cut, handle};
                }
            }
        }
        return {0, -1};
    }

    /// As a drag would. @return whether anything has moved
    bool move(std::size_t cut, int handle, const Eigen::Vector3d& by) {
        const std::vector<UserCut> before = proposals().lines();
        proposals().beginMove(cut, handle);
        proposals().moveTo(before[cut].points[std::size_t(handle)] + by);
        proposals().endMove();
        return proposals().lines() != before;
    }

    void type(QLineEdit& field, const QString& text) {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

    QStringList namesOfPieces() {
        QStringList names;
        for (int piece = 0; piece < document().pieceCount(); ++piece) {
            names.append(pieceName(document(), piece));
        }
        names.sort();
        return names;
    }

    std::size_t ownCuts() { return document().loading().seams.cuts.size(); }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("shirt.obj").toStdString(), {{"shirt", test::wornShirt()}});
        test::writeObj(fixture_.path("skirt.obj").toStdString(), {{"skirt", test::wornSkirt()}});
        test::writeObj(fixture_.path("sheet.obj").toStdString(),
                       {{"sheet", test::makeSheet(200, 150, 8, 6)}});
        test::writeObj(fixture_.path("moebius.obj").toStdString(),
                       {{"moebius", test::moebiusStrip(20)}});
    }

    void init() {
        fixture_.open();
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
    }
    void cleanup() { fixture_.close(); }

    void closedTheyLeaveNoTrace() {
        open("shirt.obj");
        const test::Moment before = test::momentOf(document());
        const int steps = document().history().count();
        propose();
        QVERIFY(table().topLevelItemCount() >= 6);
        QVERIFY(rowOf("left side") >= 0);
        QTest::keyClick(&table(), Qt::Key_Escape);
        QVERIFY(!proposals().isOpen());
        QVERIFY(!isThere());
        QVERIFY(test::momentOf(document()) == before);
        QCOMPARE(document().history().count(), steps);
    }

    void allAreOneStep() {
        open("shirt.obj");
        QVERIFY(!document().result(0)->flat);
        propose();
        const std::size_t taken = proposals().takenCount();
        QVERIFY(taken >= 6);
        click("proposalsMake");
        QVERIFY(!isThere());
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().history().undoText(), QString("Make proposed cuts"));
        QCOMPARE(ownCuts(), taken);
        QCOMPARE(document().pieceCount(), 4);
        for (int piece = 0; piece < 4; ++piece) {
            QVERIFY(document().result(piece)->flat);
        }
        const auto& cuts = document().garment()->cuts;
        QVERIFY(std::ranges::any_of(cuts, [](const AppliedCut& cut) {
            return cut.name == "left side" && cut.author == CutAuthor::User &&
                   !cut.evidence.empty();
        }));
        QTRY_COMPARE(namesOfPieces(),
                     (QStringList{"back", "front", "left sleeve", "right sleeve"}));
        QCOMPARE(document().history().undoText(), QString("Make proposed cuts"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 1);
        QCOMPARE(ownCuts(), std::size_t{0});
    }

    void whatIsNotTickedIsNotMade() {
        open("shirt.obj");
        propose();
        const std::size_t taken = proposals().takenCount();
        table().setCurrentItem(table().topLevelItem(rowOf("left side")));
        QTest::keyClick(&table(), Qt::Key_Space);
        QCOMPARE(proposals().takenCount(), taken - 1);
        click("proposalsMake");
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(ownCuts(), taken - 1);
        for (const UserCut& cut : document().loading().seams.cuts) {
            QVERIFY(cut.name != "left side");
        }
    }

    void oneIsMadeAndTheOthersStay() {
        open("shirt.obj");
        propose();
        const int rows = table().topLevelItemCount();
        table().setCurrentItem(table().topLevelItem(rowOf("left armhole")));
        QVERIFY(table().hasFocus());
        QTest::keyClick(&table(), Qt::Key_Return);
        QCOMPARE(document().history().undoText(), QString("Cut along left armhole"));
        QVERIFY(isThere());
        QVERIFY(fixture_.waitForResults());
        QVERIFY(isKnown());
        QCOMPARE(ownCuts(), std::size_t{1});
        QVERIFY(rowOf("left armhole") < 0 || table().topLevelItemCount() <= rows);
        QVERIFY(proposals().piece() == document().garment()->uncut[0]);
        // Taken back, it is proposed again.
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(isKnown());
        QTRY_VERIFY_WITH_TIMEOUT(rowOf("left armhole") >= 0, test::kPatience);
        QCOMPARE(ownCuts(), std::size_t{0});
    }

    void rowChartAndLineSelectEachOther() {
        open("shirt.obj");
        propose();
        const int side = rowOf("left side");
        table().setCurrentItem(table().topLevelItem(side));
        QCOMPARE(proposals().selected(), std::optional(std::size_t(side)));
        QVERIFY(chart().accessibleDescription().startsWith("left side"));
        // A line in the view.
        const auto armhole = static_cast<std::size_t>(rowOf("left armhole"));
        const auto seen = seenOf(armhole);
        QVERIFY(seen);
        test::click(fixture_.garmentView(), onScreen(*seen));
        QVERIFY(proposals().selected());
        QCOMPARE(table().indexOfTopLevelItem(table().currentItem()),
                 static_cast<int>(*proposals().selected()));
        QVERIFY(document().selection().empty());  // the piece under it is not meant
        // A point of the chart, and the keys there.
        QTest::mouseClick(&chart(), Qt::LeftButton, {}, chart().placeOf(1).toPoint());
        QVERIFY(proposals().selected());
        chart().setFocus();
        proposals().select(0);
        QTest::keyClick(&chart(), Qt::Key_Right);
        QCOMPARE(proposals().selected(), std::optional(std::size_t(1)));
        QCOMPARE(table().indexOfTopLevelItem(table().currentItem()), 1);
    }

    void clicksBesideTheLinesMeanWhatTheyDo() {
        open("shirt.obj");
        propose();
        test::click(fixture_.garmentView(), onScreen({20, 150, 80}));
        QCOMPARE(document().selection(), Document::Selection{0});
        QVERIFY(!proposals().selected());
        const double yaw = fixture_.garmentView().camera().yaw();
        test::drag(fixture_.garmentView(), onScreen({20, 150, 80}), onScreen({90, 150, 80}));
        QVERIFY(fixture_.garmentView().camera().yaw() != yaw);
    }

    void aHandleIsDraggedAndTakenBack() {
        open("shirt.obj");
        propose();
        const auto cut = static_cast<std::size_t>(rowOf("left armhole"));
        proposals().select(cut);
        const auto handle = seenHandle(cut, false);
        QVERIFY(handle);
        const std::vector<UserCut> before = proposals().lines();
        const Eigen::Vector3d from = before[cut].points[std::size_t(*handle)];
        const QPointF at = onScreen(from);
        const double yaw = fixture_.garmentView().camera().yaw();
        const int steps = document().history().count();
        test::drag(fixture_.garmentView(), at, at + QPointF(-25, -12));
        QCOMPARE(fixture_.garmentView().camera().yaw(), yaw);
        const Eigen::Vector3d moved = proposals().lines()[cut].points[std::size_t(*handle)];
        QVERIFY((moved - from).norm() > 5);
        QVERIFY(QLineF(onScreen(moved), at + QPointF(-25, -12)).length() < 2);
        // What met it there does so still.
        for (std::size_t k = 0; k < before.size(); ++k) {
            for (std::size_t p = 0; p < before[k].points.size(); ++p) {
                if (before[k].points[p] == from) {
                    QVERIFY(proposals().lines()[k].points[p] == moved);
                }
            }
        }
        QVERIFY(proposals().isStale(cut));
        QCOMPARE(document().history().count(), steps);
        QVERIFY(fixture_.action(ActionId::Undo).isEnabled());
        QVERIFY(fixture_.action(ActionId::Undo).text().contains("proposed cut"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(proposals().lines() == before);
        QVERIFY(!proposals().isStale(cut));
        QVERIFY(!proposals().hasMoves());
    }

    void whatWasMovedIsFlattenedAnewAfterAPause() {
        open("shirt.obj");
        propose();
        QTRY_VERIFY_WITH_TIMEOUT(!proposals().isSolving(), test::kPatience);
        QVERIFY(proposals().advice().cuts[0].solved);
        const UserCut before = proposals().lines()[0];
        const int handle = handlesOf(proposals().lines(), 0)[1];
        proposals().beginMove(0, handle);
        proposals().moveTo(before.points[std::size_t(handle)] + Eigen::Vector3d(0, 12, 20));
        QVERIFY(!proposals().advice().cuts[0].solved);
        proposals().endMove();
        QCOMPARE(proposals().advice().cuts[0].length, lengthAlong(proposals().lines()[0]));
        QTRY_VERIFY_WITH_TIMEOUT(proposals().advice().cuts[0].solved, test::kPatience);
        QVERIFY(proposals().isStale(0));
    }

    void escapeInADragPutsTheHandleBack() {
        open("shirt.obj");
        propose();
        const auto cut = static_cast<std::size_t>(rowOf("left armhole"));
        proposals().select(cut);
        const auto handle = seenHandle(cut, false);
        QVERIFY(handle);
        const std::vector<UserCut> before = proposals().lines();
        const QPointF at = onScreen(before[cut].points[std::size_t(*handle)]);
        GarmentView& view = fixture_.garmentView();
        view.setFocus();
        test::sendMouse(view, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
        test::sendMouse(view, QEvent::MouseMove, at + QPointF(-30, 0), Qt::NoButton,
                        Qt::LeftButton);
        QVERIFY(proposals().lines() != before);
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(proposals().lines() == before);
        test::sendMouse(view, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
        QVERIFY(proposals().isOpen());
        QVERIFY(!proposals().hasMoves());
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(!proposals().isOpen());
    }

    void aHandleThatGoesUnderThePointerIsLetGo() {
        open("shirt.obj");
        GarmentView& view = fixture_.garmentView();
        for (const bool isAskedAnew : {true, false}) {
            propose();
            const auto cut = static_cast<std::size_t>(rowOf("left armhole"));
            proposals().select(cut);
            const auto handle = seenHandle(cut, false);
            QVERIFY(handle);
            const QPointF at = onScreen(proposals().lines()[cut].points[std::size_t(*handle)]);
            test::sendMouse(view, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
            QVERIFY(proposals().isMoving());
            if (isAskedAnew) {
                proposals().swapFront();
                QVERIFY(isKnown());
            } else {
                proposals().close();
            }
            const std::vector<UserCut> lines = proposals().lines();
            test::sendMouse(view, QEvent::MouseMove, at + QPointF(-30, 0), Qt::NoButton,
                            Qt::LeftButton);
            test::sendMouse(view, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
            QVERIFY(proposals().lines() == lines);
            QVERIFY(!proposals().hasMoves());
        }
    }

    void aMoveOfACutThatIsMadeIsNoneOfTheOthers() {
        open("shirt.obj");
        propose();
        const auto [cut, handle] = loneHandle();
        QVERIFY(handle >= 0);
        QVERIFY(move(cut, handle, {0, 12, 8}));
        QVERIFY(proposals().hasMoves());
        proposals().make(cut);
        QVERIFY(!proposals().hasMoves());
        QVERIFY(fixture_.waitForResults());
        fixture_.action(ActionId::Undo).trigger();  // the cut, at once
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(ownCuts(), std::size_t{0});
    }

    void whatIsRefusedIsAskedForAnew() {
        open("shirt.obj");
        propose();
        const std::size_t count = proposals().lines().size();
        proposals().make(0);
        QCOMPARE(proposals().lines().size(), count - 1);
        emit fixture_.workspace().refused("It opens nothing.");
        QCOMPARE(proposals().state(), CutProposals::State::Asking);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(isKnown());
    }

    void whatIsCancelledIsProposedAgain() {
        open("shirt.obj");
        propose();
        const std::size_t count = proposals().lines().size();
        proposals().make(0);
        fixture_.action(ActionId::Cancel).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY(isKnown());
        QCOMPARE(ownCuts() + proposals().lines().size(), count);
    }

    void whatIsEnoughIsNoReasonToDropWhatWasMoved() {
        open("shirt.obj");
        propose();
        QTRY_VERIFY_WITH_TIMEOUT(!proposals().isSolving(), test::kPatience);
        const std::size_t usual = proposals().takenCount();
        const auto [cut, handle] = loneHandle();
        QVERIFY(move(cut, handle, {0, 12, 8}));
        const std::vector<UserCut> moved = proposals().lines();
        auto& field = fixture_.find<QLineEdit>("proposalsEnough");
        type(field, "90 %");
        QCOMPARE(proposals().state(), CutProposals::State::Known);
        QCOMPARE(proposals().takenCount(), std::size_t{0});
        QVERIFY(proposals().lines() == moved);
        field.selectAll();
        QTest::keyClick(&field, Qt::Key_Delete);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(proposals().takenCount(), usual);
        QVERIFY(proposals().takeMoveBack());
    }

    void enoughIsKeptAsItWasTyped() {
        open("shirt.obj");
        propose();
        auto& field = fixture_.find<QLineEdit>("proposalsEnough");
        type(field, "1.26 %");
        QCOMPARE(proposals().enough(), std::optional(0.0126));
        QCOMPARE(field.text(), QString("1.3 %"));
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(proposals().enough(), std::optional(0.0126));
    }

    void figuresOfWhatDidNotMoveStay() {
        open("shirt.obj");
        propose();
        type(fixture_.find<QLineEdit>("proposalsEnough"), "0.1 %");  // with darts
        QTRY_VERIFY_WITH_TIMEOUT(!proposals().isSolving(), test::kPatience);
        const auto figures = [this] {
            std::vector<std::pair<double, std::optional<DartIntake>>> all;
            for (const AdvisedCut& cut : proposals().advice().cuts) {
                all.emplace_back(cut.length, cut.intake);
            }
            return all;
        };
        const auto before = figures();
        const auto solved = proposals().advice().cuts[0].solved;
        const auto [cut, handle] = loneHandle();
        QVERIFY(move(cut, handle, {0, 12, 8}));
        const auto after = figures();
        for (std::size_t k = 0; k < before.size(); ++k) {
            QCOMPARE(after[k] == before[k], k != cut);
        }
        QVERIFY(!after[cut].second);
        QVERIFY(proposals().takeMoveBack());
        QVERIFY(figures() == before);
        QVERIFY(proposals().advice().cuts[0].solved == solved);
    }

    void clicksOnABoxMakeNothing() {
        open("shirt.obj");
        propose();
        const std::size_t taken = proposals().takenCount();
        const QModelIndex index = table().model()->index(0, 0);
        QStyleOptionViewItem option;
        option.initFrom(&table());
        option.rect = table().visualRect(index);
        option.features |= QStyleOptionViewItem::HasCheckIndicator;
        const QPoint box =
            table()
                .style()
                ->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, &table())
                .center();
        const int steps = document().history().count();
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, box);
        QCOMPARE(proposals().takenCount(), taken - 1);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, box);
        QCOMPARE(proposals().takenCount(), taken - 1);
        QCOMPARE(document().history().count(), steps);
        const QPoint name = option.rect.center() + QPoint(20, 0);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, name);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, name);
        QCOMPARE(document().history().count(), steps + 1);
    }

    void whatNoCutOpensIsSaidToBeSo() {
        open("moebius.obj");
        QVERIFY(document().garment()->pieces[0]->defect);
        fixture_.action(ActionId::ProposeCuts).trigger();
        QCOMPARE(proposals().state(), CutProposals::State::Known);
        QVERIFY(proposals().lines().empty());
        QVERIFY2(saying().startsWith("No cuts can be proposed for this piece. moebius"),
                 qPrintable(saying()));
    }

    void anEndGoesAlongItsRim() {
        open("skirt.obj");
        propose();
        QVERIFY(!proposals().lines().empty());
        std::optional<int> handle;
        std::size_t cut = 0;
        for (; cut < proposals().lines().size() && !handle; ++cut) {
            handle = seenHandle(cut, true);
        }
        if (!handle) {  // sides lie on the silhouette: look at one of them
            fixture_.action(ActionId::LookLeft).trigger();
            for (cut = 0; cut < proposals().lines().size() && !handle; ++cut) {
                handle = seenHandle(cut, true);
            }
        }
        QVERIFY(handle);
        --cut;
        proposals().select(cut);
        const Eigen::Vector3d from = proposals().lines()[cut].points[std::size_t(*handle)];
        const QPointF at = onScreen(from);
        test::drag(fixture_.garmentView(), at, at + QPointF(30, 30));
        const Eigen::Vector3d moved = proposals().lines()[cut].points[std::size_t(*handle)];
        QVERIFY((moved - from).norm() > 5);
        QVERIFY(proposals().shaper()->onRim(moved) == moved ||
                (proposals().shaper()->onRim(moved) - moved).norm() < 1e-9);
    }

    void movedCutsAreMadeAsTheyLie() {
        open("shirt.obj");
        propose();
        const auto cut = static_cast<std::size_t>(rowOf("left armhole"));
        proposals().select(cut);
        const auto handle = seenHandle(cut, false);
        QVERIFY(handle);
        const Eigen::Vector3d from = proposals().lines()[cut].points[std::size_t(*handle)];
        test::drag(fixture_.garmentView(), onScreen(from), onScreen(from) + QPointF(-18, 0));
        const UserCut moved = proposals().lines()[cut];
        click("proposalsMake");
        QVERIFY(fixture_.waitForResults());
        const auto& cuts = document().loading().seams.cuts;
        const auto made = std::ranges::find(cuts, moved.name, &UserCut::name);
        QVERIFY(made != cuts.end());
        QVERIFY((made->points[std::size_t(*handle)] - moved.points[std::size_t(*handle)]).norm() <
                1e-9);
    }

    void frontAndBackAreSwapped() {
        open("shirt.obj");
        propose();
        QVERIFY(!proposals().isFrontSwapped());
        click("proposalsSwap");
        QVERIFY(isKnown());
        QVERIFY(proposals().isFrontSwapped());
        QVERIFY(table().topLevelItemCount() > 0);
    }

    void enoughIsTypedOrTheFabrics() {
        open("shirt.obj");
        propose();
        QVERIFY(!proposals().enough());
        auto& field = fixture_.find<QLineEdit>("proposalsEnough");
        field.setFocus();
        QTest::keyClicks(&field, "2,5 %");
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(isThere());  // Enter takes what was typed, no more
        QCOMPARE(proposals().enough(), std::optional(0.025));
        QVERIFY(isKnown());
        field.selectAll();
        QTest::keyClick(&field, Qt::Key_Delete);
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(!proposals().enough());
        DocumentState next = document().state();
        next.fabric = *fabricPreset("woven");
        document().edit("Fabric", std::move(next));
        QCOMPARE(proposals().enough(), std::optional(0.02));
        QVERIFY(isKnown());
        QVERIFY(field.placeholderText().contains('2'));
    }

    void anEditOfTheGarmentIsFollowed() {
        open("shirt.obj");
        propose();
        fixture_.workspace().cuts().add({{}, UserCut::Kind::Dart, {{40, 0, 60}, {40, 200, 80}}});
        QTRY_VERIFY_WITH_TIMEOUT(ownCuts() == 1 && document().isCurrent(), test::kPatience);
        QVERIFY(isKnown());
        QVERIFY(isThere());
        // Another garment is another matter.
        open("skirt.obj");
        QVERIFY(!proposals().isOpen());
        QVERIFY(!isThere());
    }

    void theBestAreFlattenedAfterwards() {
        open("shirt.obj");
        propose();
        QTRY_VERIFY_WITH_TIMEOUT(!proposals().isSolving(), test::kPatience);
        const auto& cuts = proposals().advice().cuts;
        const auto solved = std::ranges::count_if(
            cuts, [](const AdvisedCut& cut) { return cut.solved.has_value(); });
        QVERIFY(solved >= 1 && solved <= 5);
        QVERIFY(!saying().contains("Flattening"));
    }

    void whereNothingIsKnownASentenceSaysSo() {
        open("sheet.obj");
        propose();
        QVERIFY(proposals().lines().empty());
        QVERIFY2(saying().contains("sheet") && saying().contains("Cut open"), qPrintable(saying()));
        QVERIFY(!fixture_.find<QPushButton>("proposalsMake").isEnabled());
        QVERIFY(!table().isEnabled());
        click("proposalsClose");
        QVERIFY(!isThere());
    }

    void theFindingOfABranchedTubeOffersThem() {
        open("shirt.obj");
        QVERIFY(QTest::qWaitFor([this] { return fixture_.window().checker().isUpToDate(); },
                                test::kPatience));
        emit fixture_.patternView().helpWanted(0);
        QVERIFY(isThere());
        QVERIFY(isKnown());
    }

    void aSmallScreenHasRoomForThem() {
        fixture_.close();
        fixture_.open({1280, 680});
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        open("shirt.obj");
        propose();
        for (const auto* form : fixture_.window().findChildren<ProposalsForm*>()) {
            QVERIFY2(form->height() <= 560, qPrintable(QString::number(form->height())));
        }
    }

    /// The last: what has been translated stays.
    void germanHasItsOwnNames() {
        useLanguage(Language::German);
        fixture_.close();
        fixture_.open({1280, 680});
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        open("shirt.obj");
        propose();
        const int row = rowOf("linke Seitennaht");
        QVERIFY(row >= 0);
        table().setCurrentItem(table().topLevelItem(row));
        QTest::keyClick(&table(), Qt::Key_Return);
        QCOMPARE(document().history().undoText(), QString("Schnitt: linke Seitennaht"));
        QCOMPARE(document().loading().seams.cuts.back().name, std::string("linke Seitennaht"));
        const std::pair<const char*, const char*> kNumbered[] = {{"dart 2", "Abnäher 2"},
                                                                 {"ridge 3", "Kante 3"},
                                                                 {"style line 2", "Teilungsnaht 2"},
                                                                 {"centre 2", "Mittelnaht 2"},
                                                                 {"opening", "Öffnungsschnitt"},
                                                                 {"dartboard", "dartboard"}};
        for (const auto& [name, german] : kNumbered) {
            QCOMPARE(proposedName(name), std::string(german));
        }
    }
};

TOILE_WINDOW_TEST(ProposalsTest)
#include "proposals_test.moc"
