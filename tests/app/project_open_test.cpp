// SPDX-License-Identifier: GPL-3.0-or-later
// Projects in the window: opening what was saved, meshes that have changed or gone, recent files.
#include <QLabel>
#include <QMenu>

#include "app/base/text.h"
#include "app/widgets/banner.h"
#include "core/base/file.h"
#include "core/project/project_file.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/project_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class ProjectOpenTest : public test::ProjectBench {
    Q_OBJECT

    Eigen::Vector2d placeOf(int piece, int vertex) {
        const auto at = std::size_t(piece);
        return document().settings()[at].placement->applied(
            document().results()[at]->flat->Q.row(vertex).transpose());
    }

private slots:
    void everythingDoneIsThereAgain() {
        doThings();
        const test::Moment before = test::momentOf(document());
        saveAs("dress.toile");
        QVERIFY(!session().isModified());
        reopenWindow();
        QVERIFY(fixture_->openAndWait(path("dress.toile")));
        QVERIFY(waitUntilFlat());
        QVERIFY(test::isSame(test::momentOf(document()), before));
        QCOMPARE(document().view().overlay, Overlay::Strain);
        QVERIFY(!session().isModified());
        QVERIFY(window().windowTitle().startsWith("dress.toile"));
    }

    void anotherGarmentBeginsAnew() {
        doThings();
        saveAs("dress.toile");
        writeMesh("coat.obj", 500);
        QVERIFY(fixture_->openAndWait(path("coat.obj")));
        QVERIFY(waitUntilFlat());
        QVERIFY(document().fabric() == DocumentState{}.fabric);
        QVERIFY(!session().isModified());
        QVERIFY(!window().isWindowModified());
        QVERIFY(!document().history().canUndo());
        QVERIFY(session().path().empty());
    }

    void aPlaceSurvivesFlatCoordinatesThatTurn() {
        doThings();
        const Eigen::Vector2d a = placeOf(0, 0), b = placeOf(0, 5);
        saveAs("dress.toile");
        // As if the piece had been flattened by another way when it was saved.
        auto read = readProject(file("dress.toile"));
        QVERIFY(read);
        PieceSettings& piece = read->project.pieces[0].settings;
        QVERIFY(piece.anchors.size() > 2);
        const double turn = 1.2;
        const Eigen::Rotation2Dd rotation(turn);
        const Eigen::Vector2d shift(50, -20);
        for (Anchor& anchor : piece.anchors) {
            anchor.flat = Eigen::Vector2d(rotation * anchor.flat) + shift;
        }
        piece.placement->turn += turn;  // mirrored: the other way round
        piece.placement->offset -= piece.placement->linear() * shift;
        QVERIFY(writeProject(file("turned.toile"), read->project));
        QVERIFY(fixture_->openAndWait(path("turned.toile")));
        QVERIFY(waitUntilFlat());
        QVERIFY((placeOf(0, 0) - a).norm() < test::kSameShape);
        QVERIFY((placeOf(0, 5) - b).norm() < test::kSameShape);
        QVERIFY(document().settings()[0].anchors.empty());
    }

    void openingAnotherAsksFirst() {
        writeMesh("other.obj");
        edit();
        const test::Moment before = test::momentOf(document());
        window().openFiles({path("other.obj")});
        QCOMPARE(asked_, 1);
        QVERIFY(!workspace().jobs().isBusy());
        QVERIFY(test::momentOf(document()) == before);
        answer_ = SaveAnswer::Discard;
        QVERIFY(fixture_->openAndWait(path("other.obj")));
        QCOMPARE(document().title(), QString("other.obj"));
    }

    void openingAnotherMaySaveFirst() {
        writeMesh("other.obj");
        edit();
        answer_ = SaveAnswer::Save;
        target_ = path("dress.toile");
        window().openFiles({path("other.obj")});
        QTRY_COMPARE_WITH_TIMEOUT(document().title(), QString("other.obj"), test::kPatience);
        QVERIFY(readProject(file("dress.toile")));
        QVERIFY(session().path().empty());  // another garment, not yet saved
    }

    void whatIsEditedWhileAnotherIsReadIsAskedAbout() {
        writeMesh("other.obj");
        window().openFiles({path("other.obj")});
        edit();
        QTRY_COMPARE_WITH_TIMEOUT(asked_, 1, test::kPatience);
        QCOMPARE(document().title(), QString("dress.obj"));
        QVERIFY(session().isModified());
    }

    void aMeshThatChangedIsNamedAndNothingIsLost() {
        doThings();
        saveAs("dress.toile");
        const test::Moment before = test::momentOf(document());
        writeMesh("dress.obj", 295);
        reopenWindow();
        QVERIFY(fixture_->openAndWait(path("dress.toile")));
        QVERIFY(waitUntilFlat());
        QVERIFY(!window().banner().isHidden());
        QVERIFY(window().banner().sentence().contains("dress.obj"));
        QVERIFY(test::typed(document().loading()) == test::typed(before.state.inputs.loading));
        QCOMPARE(document().settings()[1].quantity, 5);
        QVERIFY(!document().garment()->cuts.empty());
    }

    void aMeshThatIsGoneIsAskedFor() {
        doThings();
        saveAs("dress.toile");
        const test::Moment before = test::momentOf(document());
        QVERIFY(QDir(path("")).mkdir("elsewhere"));
        QVERIFY(QFile::rename(path("dress.obj"), path("elsewhere/frock.obj")));
        reopenWindow();
        window().openFiles({path("dress.toile")});
        QVERIFY(waitForBanner());
        QCOMPARE(lookedFor_, QStringList{"dress.obj"});
        QVERIFY(!document().garment());
        foundMesh_ = path("elsewhere/frock.obj");
        QVERIFY(fixture_->openAndWait(path("dress.toile")));
        QVERIFY(waitUntilFlat());
        QVERIFY(test::isSame(test::momentOf(document()), before));
        QVERIFY(session().isModified());  // where the mesh is, is not saved yet
    }

    void aDamagedProjectLeavesWhatIsOpen() {
        const test::Moment before = test::momentOf(document());
        QVERIFY(writeFile(file("bad.toile"), "{\"format\": 3}"));
        window().openFiles({path("bad.toile")});
        QVERIFY(waitForBanner());
        QVERIFY(window().banner().sentence().contains("bad.toile"));
        QVERIFY(test::momentOf(document()) == before);
        QVERIFY(test::typed(workspace().loading()) == test::typed(before.state.inputs.loading));
    }

    void aProjectAmongMeshesIsRefused() {
        saveAs("dress.toile");
        window().openFiles({path("dress.obj"), path("dress.toile")});
        QVERIFY(!window().banner().isHidden());
        QVERIFY(!workspace().jobs().isBusy());
    }

    void reloadKeepsWhatWasDone() {
        doThings();
        const test::Moment before = test::momentOf(document());
        QTest::keyClick(&window(), Qt::Key_F5);
        QTRY_VERIFY_WITH_TIMEOUT(document().garment() != before.derived.garment, test::kPatience);
        QVERIFY(waitUntilFlat());
        QVERIFY(test::typed(document().loading()) == test::typed(before.state.inputs.loading));
        QCOMPARE(document().settings()[1].quantity, 5);
        QVERIFY(test::isSame(test::momentOf(document()), before));
    }

    void methodsLeavePiecesWhereTheyAre() {
        doThings();
        const auto middle = [this](int piece) -> Eigen::Vector2d {
            return document().settings()[std::size_t(piece)].placement->applied(
                document().results()[std::size_t(piece)]->flat->Q.colwise().mean().transpose());
        };
        const Eigen::Vector2d before = middle(3);
        workspace().setMethod(Method::Lscm);
        QVERIFY(waitUntilFlat());
        QVERIFY((middle(3) - before).norm() < 1e-3);
    }

    void recentFilesAreOffered() {
        saveAs("dress.toile");
        writeMesh("other.obj");
        QVERIFY(fixture_->openAndWait(path("other.obj")));
        QFile::remove(path("dress.obj"));
        auto& menu = fixture_->find<QMenu>("recentMenu");
        emit menu.aboutToShow();
        const auto entries = menu.actions();
        QVERIFY(entries.size() >= 3);
        QVERIFY(entries[0]->text().startsWith("other.obj"));
        QVERIFY(entries[1]->text().startsWith("dress.toile"));
        QVERIFY(entries[2]->text().startsWith("dress.obj"));
        QVERIFY(entries[1]->isEnabled());
        QVERIFY(!entries[2]->isEnabled());
        writeMesh("dress.obj");
        entries[1]->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(session().title(), QString("dress.toile"), test::kPatience);
    }

    void recentFilesAreRemembered() {
        const QList<QStringList> recent{{path("a.obj"), path("b.obj")}, {path("c.toile")}};
        Preferences(path("settings.ini")).setRecentFiles(recent);
        QCOMPARE(Preferences(path("settings.ini")).recentFiles(), recent);
        QVERIFY(Preferences(QString()).recentFiles().isEmpty());
    }

    void namesOfFilesAreNoMarkup() {
        window().openFiles({path("<b>coat</b>.obj")});
        QVERIFY(waitForBanner());
        QVERIFY(window().banner().sentence().contains("<b>coat</b>"));
        for (const QLabel* label : window().banner().findChildren<QLabel*>()) {
            QCOMPARE(label->textFormat(), Qt::PlainText);
        }
    }

    void aNameOfAnyBytesHasAText() {
#ifdef Q_OS_LINUX
        const std::filesystem::path name("b\xf6se.obj");  // Latin-1
        QVERIFY(textOf(name).endsWith("se.obj"));
        workspace().open({name});
        QVERIFY(waitForBanner());
        QCOMPARE(pathOf(textOf("Ärmel/袖.obj")), std::filesystem::path("Ärmel/袖.obj"));
#endif
    }
};

TOILE_WINDOW_TEST(ProjectOpenTest)
#include "project_open_test.moc"
