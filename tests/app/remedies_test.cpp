// SPDX-License-Identifier: GPL-3.0-or-later
// What helps against a finding, by the button where it stands: with the mouse and the keyboard.
#include "app/panels/remedies.h"

#include <QMenu>
#include <QPushButton>
#include <QTreeView>
#include <cmath>
#include <numbers>

#include "app/jobs/ready_checker.h"
#include "app/panels/problems_model.h"
#include "app/views/tools/path_tool.h"
#include "app/views/tools/tool_box.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class RemediesTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    ReadyChecker& checker() { return fixture_.window().checker(); }
    QTreeView& table() { return fixture_.find<QTreeView>("problemTable"); }

    bool waitForAnswer() {
        return QTest::qWaitFor(
            [this] { return checker().isUpToDate() && !fixture_.workspace().isBusy(); },
            test::kPatience);
    }

    bool open(const char* file) {
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        return fixture_.openAndWait(fixture_.path(file)) && waitForAnswer();
    }

    /// The first row whose button this is.
    QModelIndex rowWith(Remedy remedy) {
        const auto has = [remedy](const QModelIndex& index) {
            const QVariant of =
                index.siblingAtColumn(ProblemsModel::Help).data(ProblemsModel::RemedyRole);
            return of.isValid() && of.toInt() == static_cast<int>(remedy);
        };
        const QAbstractItemModel& model = *table().model();
        for (int row = 0; row < model.rowCount(); ++row) {
            const QModelIndex index = model.index(row, ProblemsModel::Help);
            if (has(index)) {
                return index;
            }
        }
        return {};
    }

    void clickOn(const QModelIndex& index) {
        QVERIFY(index.isValid());
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                          table().visualRect(index).center());
    }

    /// The part of a sphere up to an angle from its pole.
    static MeshArrays makeDome(double radius, double angle, int around, int rings) {
        MeshArrays mesh = makeTube(radius, 1, around, rings);
        for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
            const double at = angle * (1 - mesh.V(v, 1));
            mesh.V.row(v) << mesh.V(v, 0) * std::sin(at), radius * std::cos(at),
                mesh.V(v, 2) * std::sin(at);
        }
        mesh.F.conservativeResize(mesh.F.rows() - 2 * around + around, 3);  // the last ring ends
        const int pole = static_cast<int>(mesh.V.rows()) - around;          // in one vertex
        for (Eigen::Index f = mesh.F.rows() - around; f < mesh.F.rows(); ++f) {
            const int i = static_cast<int>(f - mesh.F.rows()) + around;
            const int a = (rings - 1) * around + i, b = (rings - 1) * around + (i + 1) % around;
            mesh.F.row(f) << a, b, pole;
        }
        mesh.V.conservativeResize(pole + 1, 3);
        return mesh;
    }

    static MeshArrays makeTube(double radius, double height, int around, int along) {
        MeshArrays mesh;
        mesh.V.resize(around * (along + 1), 3);
        mesh.F.resize(2 * around * along, 3);
        for (int k = 0; k <= along; ++k) {
            for (int i = 0; i < around; ++i) {
                const double angle = 2 * std::numbers::pi * i / around;
                mesh.V.row(k * around + i) << radius * std::cos(angle), height * k / along,
                    -radius * std::sin(angle);
            }
        }
        int f = 0;
        for (int k = 0; k < along; ++k) {
            for (int i = 0; i < around; ++i) {
                const int a = k * around + i, b = k * around + (i + 1) % around;
                mesh.F.row(f++) << a, b, b + around;
                mesh.F.row(f++) << a, b + around, a + around;
            }
        }
        return mesh;
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        using Pieces = std::vector<std::pair<std::string, MeshArrays>>;
        const auto write = [this](const char* file, const Pieces& pieces) {
            test::writeObj(fixture_.path(file).toStdString(), pieces);
        };
        MeshArrays beside = makeTube(90, 700, 16, 12);
        beside.V.col(0).array() += 250;
        write("leg.obj", {{"leg", makeTube(90, 700, 16, 12)}});
        write("fine.obj", {{"leg", makeTube(90, 700, 64, 24)}});
        write("legs.obj", {{"left", makeTube(90, 700, 16, 12)}, {"right", beside}});
        write("tiny.obj", {{"sheet", test::makeSheet(4, 6, 8, 12)}});
        write("cap.obj", {{"cap", test::makeCap(0)}});
        write("dome.obj", {{"dome", makeDome(100, 2.8, 24, 16)}});
        write("sheets.obj",
              {{"front", test::makeSheet(400, 600, 8, 12)},
               {"back", test::makeSheet(400, 600, 8, 12, Eigen::Vector3d(0, 0, -300))}});
    }

    void init() { fixture_.open(); }
    void cleanup() { fixture_.close(); }

    void aTubeIsOpenedByTheButtonOfItsFinding_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("coarse") << "leg.obj";
        QTest::newRow("fine: on another thread") << "fine.obj";
    }

    void aTubeIsOpenedByTheButtonOfItsFinding() {
        QFETCH(QString, file);
        QVERIFY(open(qPrintable(file)));
        QVERIFY(!document().result(0)->flat);
        QTest::keyClick(&fixture_.window(), Qt::Key_F8);
        const QModelIndex button = rowWith(Remedy::CutOpen);
        QCOMPARE(button.data().toString(), QString("Cut open"));
        const QString said = button.siblingAtColumn(ProblemsModel::Problem).data().toString();
        QVERIFY2(said.contains("tube with 2 openings"), qPrintable(said));
        clickOn(button);
        QTRY_VERIFY_WITH_TIMEOUT(document().result(0) && document().result(0)->flat,
                                 test::kPatience);
        QVERIFY(waitForAnswer());
        QVERIFY(!rowWith(Remedy::CutOpen).isValid());
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(waitForAnswer());
        QVERIFY(!document().result(0)->flat);
        QVERIFY(rowWith(Remedy::CutOpen).isValid());
    }

    void theButtonOpensItsPieceAlone() {
        QVERIFY(open("legs.obj"));
        QCOMPARE(document().pieceCount(), 2);
        const auto isFlat = [this](int piece) {
            return document().result(piece) && document().result(piece)->flat;
        };
        emit fixture_.patternView().helpWanted(1);
        QTRY_VERIFY_WITH_TIMEOUT(isFlat(1), test::kPatience);
        QVERIFY(waitForAnswer());
        QVERIFY(!isFlat(0));
        // The cut is the person's: it has a name, and can be taken back alone.
        QCOMPARE(document().garment()->cuts.size(), std::size_t{1});
        QCOMPARE(document().garment()->cuts[0].author, CutAuthor::User);
        QCOMPARE(document().history().undoText(), QString("Cut open"));
        QCOMPARE(document().selection(), Document::Selection{1});
        QVERIFY(!fixture_.action(ActionId::CutOpen).isEnabled());
        document().setSelection({0});
        fixture_.action(ActionId::CutOpen).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(isFlat(0), test::kPatience);
        QCOMPARE(document().garment()->cuts.size(), std::size_t{2});
    }

    void theUnitIsAskedForOnTheCard() {
        QVERIFY(open("tiny.obj"));
        QTest::keyClick(&fixture_.window(), Qt::Key_F8);
        auto& card = fixture_.find<QWidget>("garmentCard");
        QVERIFY(!card.isVisible());
        clickOn(rowWith(Remedy::SetUnit));
        QVERIFY(card.isVisible());
    }

    void aDartIsProposedWhereTheMenuIsAskedFor() {
        QVERIFY(open("cap.obj"));
        PatternView& view = fixture_.patternView();
        const Eigen::Vector2d label = document().scene()->pieces[0].label;
        const Eigen::Vector2d pixel =
            view.camera().toScreen(document().settings()[0].placement->applied(label));
        emit view.menuWanted({pixel.x(), pixel.y()}, true);
        QCOMPARE(document().selection(), Document::Selection{0});
        fixture_.action(ActionId::DartHere).trigger();
        fixture_.window().findChild<QMenu*>("pieceContext")->close();
        QCOMPARE(fixture_.window().tools().current().id(), ToolId::Dart);
        const auto& tool = dynamic_cast<const PathTool&>(fixture_.window().tools().current());
        QCOMPARE(tool.draft().points().size(), std::size_t{2});
        QVERIFY(tool.draft().points().front().isOnRim());
        const Eigen::Vector2d tip =
            flatPositionOf(document().result(0)->flat->Q, document().garment()->pieces[0]->mesh.F,
                           tool.draft().points().back().at)
                .transpose();
        QVERIFY((tip - label).norm() < 2 / view.pixelsPerMillimetre());
    }

    void theKeyboardDoesWhatTheButtonDoes() {
        QVERIFY(open("leg.obj"));
        QTest::keyClick(&fixture_.window(), Qt::Key_F8);
        table().setCurrentIndex(rowWith(Remedy::CutOpen));
        table().setFocus();
        QTest::keyClick(&table(), Qt::Key_Return, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(document().result(0) && document().result(0)->flat,
                                 test::kPatience);
    }

    void whatIsNotFlatHasAPlaceWithAButton() {
        QVERIFY(open("leg.obj"));
        PatternView& view = fixture_.patternView();
        QTRY_VERIFY_WITH_TIMEOUT(!view.piecePlaces().boxOf(0).isEmpty(), test::kPatience);
        const Eigen::AlignedBox2d box = view.piecePlaces().boxOf(0);
        const double side = std::sqrt(2 * std::numbers::pi * 90 * 700);
        QVERIFY(std::abs(box.sizes().x() - side) < 0.05 * side);
        fixture_.action(ActionId::Frame).trigger();
        QTest::qWait(0);
        const auto onScreen = [&view](const Eigen::Vector2d& at) {
            const Eigen::Vector2d pixel = view.camera().toScreen(at);
            return QPointF(pixel.x(), pixel.y());
        };
        test::click(view, onScreen({box.center().x(), box.max().y() - 0.1 * side}));
        QCOMPARE(document().selection(), Document::Selection{0});
        // The button is below the words in the middle.
        for (double down = 0; down < 0.4 && document().loading().seams.cuts.empty(); down += 0.02) {
            test::click(view, onScreen(box.center() - Eigen::Vector2d(0, down * side)));
        }
        QVERIFY(!document().loading().seams.cuts.empty());
        QTRY_VERIFY_WITH_TIMEOUT(document().result(0) && document().result(0)->flat,
                                 test::kPatience);
        QVERIFY(view.piecePlaces().isEmpty());
    }

    void aDartIsProposedAtTheWorstPlaceAndEnterCutsIt() {
        QVERIFY(open("cap.obj"));
        fixture_.action(ActionId::GoToFabric).trigger();
        QTest::keyClick(qApp->focusWidget(), Qt::Key_Down);  // woven
        QVERIFY(waitForAnswer());
        QTest::keyClick(&fixture_.window(), Qt::Key_F8);
        const QModelIndex button = rowWith(Remedy::PutDart);
        clickOn(button);
        QCOMPARE(fixture_.window().tools().current().id(), ToolId::Dart);
        const auto& tool = dynamic_cast<const PathTool&>(fixture_.window().tools().current());
        QCOMPARE(tool.draft().points().size(), std::size_t{2});
        QVERIFY(tool.draft().points().front().isOnRim());
        QVERIFY(document().garment()->cuts.empty());
        QTest::keyClick(&fixture_.garmentView(), Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(document().garment()->cuts.size(), std::size_t{1},
                                  test::kPatience);
        QCOMPARE(document().garment()->cuts[0].kind, UserCut::Kind::Dart);
        QVERIFY(waitForAnswer());
        fixture_.action(ActionId::Undo).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(document().garment()->cuts.empty(), test::kPatience);
    }

    void whatWaitsIsCalledOutOfDateAndAButtonFlattensIt() {
        QVERIFY(open("sheets.obj"));
        auto& bar = fixture_.find<QWidget>("outdatedBar");
        QVERIFY(!bar.isVisible());
        fixture_.action(ActionId::AutoFlatten).trigger();
        const auto back = document().result(1);
        fixture_.workspace().cuts().add(
            {{}, UserCut::Kind::Path, {{200, 0, 0}, {200, 600, 0}}, false});
        QVERIFY(waitForAnswer());
        QCOMPARE(document().pieceCount(), 3);
        QVERIFY(bar.isVisible());
        QVERIFY(fixture_.action(ActionId::ExportPattern).toolTip().contains("out of date"));
        const auto& results = document().results();
        QVERIFY(std::ranges::any_of(results, [&](const auto& r) { return r.get() == back; }));
        QTest::mouseClick(&fixture_.find<QPushButton>("flattenNow"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(document().isFlattened(), test::kPatience);
        QVERIFY(waitForAnswer());
        QVERIFY(!bar.isVisible());
        QVERIFY(!fixture_.action(ActionId::ExportPattern).toolTip().contains("out of date"));
    }

    void theMenuHasAllThatMayHelp() {
        QVERIFY(open("sheets.obj"));
        QTest::keyClick(&fixture_.window(), Qt::Key_F8);
        const QModelIndex button = rowWith(Remedy::BestGrain);
        QVERIFY(button.isValid());
        emit table().customContextMenuRequested(table().visualRect(button).center());
        auto* menu = fixture_.window().findChild<QMenu*>("problemMenu");
        QVERIFY(menu);
        QCOMPARE(menu->actions().size(), qsizetype{2});
        menu->actions().back()->trigger();
        menu->close();
        QVERIFY(waitForAnswer());
        QVERIFY(document().settings()[0].grain);
        QVERIFY(document().settings()[1].grain);
    }

    void aDomeThatNoClothTakesIsAmberAndItsCutsAreProposed() {
        QVERIFY(open("dome.obj"));
        QTest::keyClick(&fixture_.window(), Qt::Key_F8);
        QVERIFY(document().results()[0]->flat);
        const auto& pieces = *fixture_.find<QTreeView>("pieceTable").model();
        QString status;
        QColor colour;
        for (int column = 0; column < pieces.columnCount(); ++column) {
            const QModelIndex index = pieces.index(0, column);
            if (index.data().toString().contains("exceeds any fabric")) {
                status = index.data().toString();
                colour = index.data(Qt::ForegroundRole).value<QBrush>().color();
            }
        }
        QCOMPARE(status, QString("Flat, exceeds any fabric"));
        QVERIFY(colour.red() > 150 && colour.green() > 90 && colour.blue() < 60);  // amber
        const QModelIndex button = rowWith(Remedy::ProposeCuts);
        QVERIFY(button.isValid());
        emit table().customContextMenuRequested(table().visualRect(button).center());
        auto* menu = fixture_.window().findChild<QMenu*>("problemMenu");
        QVERIFY(menu);
        document().setOverlay(Overlay::None);
        menu->actions().back()->trigger();  // show strain
        menu->close();
        QCOMPARE(document().view().overlay, Overlay::Strain);
    }

    void nothingHelpsAPieceOfAScanBeforeThatIsPrepared() {
        // A ring in a file with a map that it is not divided by.
        auto file = std::make_shared<SourceFile>();
        auto soup = std::make_shared<PolygonSoup>();
        soup->cornerUvs = {0};
        file->soup = soup;
        file->split.mode = SplitMode::Components;
        auto garment = std::make_shared<Garment>();
        garment->pieces = {std::make_shared<Piece>()};
        Finding finding;
        finding.kind = FindingKind::NotFlat;
        finding.pieces = {0};
        const auto remedies = [&](FileKind kind, bool isStated) {
            auto read = std::make_shared<SourceFile>(*file);
            read->reading.kind = kind;
            read->reading.isStated = isStated;
            garment->files = {read};
            CutPlan plan;
            plan.garment = garment;
            return remediesFor(finding, plan);
        };
        QCOMPARE(remedies(FileKind::Sheet, false).front(), Remedy::DivideByUv);
        QVERIFY(remedies(FileKind::Scan, false).empty());
        QCOMPARE(remedies(FileKind::Scan, true).front(), Remedy::DivideByUv);
    }

    void everyRemedyHasWordsAndSomethingThatDoesIt() {
        for (int i = 0; i <= static_cast<int>(Remedy::LayOutAgain); ++i) {
            const auto remedy = static_cast<Remedy>(i);
            QVERIFY(!remedyText(remedy).isEmpty());
            QVERIFY(!remedyTip(remedy).isEmpty());
            QVERIFY(!actionsOf(remedy).empty());
        }
    }
};

TOILE_WINDOW_TEST(RemediesTest)
#include "remedies_test.moc"
