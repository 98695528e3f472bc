// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "app/session/project_session.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/workspace_fixture.h"

using namespace toile;
using namespace toile::app;

/// Steps back and forth: what they bring back at once, and what has to be made again.
class WorkspaceUndoTest : public QObject, public test::WorkspaceFixture {
    Q_OBJECT

private slots:
    void init() {
        renew();
        QVERIFY(openPair());
    }

    void cleanup() { close(); }

    void aCutIsOneStepAndUndoBringsEverythingBackAtOnce() {
        const test::Moment start = test::momentOf(document());
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
        const test::Moment cut = test::momentOf(document());
        document().history().undo();
        QVERIFY(test::momentOf(document()) ==
                start);  // results and scene too: nothing is solved again
        QVERIFY(!workspace().jobs().isBusy());
        document().history().redo();
        QVERIFY(test::momentOf(document()) == cut);
        QVERIFY(!workspace().jobs().isBusy());
    }

    void undoTakesBackWhatIsStillOnItsWay() {
        const test::Moment start = test::momentOf(document());
        cutAcross("waist", 210);
        QVERIFY(document().history().canUndo());
        document().history().undo();
        QVERIFY(waitUntilDone());
        QVERIFY(test::momentOf(document()) == start);
        QVERIFY(workspace().loading().seams.cuts.empty());
        QVERIFY(!document().history().canUndo());
    }

    void methodsAreUndoneWithTheirResults() {
        const test::Moment start = test::momentOf(document());
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        document().history().undo();
        QVERIFY(test::momentOf(document()) == start);
    }

    void aStepBackWhileFlatteningDropsTheResult() {
        const test::Moment start = test::momentOf(document());
        workspace().setMethod(Method::Abf);
        document().history().undo();
        QVERIFY(waitUntilDone());
        QVERIFY(test::momentOf(document()) == start);
    }

    void oldStatesAreMadeAgain_data() {
        QTest::addColumn<int>("bytes");
        QTest::newRow("the oldest go") << 100000;
        QTest::newRow("everything goes") << 0;
    }

    void oldStatesAreMadeAgain() {
        QFETCH(int, bytes);
        renew();
        FlattenOptions options;
        options.method = Method::Curvature;
        document().setOptions(options);
        workspace().open({file("pair.obj")});
        QVERIFY(waitUntilDone());
        document().cache().setMaxBytes(static_cast<std::size_t>(bytes));
        std::vector<test::Moment> states{test::momentOf(document())};
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        states.push_back(test::momentOf(document()));
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        states.push_back(test::momentOf(document()));
        document().history().undo();
        document().history().undo();
        QVERIFY(waitUntilDone());
        QCOMPARE(test::difference(test::momentOf(document()), states[0]), QString());
        document().history().redo();
        document().history().redo();
        QVERIFY(waitUntilDone());
        QCOMPARE(test::difference(test::momentOf(document()), states[2]), QString());
        QVERIFY(document().scene());
        QCOMPARE(document().pieceCount(), 3);
        QCOMPARE(document().options().method, Method::Natural);
    }

    void anotherStepBackWhileASceneIsMadeLeavesNoneOut() {
        document().cache().setMaxBytes(0);
        document().setSeamEase(0, 0.01);
        document().setSeamEase(1, 0.02);
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        while (document().history().canUndo()) {
            document().history().undo();  // the garment's ease is another each time, not its pieces
        }
        QVERIFY(waitUntilDone());
        QVERIFY(document().scene());
    }

    void cancellingLeavesSomethingToSee() {
        document().cache().setMaxBytes(0);
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        document().history().undo();
        workspace().jobs().cancel();
        QVERIFY(QTest::qWaitFor(
            [this] { return !workspace().jobs().isBusy() && document().scene(); }, kPatience));
        workspace().flattenAgain();
        QVERIFY(waitUntilDone());
        QVERIFY(document().isFlattened());
    }

    void withinTheBudgetNothingGoes() {
        const test::Moment start = test::momentOf(document());
        for (const Method method : {Method::Natural, Method::Curvature, Method::Lscm}) {
            workspace().setMethod(method);
            QVERIFY(waitUntilDone());
        }
        for (int step = 0; step < 3; ++step) {
            document().history().undo();
            QVERIFY(!workspace().jobs().isBusy());
        }
        QVERIFY(test::momentOf(document()) == start);
    }

