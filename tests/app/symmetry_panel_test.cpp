// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of symmetry and mirrored editing: real keys, clicks and drags, and what they leave in
// the document.
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>
#include <atomic>
#include <thread>

#include "app/document/layout.h"
#include "app/document/mirrored_edits.h"
#include "app/jobs/file_jobs.h"
#include "app/panels/mirrored_pieces_list.h"
#include "app/panels/seams_model.h"
#include "app/views/tools/path_tool.h"
#include "app/views/tools/tool_box.h"
#include "app/widgets/garment_card.h"
#include "core/cut/surface_point.h"
#include "core/pattern/fair_outline.h"
#include "core/pattern/mirrored_edit.h"
#include "core/project/project_file.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"
#include "tests/app/support/workspace_fixture.h"

using namespace toile;
using namespace toile::app;

/// A T-shirt: two sleeves that mirror each other, a front and a back that mirror themselves.
class SymmetryPanelTest : public QObject {
    Q_OBJECT

private:
    using Column = MirroredPiecesList::Column;

    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    Workspace& workspace() { return fixture_.workspace(); }
    int steps() { return document().history().index(); }
    void undo() { fixture_.action(ActionId::Undo).trigger(); }
    QComboBox& choice() { return fixture_.find<QComboBox>("mirrorChoice"); }
    QCheckBox& editsBox() { return fixture_.find<QCheckBox>("mirrorEdits"); }
    QTreeWidget& list() { return fixture_.find<QTreeWidget>("mirroredPieceList"); }
    QString label(const char* name) { return fixture_.find<QLabel>(name).text(); }
    const std::vector<UserCut>& cuts() { return document().loading().seams.cuts; }
    const PieceSettings& settings(int piece) {
        return document().settings()[static_cast<std::size_t>(piece)];
    }

