// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeView>

#include "app/document/layout.h"
#include "app/jobs/ready_checker.h"
#include "app/panels/problems_model.h"
#include "app/render/scene.h"
#include "app/render/scene_builder.h"
#include "app/widgets/banner.h"
#include "core/marker/marker_settings.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// "Ready to cut?" in the window: every kind of finding on a garment that has it, and the way to
/// it.
class ProblemsTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    ReadyChecker& checker() { return fixture_.window().checker(); }
    QTreeView& table() { return fixture_.find<QTreeView>("problemTable"); }
    QString verdict() { return fixture_.find<QLabel>("verdict").text(); }
    QString dockTitle() { return fixture_.find<QDockWidget>("problemsDock").windowTitle(); }

    bool waitForAnswer() {
        return QTest::qWaitFor(
            [this] { return checker().isUpToDate() && !fixture_.workspace().jobs().isBusy(); },
            test::kPatience);
    }

    bool open(const char* file, LengthUnit unit = LengthUnit::Millimetre) {
        fixture_.workspace().setUnit(unit);
        return fixture_.openAndWait(fixture_.path(file)) && setFabric(*fabricPreset("woven"));
    }

    bool setFabric(const Fabric& fabric) {
        DocumentState next = document().state();
        next.fabric = fabric;
        document().edit("Fabric", std::move(next));
        return waitForAnswer();
    }

    std::vector<Finding> findings(FindingKind kind) {
        std::vector<Finding> found;
        for (const Finding& finding : checker().readiness().findings) {
            if (finding.kind == kind) {
                found.push_back(finding);
            }
        }
        return found;
    }

    /// The first row that stands for one finding of this kind, opened up to; invalid: there is
    /// none.
    QModelIndex rowOf(FindingKind kind) {
        const QAbstractItemModel& model = *table().model();
        const auto is = [this, kind](const QModelIndex& index) {
            const auto list = index.data(ProblemsModel::FindingsRole).value<QList<int>>();
            return list.size() == 1 &&
                   checker().readiness().findings[std::size_t(list.front())].kind == kind;
        };
        for (int row = 0; row < model.rowCount(); ++row) {
            const QModelIndex index = model.index(row, 0);
            if (is(index)) {
                return index;
            }
            for (int child = 0; child < model.rowCount(index); ++child) {
                const QModelIndex below = model.index(child, 0, index);
                if (is(below)) {
                    table().expand(index);
                    return below;
                }
            }
        }
        return {};
    }

    void click(const QModelIndex& index) {
        QVERIFY(index.isValid());
        fixture_.action(ActionId::ReadyToCut).trigger();
        table().scrollTo(index);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                          table().visualRect(index).center());
    }

    /// The place of the sheet in the middle of the pattern view, mm.
    Eigen::Vector2d middleOfSheet() {
        return fixture_.window().views().patternView()->camera().visible().center();
    }

    /// The results with the flat points of one piece changed.
    template <class Change>
    void spoil(std::size_t piece, const Change& change) {
        PieceResults results = document().results();
        auto spoilt = std::make_shared<PieceResult>(*results[piece]);
        change(spoilt->flat->Q);
        spoilt->quality = measure(*spoilt->piece, spoilt->flat->Q);
        results[piece] = spoilt;
        Progress progress;
        auto scene = buildScene(*document().garment(), results, progress);
        test::setResults(document(), std::move(results), std::move(scene));
        QVERIFY(waitForAnswer());
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        const auto write = [this](const char* file, const auto& pieces) {
            test::writeObj(fixture_.path(file).toStdString(), pieces);
        };
        using Pieces = std::vector<std::pair<std::string, MeshArrays>>;
        MeshArrays back = test::makeSheet(400, 600, 8, 12, Eigen::Vector3d(0, 0, -300));
        write("same-way.obj", Pieces{{"front", test::makeSheet(400, 600, 8, 12)}, {"back", back}});
        back.F.col(0).swap(back.F.col(1));  // looks outwards
        write("sheets.obj", Pieces{{"front", test::makeSheet(400, 600, 8, 12)}, {"back", back}});
        write("cap.obj", test::sewnCapParts());
        write("ball.obj",
              Pieces{{"ball", test::makeTetrahedron(300)},
                     {"flap", test::makeSheet(300, 400, 3, 4, Eigen::Vector3d(600, 0, 0))}});
        write("doll.obj", Pieces{{"doll", test::makeSheet(12, 20, 4, 6)}});
    }

    void init() { fixture_.open(); }
    void cleanup() { fixture_.close(); }

    void clothWithStatedGrainIsReadyToCut() {
        QVERIFY(open("sheets.obj"));
        QCOMPARE(verdict(), QString("No errors, 2 warnings"));
        QCOMPARE(dockTitle(), QString("Problems (2)"));
        QCOMPARE(findings(FindingKind::GrainMissing).size(), std::size_t(2));
        setGrain(document(), "Turn", {{0, 1.0}, {1, 1.0}});
        QVERIFY(waitForAnswer());
        QCOMPARE(verdict(), QString("Ready to cut"));
        QCOMPARE(dockTitle(), QString("Problems"));
        QVERIFY(fixture_.find<QLabel>("problemsEmpty").text().contains("seams match"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(waitForAnswer());
        QCOMPARE(verdict(), QString("No errors, 2 warnings"));
    }

    void whatIsSaidOfTheMarkerIsLookedAtAndWhereCopiesLieIsNot() {
        QVERIFY(open("sheets.obj"));
        QVERIFY(findings(FindingKind::WiderThanCloth).empty());
        const auto say = [this](double width, std::vector<KeptCopy> kept) {
            DocumentState next = document().state();
            next.markers = next.markers.with("", {{.width = width}, std::move(kept)});
            document().edit("Marker", std::move(next));
        };
        say(300, {});  // the sheets are 400 mm wide
        QVERIFY(!checker().isUpToDate());
        QVERIFY(waitForAnswer());
        QCOMPARE(findings(FindingKind::WiderThanCloth).size(), std::size_t(2));
        const CutPlan plan = checker().plan();
        const PieceId first = document().garment()->pieces[0]->id;
        say(300, std::vector{KeptCopy{{first, 0}, 0, Placement{{10, 20}}}});
        QVERIFY(waitForAnswer());
        QVERIFY(checker().plan() == plan);
        fixture_.action(ActionId::Undo).trigger();
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(waitForAnswer());
        QVERIFY(findings(FindingKind::WiderThanCloth).empty());
    }

    void pieceWithoutGrainIsSelectedAndFramed() {
        QVERIFY(open("sheets.obj"));
        click(rowOf(FindingKind::GrainMissing));
        QCOMPARE(document().selection(), Document::Selection{0});
        const Eigen::Vector2d off = middleOfSheet() - boxOnSheet(document(), 0).center();
        QVERIFY(off.norm() < 60);  // captions and rulers take some room
        // The row over both stands for both.
        click(rowOf(FindingKind::GrainMissing).parent());
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));
    }

    void seamThatDoesNotMatchIsSelected() {
        fixture_.workspace().setMethod(Method::Natural);
        QVERIFY(open("cap.obj"));
        QCOMPARE(findings(FindingKind::SeamLengths).size(), std::size_t(1));
        QVERIFY2(verdict().contains("error"), qPrintable(verdict()));
        document().setSelection({0});
        fixture_.action(ActionId::Frame).trigger();
        const Eigen::Vector2d before = middleOfSheet();
        click(rowOf(FindingKind::SeamLengths));
        QCOMPARE(document().seam(), std::optional(findings(FindingKind::SeamLengths)[0].seam));
        QVERIFY((middleOfSheet() - before).norm() > 1);
        // The cause is the method: with another the fault is gone, and undo brings it back.
        fixture_.workspace().setMethod(Method::Isometric);
        QTRY_VERIFY_WITH_TIMEOUT(findings(FindingKind::SeamLengths).empty(), test::kPatience);
        fixture_.action(ActionId::Undo).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(findings(FindingKind::SeamLengths).size(), std::size_t(1),
                                  test::kPatience);
    }

    void strainShowsItsDirectionAtItsPlace() {
        QVERIFY(open("sheets.obj"));
        const struct {
            FindingKind kind;
            Overlay overlay;
            double x, y;
        } cases[] = {{FindingKind::StrainWarp, Overlay::Warp, 1, 1.1},
                     {FindingKind::StrainWeft, Overlay::Weft, 1.1, 1}};
        for (const auto& one : cases) {
            spoil(1, [&](Points2& Q) {
                Q.col(0) /= one.x;
                Q.col(1) /= one.y;
            });
            click(rowOf(one.kind));
            QCOMPARE(document().view().overlay, one.overlay);
            QCOMPARE(document().selection(), Document::Selection{1});
            const auto& spot = fixture_.window().views().patternView()->shownSpot();
            QVERIFY(spot);
            QCOMPARE(spot->piece, 1);
            QVERIFY((spot->flat - findings(one.kind)[0].place->flat).norm() < 1e-9);
            QVERIFY(fixture_.window().views().garmentView()->shownSpot());
            spoil(1, [&](Points2& Q) {
                Q.col(0) *= one.x;
                Q.col(1) *= one.y;
            });
            QVERIFY(findings(one.kind).empty());
        }
    }

    void strainOnTheBiasIsShownToo() {
        QVERIFY(open("sheets.obj"));
        spoil(0, [](Points2& Q) { Q.col(0) += 0.3 * Q.col(1); });
        click(rowOf(FindingKind::StrainBias));
        QCOMPARE(document().view().overlay, Overlay::Bias);
    }

    void anotherFabricEndsTheStrain() {
        QVERIFY(open("sheets.obj"));
        spoil(0, [](Points2& Q) { Q /= 1.1; });
        QVERIFY(!findings(FindingKind::StrainWarp).empty());
        DocumentState next = document().state();
        next.fabric = *fabricPreset("jersey");
        document().edit("Fabric", next);
        QVERIFY(waitForAnswer());
        QVERIFY(findings(FindingKind::StrainWarp).empty());
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(waitForAnswer());
        QVERIFY(!findings(FindingKind::StrainWarp).empty());
    }

    void placeShownIsInTheMiddleOfBothViews() {
        QVERIFY(open("sheets.obj"));
        spoil(1, [](Points2& Q) { Q.row(40).array() += 30; });
        const QModelIndex row = rowOf(FindingKind::StrainWarp);
        click(row);
        const Finding finding = findings(FindingKind::StrainWarp)[0];
        const auto& views = fixture_.window().views();
        const QPointF middle(views.patternView()->width() / 2.0,
                             views.patternView()->height() / 2.0);
        const Eigen::Vector2d at = views.patternView()->camera().toScreen(
            placementOf(document(), 1).applied(finding.place->flat));
        QVERIFY((QPointF(at.x(), at.y()) - middle).manhattanLength() < 60);
        const Eigen::Vector2d worn = views.garmentView()->camera().project(
            finding.place->position - document().scene()->origin);
        const QPointF centre(views.garmentView()->width() / 2.0,
                             views.garmentView()->height() / 2.0);
        QVERIFY((QPointF(worn.x(), worn.y()) - centre).manhattanLength() < 5);
        document().setSelection({});
        QVERIFY(!views.patternView()->shownSpot());
    }

    void hiddenPlaceIsSeenFromTheOtherSide() {
        QVERIFY(open("same-way.obj"));
        fixture_.action(ActionId::LookFront).trigger();
        spoil(1, [](Points2& Q) { Q.row(40).array() += 30; });  // behind the other sheet
        click(rowOf(FindingKind::StrainWarp));
        // Its right side faces the front, where the other hides it: it is seen from behind.
        const auto& view = *fixture_.window().views().garmentView();
        const auto hit = view.hitAt(QPointF(view.width() / 2.0, view.height() / 2.0));
        QVERIFY(hit);
        QCOMPARE(hit->piece, 1);
        const Finding finding = findings(FindingKind::StrainWarp)[0];
        const Eigen::Vector3d toEye =
            view.camera().eye() + document().scene()->origin - finding.place->position;
        QVERIFY(toEye.dot(finding.place->normal) < 0);
    }

    void flippedTrianglesAreShownPerTriangle() {
        QVERIFY(open("sheets.obj"));
        spoil(0, [](Points2& Q) { Q.row(40).array() += 120; });
        QVERIFY(!findings(FindingKind::FlippedTriangles).empty());
        click(rowOf(FindingKind::FlippedTriangles));
        QCOMPARE(document().view().overlay, Overlay::Area);
        QVERIFY(document().view().valuesPerTriangle);
        QVERIFY(fixture_.window().views().patternView()->shownSpot());
    }

    void outlineThatCrossesIsShownWhereItDoes() {
        QVERIFY(open("sheets.obj"));
        // A corner goes through the opposite edge.
        spoil(0, [](Points2& Q) { Q.row(0) = Q.row(Q.rows() - 1) + Eigen::RowVector2d(200, 300); });
        click(rowOf(FindingKind::OutlineCrosses));
        QCOMPARE(document().selection(), Document::Selection{0});
        QVERIFY(fixture_.window().views().patternView()->shownSpot());
    }

    void pieceThatIsNotFlatIsSelected() {
        QVERIFY(open("ball.obj"));
        const QModelIndex row = rowOf(FindingKind::NotFlat);
        click(row);
        QCOMPARE(document().selection(), Document::Selection{0});
        QVERIFY(row.siblingAtColumn(ProblemsModel::Problem).data().toString().contains("closed"));
        QVERIFY(row.siblingAtColumn(ProblemsModel::Advice).data().toString().contains("Cut it"));
    }

    void overlapOnTheSheetSelectsBothAndUndoEndsIt() {
        QVERIFY(open("sheets.obj"));
        place(document(), "Move", {{1, placementOf(document(), 0)}});
        QVERIFY(waitForAnswer());
        click(rowOf(FindingKind::PiecesOverlap));
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(waitForAnswer());
        QVERIFY(findings(FindingKind::PiecesOverlap).empty());
    }

    void unitInDoubtIsADoubtUntilItIsKept() {
        QVERIFY(fixture_.openAndWait(fixture_.path("doll.obj")) && waitForAnswer());
        QCOMPARE(findings(FindingKind::UnitInDoubt).size(), std::size_t(1));
        click(rowOf(FindingKind::UnitInDoubt));
        auto& keep = fixture_.find<QPushButton>("keepGuess");
        QVERIFY(keep.isVisible());
        QTest::mouseClick(&keep, Qt::LeftButton);
        QVERIFY(waitForAnswer());
        QVERIFY(findings(FindingKind::UnitInDoubt).empty());
    }

    void enterGoesThereAsAClickDoes() {
        QVERIFY(open("sheets.obj"));
        const QModelIndex row = rowOf(FindingKind::GrainMissing);
        fixture_.action(ActionId::GoToProblems).trigger();
        QVERIFY(table().hasFocus());
        table().setCurrentIndex(row);
        QVERIFY(document().selection().empty());
        QTest::keyClick(&table(), Qt::Key_Return);
        QCOMPARE(document().selection(), Document::Selection{0});
    }

    void severitiesCanBeHidden() {
        QVERIFY(open("sheets.obj"));
        auto& doubts = fixture_.find<QToolButton>("showDoubts");
        QCOMPARE(doubts.text(), QString("2 warnings"));
        QVERIFY(!fixture_.find<QToolButton>("showFaults").isEnabled());
        fixture_.action(ActionId::ReadyToCut).trigger();
        QTest::mouseClick(&doubts, Qt::LeftButton);
        QCOMPARE(table().model()->rowCount(), 0);
        QVERIFY(fixture_.find<QLabel>("problemsEmpty").text().contains("hidden"));
        QCOMPARE(verdict(), QString("No errors, 2 warnings"));
        QTest::mouseClick(&doubts, Qt::LeftButton);
        QVERIFY(table().model()->rowCount() > 0);
    }

    void actionBringsTheVerdictToTheFront() {
        QVERIFY(open("sheets.obj"));
        fixture_.action(ActionId::GoToPieces).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(table().viewport()->visibleRegion().isEmpty(), test::kPatience);
        QTest::keyClick(&fixture_.window(), Qt::Key_F8);
        QTRY_VERIFY_WITH_TIMEOUT(!table().viewport()->visibleRegion().isEmpty(), test::kPatience);
        QVERIFY(fixture_.find<QLabel>("verdict").isVisible());
    }

    void changedOptionsAreNotFlattenedYet() {
        QVERIFY(open("sheets.obj"));
        fixture_.workspace().setAutoFlatten(false);
        fixture_.workspace().setMethod(Method::Natural);
        QVERIFY(waitForAnswer());
        QCOMPARE(verdict(), QString("Not flattened yet"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(waitForAnswer());
        QCOMPARE(verdict(), QString("No errors, 2 warnings"));
    }

    void exportTellsOfFaultsThatAreLeft() {
        QVERIFY(open("sheets.obj"));
        const auto write = [this](const char* file) {
            QSignalSpy exported(&fixture_.workspace(), &Workspace::exported);
            fixture_.workspace().exportTo(fixture_.path(file).toStdString());
            QVERIFY(exported.wait(test::kPatience));
        };
        write("a.svg");
        const QString clean = fixture_.window().statusBar()->currentMessage();
        QVERIFY2(clean.startsWith("Written") && !clean.contains("left"), qPrintable(clean));
        spoil(0, [](Points2& Q) { Q /= 1.5; });
        Fabric typed = *fabricPreset("woven");
        typed.id = "custom";  // a rule of thumb makes no faults
        QVERIFY(setFabric(typed));
        write("b.svg");
        const QString message = fixture_.window().statusBar()->currentMessage();
        QVERIFY2(message.contains("errors left"), qPrintable(message));
    }

    void manyChangesAreAnsweredOnce() {
        QVERIFY(open("sheets.obj"));
        QSignalSpy answers(&checker(), &ReadyChecker::changed);
        const int gesture = document().newGesture();
        for (int i = 0; i < 50; ++i) {
            setGrain(document(), "Turn", {{0, 0.01 * i}}, gesture);
        }
        QVERIFY(!checker().isUpToDate());
        QVERIFY(waitForAnswer());
        QCOMPARE(answers.count(), 1);
        QCOMPARE(findings(FindingKind::GrainMissing).size(), std::size_t(1));
    }

    void currentRowAndOpenKindsSurviveAChange() {
        QVERIFY(open("sheets.obj"));
        const QModelIndex row = rowOf(FindingKind::GrainMissing);
        table().setCurrentIndex(row.parent().isValid() ? row.siblingAtRow(1) : row);
        const QString where = table().currentIndex().data().toString();
        spoil(0, [](Points2& Q) { Q /= 1.1; });
        QCOMPARE(table().currentIndex().data().toString(), where);
    }

    void whatIsCalledAlikeIsToldApart() {
        QVERIFY(open("sheets.obj"));
        document().setSelection({0});
        UserCut cut{"front", UserCut::Kind::Path, {{9e5, 0, 0}, {9e5, 9, 0}}};
        Derived derived = document().derived();
        auto garment = std::make_shared<Garment>(*derived.garment);
        garment->problems = {cutError(subjectOf(cut), "far away"),
                             {ErrorCode::HolesKept, subjectOf(*garment->pieces[0])}};
        // Two files of one name, both in doubt.
        auto file = std::make_shared<SourceFile>(*garment->files[0]);
        file->unitInDoubt = true;
        garment->files = {file, file};
        derived.garment = garment;
        document().show(derived, document().state().settings);
        QVERIFY(waitForAnswer());
        const auto clickOn = [this](ErrorCode code) {
            const QModelIndex first = rowOf(FindingKind::Message);
            for (int row = first.row(); row < table().model()->rowCount(); ++row) {
                const QModelIndex index = first.siblingAtRow(row);
                const auto list = index.data(ProblemsModel::FindingsRole).value<QList<int>>();
                const auto& found = checker().readiness().findings[std::size_t(list.front())];
                if (found.error && found.error->code == code) {
                    click(index);
                }
            }
        };
        clickOn(ErrorCode::CutImpossible);
        QCOMPARE(document().selection(), Document::Selection());
        clickOn(ErrorCode::HolesKept);
        QCOMPARE(document().selection(), Document::Selection{0});
        const QModelIndex first = rowOf(FindingKind::UnitInDoubt);
        QCOMPARE(first.data(), first.siblingAtRow(first.row() + 1).data());
        table().setCurrentIndex(first);
        const QVariant finding = first.data(ProblemsModel::FindingsRole);
        setGrain(document(), "Turn", {{0, 1.0}});
        QVERIFY(waitForAnswer());
        QCOMPARE(table().currentIndex().data(ProblemsModel::FindingsRole), finding);
    }

    void closingWhileItLooksIsSafe() {
        QVERIFY(open("sheets.obj"));
        setGrain(document(), "Turn", {{0, 1.0}});
        fixture_.close();
        fixture_.open();
    }

    void everyKindIsToldInFull() {
        for (int i = 0; i < kFindingKindCount; ++i) {
            Finding finding;
            finding.kind = static_cast<FindingKind>(i);
            finding.reason = "50 % sure";
            finding.figures = {{0.1, Figure::Unit::Strain}, {3, Figure::Unit::Length}, {2}};
            QVERIFY(!problemTitle(finding.kind).isEmpty());
            const QString text = problemText(finding);
            for (const char* left : {"%0", "%1", "%2", "%3"}) {
                QVERIFY2(!text.contains(left), qPrintable(text));
            }
        }
    }
};

TOILE_WINDOW_TEST(ProblemsTest)
#include "problems_test.moc"