    void aStepBackToBeforeTheFirstResultsBringsThem_data() {
        QTest::addColumn<bool>("autoFlatten");
        QTest::newRow("flattened after every edit") << true;
        QTest::newRow("when asked for") << false;
    }

    void aStepBackToBeforeTheFirstResultsBringsThem() {
        QFETCH(bool, autoFlatten);
        workspace().setAutoFlatten(autoFlatten);
        const auto once =
            connect(&document(), &Document::opened, this, [this] { changeFabric("jersey"); });
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        disconnect(once);
        QCOMPARE(document().history().count(), 1);
        document().history().undo();
        QVERIFY(document().results().empty() || document().isFlattened());
        QVERIFY(waitUntilDone());
    }

    void undoTakesTheLastEditBackAlone() {
        cutAcross("waist", 210);
        workspace().cuts().change("Another", [](SeamsFile& seams) {
            seams.cuts.push_back({"hip", UserCut::Kind::Path, {{0, 110, 0}, {300, 110, 0}}, false});
        });
        QCOMPARE(document().history().undoText(), QString("Another"));
        document().history().undo();
        QCOMPARE(document().history().undoText(), QString("Cut"));
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
        QCOMPARE(document().history().index(), 1);
    }

    void aCancelledFlatteningOfAnOldStateStaysCancelled() {
        document().cache().setMaxBytes(0);
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        document().history().undo();
        QVERIFY(!document().isFlattened());
        workspace().cancel();
        QVERIFY(waitUntilIdle());
        QVERIFY(document().scene());  // something to see, and no more
        QVERIFY(!document().isFlattened());
        document().history().redo();
        QVERIFY(waitUntilDone());
        document().history().undo();  // it is wanted anew
        QVERIFY(waitUntilDone());
    }

    void aStepBackAfterCancellingBringsWhatWasFlat() {
        document().cache().setMaxBytes(0);
        const test::Moment start = test::momentOf(document());
        changeFabric("jersey");
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        document().history().undo();
        workspace().jobs().cancel();
        QVERIFY(waitUntilIdle());
        QVERIFY(!document().isFlattened());
        document().history().undo();  // pieces and options stay
        QVERIFY(waitUntilDone());
        QCOMPARE(test::difference(test::momentOf(document()), start), QString());
    }

    void aStepForwardToWhatIsFlatKeepsItToTheLastBit() {
        whenOpened([this] { changeFabric("jersey"); });
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        QCOMPARE(document().history().count(), 1);
        const test::Moment flat = test::momentOf(document());
        document().history().undo();
        QVERIFY(!workspace().jobs().isBusy());  // the same pieces, flattened alike
        document().history().redo();
        QVERIFY(test::momentOf(document()) == flat);
        QVERIFY(waitUntilIdle());
        QVERIFY(test::momentOf(document()) == flat);
    }

    void aStepBackToAnotherMethodBeforeTheFirstResultsBringsThem() {
        workspace().setAutoFlatten(false);
        whenOpened([this] { workspace().setMethod(Method::Natural); });
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        document().history().undo();
        QVERIFY(!document().isFlattened());  // nobody has asked for that
        workspace().flattenAgain();
        QVERIFY(waitUntilDone());
        QCOMPARE(document().results()[0]->options.method, Method::Isometric);
    }

    void whatUndoTakesBackIsNoCancelling() {
        QSignalSpy cancelled(&workspace().jobs(), &JobRunner::cancelled);
        cutAcross("waist", 210);
        document().history().undo();
        QVERIFY(waitUntilIdle());
        workspace().setMethod(Method::Natural);
        document().history().undo();
        QVERIFY(waitUntilIdle());
        QCOMPARE(cancelled.count(), 2);
        QVERIFY(cancelled[0][1].toBool() && cancelled[1][1].toBool());
        workspace().setMethod(Method::Natural);  // and so nothing has been declined
        QVERIFY(waitUntilDone());
    }