    bool isFlatAgain() {
        return QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience) &&
               fixture_.waitForResults();
    }

    void choose(Mirror mirror) {
        const int item = choice().findData(static_cast<int>(mirror));
        choice().setCurrentIndex(item);
        emit choice().activated(item);
    }

    void chooseMean() {
        choice().setFocus();
        choose(Mirror::Mean);
        QVERIFY(isFlatAgain());
        QVERIFY(document().derived().symmetry);
    }

    int counterpartOf(int piece) {
        return document().derived().symmetry->pieces.counterpart[static_cast<std::size_t>(piece)];
    }

    /// The first piece whose counterpart is another, or itself.
    int somePiece(bool isInItself) {
        for (int piece = 0; piece < document().pieceCount(); ++piece) {
            const int other = counterpartOf(piece);
            if (other >= 0 && (other == piece) == isInItself) {
                return piece;
            }
        }
        return -1;
    }

    /// Another window, with a pattern of the shirt whose left sleeve's hem is moved outwards.
    /// @param lower  how much longer the left side seam is than the right one
    void openWithLongerSleeve(double outwards, double lower = 0) {
        QFile sample(fixture_.path("tshirt.obj")), shirt(fixture_.path("longer.obj"));
        QVERIFY(sample.open(QFile::ReadOnly) && shirt.open(QFile::WriteOnly));
        bool isSleeve = false, isTrunk = false;
        for (const QString& line : QString::fromUtf8(sample.readAll()).split('\n')) {
            isSleeve = line.startsWith("o ") ? line == "o sleeve_left" : isSleeve;
            isTrunk = line.startsWith("o ") ? line == "o front" || line == "o back" : isTrunk;
            QStringList words = line.split(' ');
            constexpr double kArmhole = 206, kStretched = 60;  // of the sample, mm
            if (isSleeve && words[0] == "v" && words[1].toDouble() > kArmhole) {
                const double x = words[1].toDouble();
                words[1] =
                    QString::number(x + outwards * std::min((x - kArmhole) / kStretched, 1.0));
            }
            constexpr double kUpTo = 1150, kHigh = 350;  // below the armholes, mm
            const double height = words[0] == "v" ? words[2].toDouble() : kUpTo;
            if (isTrunk && lower > 0 && height < kUpTo && words[1].toDouble() > 0) {
                const double share = words[1].toDouble() / kArmhole * (kUpTo - height) / kHigh;
                words[2] = QString::number(height - lower * share, 'f', 4);
            }
            shirt.write((words.join(' ') + '\n').toUtf8());
        }
        shirt.close();
        fixture_.close();
        fixture_.open({1400, 900}, NewGarment::Pattern);
        workspace().setMethod(Method::Curvature);
        QVERIFY(fixture_.openAndWait(shirt.fileName()));
        fixture_.action(ActionId::GoToSymmetry).trigger();
        QVERIFY(isFlatAgain());
        QVERIFY(document().derived().symmetry && !document().derived().symmetry->unequal.empty());
    }

    /// The column of the list of seams.
    QString changedBy(int seam) {
        const auto* model = fixture_.window().findChild<SeamsModel*>();
        return model->index(seam, SeamsModel::ChangedBy).data().toString();
    }

    int drawnEqual() {
        return static_cast<int>(std::ranges::count_if(document().results(), [](const auto& result) {
            return result->plan && result->plan->mirrored && result->flat->line;
        }));
    }

    int rowOf(int piece) {
        const QString name =
            QString::fromStdString(document().garment()->pieces[std::size_t(piece)]->name);
        for (int k = 0; k < list().topLevelItemCount(); ++k) {
            if (list().topLevelItem(k)->text(Column::Name).split(" / ").contains(name)) {
                return k;
            }
        }
        return -1;
    }

    QRect cell(int row, Column column) {
        return list().visualRect(list().model()->index(row, column));
    }

    void tickHalf(int row) {
        list().scrollToItem(list().topLevelItem(row));
        const QRect box = cell(row, Column::Half);
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                          {box.left() + 12, box.center().y()});
    }

    /// Two vertices of a piece: one on its outline, and one inside of it, away from all outlines.
    std::pair<Eigen::Vector3d, Eigen::Vector3d> rimAndTip(int piece) {
        const Piece& of = *document().garment()->pieces[static_cast<std::size_t>(piece)];
        const Points3& V = of.mesh.V;
        const auto nearest = [](const Points3& points, const Eigen::RowVector3d& to) {
            Eigen::Index at = 0;
            (points.rowwise() - to).rowwise().squaredNorm().minCoeff(&at);
            return Eigen::RowVector3d(points.row(at));
        };
        Points3 rim(static_cast<Eigen::Index>(of.boundary.size()), 3);
        for (Eigen::Index k = 0; k < rim.rows(); ++k) {
            rim.row(k) = V.row(of.boundary[static_cast<std::size_t>(k)]);
        }
        const Eigen::RowVector3d middle = nearest(V, V.colwise().mean());
        const Eigen::RowVector3d start = nearest(rim, middle);
        return {start, nearest(V, 0.5 * (start + middle))};
    }

    UserCut someDart(int piece) {
        const auto [rim, tip] = rimAndTip(piece);
        return {{}, UserCut::Kind::Dart, {rim, tip}};
    }

    QPointF inPattern(int piece, const Eigen::Vector3d& point) {
        const MeshArrays& mesh =
            document().garment()->pieces[static_cast<std::size_t>(piece)]->mesh;
        const SurfacePoint place = NearestSurface(mesh).find(point);
        return fixture_.patternView()
            .onScreen(piece, place.face, place.barycentric)
            .value_or(QPointF(-1, -1));
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj",
                            fixture_.path("tshirt.obj")));
    }

    void init() {
        fixture_.open();
        workspace().setMethod(Method::Curvature);  // the quickest
        QVERIFY(fixture_.openAndWait(fixture_.path("tshirt.obj")));
        fixture_.action(ActionId::GoToSymmetry).trigger();
        QVERIFY(choice().hasFocus());
    }

    void cleanup() { fixture_.close(); }

    void piecesBecomeEqualAndOneUndoTakesThatBack() {
        const PieceResults before = document().results();
        QVERIFY(label("mirrorPlane").contains("not compared"));
        QVERIFY(!editsBox().isEnabled());
        chooseMean();
        QCOMPARE(steps(), 1);
        QCOMPARE(document().state().lines.mirror, Mirror::Mean);
        QVERIFY(drawnEqual() > 0);
        QVERIFY2(label("mirrorPlane").contains("differ by"), qPrintable(label("mirrorPlane")));
        QVERIFY2(label("mirrorDrawn").contains("drawn equal"), qPrintable(label("mirrorDrawn")));
        int rows = 0;
        for (int piece = 0; piece < document().pieceCount(); ++piece) {
            QVERIFY(rowOf(piece) >= 0);
            rows += counterpartOf(piece) < 0 || counterpartOf(piece) >= piece ? 1 : 0;
        }
        QCOMPARE(list().topLevelItemCount(), rows);
        QVERIFY(editsBox().isEnabled() && editsBox().isChecked());
        undo();
        QVERIFY(isFlatAgain());
        QVERIFY(document().results() == before);
        QCOMPARE(list().topLevelItemCount(), 0);
        QCOMPARE(choice().currentIndex(), 0);
    }

    void unequalSleevesAreKeptAndACardOffersToMakeThemEqual() {
        openWithLongerSleeve(11.8);
        const int sleeve = document().derived().symmetry->unequal.front().piece;
        auto& card = fixture_.window().card();
        QVERIFY(card.isVisible());
        QVERIFY2(card.sentence().contains("differ by"), qPrintable(card.sentence()));
        QVERIFY2(!card.sentence().contains("by less"), qPrintable(card.sentence()));
        QVERIFY(!mirrorsEdits(document()) && !editsBox().isChecked());
        QCOMPARE(list().topLevelItem(rowOf(sleeve))->text(Column::Drawn), "as in the file");
        const int seam = document().derived().symmetry->unequal.front().seam;
        QVERIFY(changedBy(seam).isEmpty());
        const auto press = [&card](const QString& text) {
            for (auto* button : card.findChildren<QPushButton*>()) {
                if (button->isVisible() && button->text() == text) {
                    QTest::mouseClick(button, Qt::LeftButton);
                    return;
                }
            }
            QFAIL("no such button");
        };
        press("Make equal");
        QVERIFY(isFlatAgain());
        QVERIFY(card.isHidden());
        QCOMPARE(list().topLevelItem(rowOf(sleeve))->text(Column::Drawn), "equal");
        QVERIFY2(changedBy(seam).startsWith("mirroring −4."), qPrintable(changedBy(seam)));
        undo();
        QVERIFY(isFlatAgain());
        QVERIFY(changedBy(seam).isEmpty());
        QVERIFY(card.isVisible());
        press("Keep as in the file");
        QVERIFY(card.isHidden());
        QCOMPARE(document().state().lines.mirror, Mirror::Close);
    }

    void theCardCountsWhatDiffersLess() {
        openWithLongerSleeve(14, 7);
        const auto others = document().derived().symmetry->unequal.size() - 1;
        const QString sentence = fixture_.window().card().sentence();
        QVERIFY2(others == 2 && sentence.endsWith("2 more pieces or pairs differ by less."),
                 qPrintable(QString::number(others) + sentence));
    }

    void theMirroredCutIsShownWhileItIsDrawn() {
        chooseMean();
        QVERIFY(mirrorsEdits(document()));  // the sample is symmetric
        const int sleeve = somePiece(false);
        const auto [rim, tip] = rimAndTip(sleeve);
        auto& tools = fixture_.window().tools();
        tools.choose(ToolId::Cut);
        const auto& tool = dynamic_cast<const PathTool&>(tools.current());
        auto& view = fixture_.patternView();
        QTest::mouseClick(&view, Qt::LeftButton, {}, inPattern(sleeve, rim).toPoint());
        test::moveTo(view, inPattern(sleeve, tip));
        QTRY_VERIFY_WITH_TIMEOUT(tool.image().has_value(), test::kPatience);
        QCOMPARE(tool.image()->piece, counterpartOf(sleeve));
        QVERIFY(tool.image()->line.points.size() > 1);
        setMirrorsEdits(document(), false);
        test::moveTo(view, inPattern(sleeve, rim) + QPointF(9, 9));
        QVERIFY(!tool.image());
        QVERIFY(cuts().empty());
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(!tool.image());
    }

    void halfOnlyIsSaidOfBothPiecesInOneStep() {
        chooseMean();
        const int sleeve = somePiece(false), front = somePiece(true);
        QVERIFY(sleeve >= 0 && front >= 0);
        QCOMPARE(list().topLevelItem(rowOf(sleeve))->text(Column::Half), "cut 1 pair");
        QCOMPARE(list().topLevelItem(rowOf(front))->text(Column::Half), "cut on the fold");
        tickHalf(rowOf(sleeve));
        QCOMPARE(steps(), 2);
        QVERIFY(settings(sleeve).byHalf && settings(counterpartOf(sleeve)).byHalf);
        tickHalf(rowOf(front));
        QVERIFY(settings(front).byHalf);
        tickHalf(rowOf(sleeve));
        QVERIFY(!settings(sleeve).byHalf && !settings(counterpartOf(sleeve)).byHalf);
        undo();
        QVERIFY(settings(sleeve).byHalf);
        QCOMPARE(list().topLevelItem(rowOf(sleeve))->checkState(Column::Half), Qt::Checked);
    }

    void aRowSelectsItsPiecesAndTheOtherWayRound() {
        chooseMean();
        const int sleeve = somePiece(false), front = somePiece(true);
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                          cell(rowOf(sleeve), Column::Name).center());
        QCOMPARE(document().selection(), (Document::Selection{sleeve, counterpartOf(sleeve)}));
        document().setSelection({front});
        QCOMPARE(list().currentItem(), list().topLevelItem(rowOf(front)));
        document().setSelection(document().everyPiece());
        QCOMPARE(list().currentItem(), nullptr);
    }

    void mirroredEditingIsSwitchedInThePanelAndInTheMenu() {
        QAction& action = fixture_.action(ActionId::MirrorEdits);
        QVERIFY(!action.isEnabled());
        chooseMean();
        QVERIFY(action.isEnabled() && action.isChecked());
        QTest::keyClick(&editsBox(), Qt::Key_Space);
        QVERIFY(!action.isChecked() && !mirrorsEdits(document()));
        action.trigger();
        QVERIFY(editsBox().isChecked() && mirrorsEdits(document()));
        QCOMPARE(steps(), 1);
    }

    void aDartIsDrawnTwiceAndOneUndoTakesBothBack() {
        chooseMean();
        const int sleeve = somePiece(false);
        const auto [rim, tip] = rimAndTip(sleeve);
        fixture_.window().tools().choose(ToolId::Dart);
        test::drag(fixture_.patternView(), inPattern(sleeve, rim), inPattern(sleeve, tip));
        QCOMPARE(cuts().size(), std::size_t(2));
        QCOMPARE(cuts()[0].name, std::string("dart 1"));
        QCOMPARE(cuts()[1].name, std::string("dart 2"));
        QVERIFY(cuts()[0].id && cuts()[1].id && cuts()[1].mirrors == cuts()[0].id);
        QVERIFY(!cuts()[0].mirrors);
        QCOMPARE(steps(), 2);
        QVERIFY(isFlatAgain());
        QCOMPARE(document().garment()->cuts.size(), std::size_t(2));
        QVERIFY(document().garment()->cuts[0].piece != document().garment()->cuts[1].piece);
        undo();
        QVERIFY(cuts().empty());
        QVERIFY(isFlatAgain());
        QVERIFY(document().garment()->cuts.empty());
    }

    void aCutIsTakenBackWithItsImageUnlessThatIsSwitchedOff() {
        chooseMean();
        workspace().cuts().add(someDart(somePiece(false)));
        QVERIFY(isFlatAgain());
        QCOMPARE(cuts().size(), std::size_t(2));
        for (const std::size_t either : {0, 1}) {
            workspace().cuts().remove(cuts()[either].id);
            QVERIFY(cuts().empty());
            undo();
            QCOMPARE(cuts().size(), std::size_t(2));
        }
        QVERIFY(isFlatAgain());
        const auto& seams = document().garment()->seams.seams;
        const auto ofDart =
            std::ranges::find_if(seams, [](const Seam& seam) { return !seam.cuts.empty(); });
        QVERIFY(ofDart != seams.end());
        workspace().cuts().joinSeam(static_cast<int>(ofDart - seams.begin()));
        QVERIFY(cuts().empty());
        undo();
        setMirrorsEdits(document(), false);
        workspace().cuts().remove(cuts()[0].id);
        QCOMPARE(cuts().size(), std::size_t(1));
    }

    void aCutIsMadeOnceWhereItIsSwitchedOffOrNoPlaneIsKnown() {
        workspace().cuts().add(someDart(0));
        QCOMPARE(cuts().size(), std::size_t(1));
        QVERIFY(isFlatAgain());
        undo();
        QVERIFY(isFlatAgain());
        chooseMean();
        setMirrorsEdits(document(), false);
        workspace().cuts().add(someDart(somePiece(false)));
        QCOMPARE(cuts().size(), std::size_t(1));
    }

    void cutsThatWaitForTheirImagesAreMadeInOrder() {
        chooseMean();
        test::Hold held;
        workspace().cuts().searches().start(held.job());
        workspace().cuts().add(someDart(somePiece(false)));
        workspace().cuts().add(someDart(somePiece(true)));
        QVERIFY(cuts().empty());
        QVERIFY(fixture_.action(ActionId::Cancel).isEnabled());
        document().setSeamEase(0, 0.02);
        held.release();
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(isFlatAgain());
        QCOMPARE(steps(), 4);
        QCOMPARE(cuts().size(), std::size_t(4));
        QVERIFY(cuts()[1].mirrors == cuts()[0].id && cuts()[3].mirrors == cuts()[2].id);
        QCOMPARE(cuts()[3].name, std::string("dart 4"));
        QVERIFY(document().garment()->seams.seams[0].ease || document().garment()->cuts.size() > 3);
        undo();
        QCOMPARE(cuts().size(), std::size_t(2));
        fixture_.action(ActionId::Redo).trigger();
        QCOMPARE(cuts().size(), std::size_t(4));
    }

    void aStepBackTakesBackACutThatWaits() {
        chooseMean();
        test::Hold held;
        workspace().cuts().searches().start(held.job());
        workspace().cuts().add(someDart(somePiece(false)));
        undo();
        held.release();
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(cuts().empty());
        QCOMPARE(steps(), 1);  // the one before is not taken back
        undo();
        QCOMPARE(steps(), 0);
    }

    void stepsBackTakeBackOneWaitingCutEachAndThenEdits() {
        chooseMean();
        test::Hold held;
        workspace().cuts().searches().start(held.job());
        workspace().cuts().add(someDart(somePiece(false)));
        workspace().cuts().add(someDart(somePiece(true)));
        undo();
        held.release();
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(isFlatAgain());
        QCOMPARE(cuts().size(), std::size_t(2));  // the first, and its image
        QCOMPARE(steps(), 2);
        // A search that is cancelled and has not stopped yet does not take the next step.
        std::atomic<bool> runs = true;
        workspace().cuts().searches().start(makeJob(
            "Deaf",
            [&runs](Progress&) -> Result<int> {
                while (runs) {
                    std::this_thread::yield();
                }
                return 0;
            },
            [](int) {}));
        undo();
        QCOMPARE(steps(), 2);
        undo();
        const int after = steps();
        runs = false;
        QCOMPARE(after, 1);
        QVERIFY(fixture_.waitUntilIdle());
    }

    void aCutThatWaitsIsNotMadeInAnotherGarment() {
        chooseMean();
        test::Hold held;
        workspace().cuts().searches().start(held.job());
        workspace().cuts().add(someDart(somePiece(false)));
        QVERIFY(fixture_.openAndWait(TOILE_SOURCE_DIR "/resources/samples/cap.obj"));
        held.release();
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(cuts().empty());
        QCOMPARE(steps(), 0);
    }

    void theGrainTurnsOnBothSides() {
        chooseMean();
        const int sleeve = somePiece(false), other = counterpartOf(sleeve);
        const auto expected = mirroredDirection(*document().garment(), document().results(),
                                                *document().derived().symmetry, sleeve, 0.4);
        QVERIFY(expected);
        setGrain(document(), "Grain", {{sleeve, 0.4}});
        QCOMPARE(steps(), 2);
        QCOMPARE(settings(sleeve).grain, std::optional(0.4));
        QCOMPARE(settings(other).grain, expected);
        // Of what is said of both, both stay.
        setGrain(document(), "Grain", {{sleeve, 0.1}, {other, 0.2}});
        QCOMPARE(settings(other).grain, std::optional(0.2));
        setGrain(document(), "Grain", {{other, std::nullopt}});
        QVERIFY(!settings(sleeve).grain && !settings(other).grain);
        QCOMPARE(withoutCounterparts(document(), {sleeve, other}), std::vector{sleeve});
        setMirrorsEdits(document(), false);
        setGrain(document(), "Grain", {{sleeve, 0.4}});
        QVERIFY(!settings(other).grain);
    }

    void aDragThatIsTakenBackLeavesTheGrainOfBothAsItWas() {
        chooseMean();
        const int sleeve = somePiece(false), other = counterpartOf(sleeve);
        setGrain(document(), "Grain", {{sleeve, 0.4}, {other, 0.2}});
        fixture_.window().tools().choose(ToolId::Grain);
        PatternView& view = fixture_.patternView();
        view.setFocus();
        const QPointF from = inPattern(sleeve, rimAndTip(sleeve).second);
        test::sendMouse(view, QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        test::sendMouse(view, QEvent::MouseMove, from + QPointF(40, 25), Qt::NoButton,
                        Qt::LeftButton);
        QVERIFY(settings(sleeve).grain != 0.4);
        QVERIFY(settings(other).grain != 0.2);
        QTest::keyClick(&view, Qt::Key_Escape);
        test::sendMouse(view, QEvent::MouseButtonRelease, from, Qt::LeftButton, Qt::NoButton);
        QCOMPARE(settings(sleeve).grain, std::optional(0.4));
        QCOMPARE(settings(other).grain, std::optional(0.2));
        QCOMPARE(steps(), 2);
    }

    void aProjectKeepsWhatMirrorsWhatAndWhatIsHalved() {
        chooseMean();
        const int sleeve = somePiece(false);
        workspace().cuts().add(someDart(somePiece(true)));
        QVERIFY(isFlatAgain());
        tickHalf(rowOf(sleeve));
        const std::vector<UserCut> said = cuts();
        const QString file = fixture_.path("mirrored.toile");
        QVERIFY(writeProject(file.toStdString(), projectOf(document().state(), document().derived(),
                                                           document().view())));
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(cuts() == said);
        QCOMPARE(document().state().lines.mirror, Mirror::Mean);
        QVERIFY(settings(sleeve).byHalf);
    }
};

TOILE_WINDOW_TEST(SymmetryPanelTest)
#include "symmetry_panel_test.moc"