    /// Whatever was done, and however fast, the flat positions are those of the inputs alone; also
    /// when the project is opened again.
    void flatPositionsFollowFromTheInputs_data() {
        QTest::addColumn<int>("seed");
        QTest::newRow("one") << 1;
        QTest::newRow("another") << 2;
    }

    void flatPositionsFollowFromTheInputs() {
        QFETCH(int, seed);
        constexpr int kEdits = 200, kLooks = 5;
        std::mt19937 random(static_cast<unsigned>(seed));
        renew();
        document().cache().setMaxBytes(seed == 1 ? DerivedCache::kMaxBytes : 200000);
        workspace().open({file("cap.obj")});
        QVERIFY(waitUntilDone());
        for (int edit = 1; edit <= kEdits; ++edit) {
            doSomething(random);
            if (random() % 3 == 0) {
                QTest::qWait(static_cast<int>(random() % 20));
            }
            if (edit % (kEdits / kLooks) == 0) {
                QVERIFY(waitUntilDone());
                QCOMPARE(differenceToAnew(), QString());
            }
        }
        workspace().setMethod(Method::Isometric);
        document().setLines(seed == 1 ? LineSettings{} : withPattern({}), "Lines");
        QVERIFY(waitUntilDone());
        const test::Moment before = test::momentOf(document());
        ProjectSession session(workspace());
        session.save(file("random.toile"));
        QTRY_VERIFY_WITH_TIMEOUT(!session.isSaving(), kPatience);
        renew();
        ProjectSession another(workspace());
        another.open(file("random.toile"));
        QVERIFY(QTest::qWaitFor([this] { return document().garment() != nullptr; }, kPatience));
        QVERIFY(waitUntilDone());
        QCOMPARE(test::pointsDifference(document().results(), before.derived.results), QString());
        QCOMPARE(document().settings().size(), before.derived.garment->pieces.size());
        for (std::size_t k = 0; k < document().settings().size(); ++k) {
            const auto said = before.state.settings.find(document().garment()->pieces[k]->id);
            QVERIFY(said != before.state.settings.end());
            QVERIFY(document().settings()[k].placement == said->second.placement);
            QVERIFY(document().settings()[k].grain == said->second.grain);
        }
        QCOMPARE(differenceToAnew(), QString());
    }

private:
    /// What is not as it comes of the document's inputs in a program that has done nothing else.
    QString differenceToAnew() {
        Progress progress;
        const DocumentState& state = document().state();
        const auto garment = makeGarment(state.inputs, progress);
        return garment ? test::pointsDifference(
                             document().results(),
                             flattenGarment(*garment, state.options, progress, 0, state.lines))
                       : QString("no garment");
    }

    void doSomething(std::mt19937& random) {
        const auto any = [&random](std::size_t count) { return random() % count; };
        switch (any(10)) {
            case 0:
            case 1:
            case 2: {
                const Piece& piece =
                    *document().garment()->pieces[any(document().garment()->pieces.size())];
                if (piece.boundary.empty() || document().loading().seams.cuts.size() > 4) {
                    break;
                }
                UserCut cut;
                for (int end = 0; end < 2; ++end) {
                    const int vertex = piece.boundary[any(piece.boundary.size())];
                    cut.points.emplace_back(piece.mesh.V.row(vertex));
                }
                workspace().cuts().add(cut);
                break;
            }
            case 3:
                if (const auto& cuts = document().loading().seams.cuts; !cuts.empty()) {
                    workspace().cuts().remove(cuts[any(cuts.size())].id);
                }
                break;
            case 4:
                workspace().setMethod(any(3) == 0 ? Method::Curvature : Method::Isometric);
                break;
            case 5:
                if (document().seamCount() > 0) {
                    workspace().cuts().joinSeam(
                        static_cast<int>(any(std::size_t(document().seamCount()))));
                }
                break;
            case 6:
                workspace().setUnit(any(2) == 0 ? LengthUnit::Millimetre : LengthUnit::Inch);
                break;
            case 7:
                document().setLines(any(2) == 0 ? withPattern({}) : LineSettings{}, "Lines");
                break;
            default:
                any(3) == 0 ? document().history().redo() : document().history().undo();
        }
    }
};

TOILE_WINDOW_TEST(WorkspaceUndoTest)
#include "workspace_undo_test.moc"
