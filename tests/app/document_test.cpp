// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"

#include <QSignalSpy>
#include <QTest>

#include "app/document/layout.h"
#include "app/render/scene.h"
#include "core/pattern/drawn_outline.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

std::shared_ptr<const Garment> twoPieces() {
    return test::makeGarment(
        {{"front", test::makeSheet(100, 50, 2, 1)}, {"back", test::makeSheet(80, 50, 2, 1)}});
}

/// A sheet of 100 by 50 mm, flat, its outline drawn from the middle of its lower side on.
std::shared_ptr<const PieceResult> drawnSymmetric(const std::shared_ptr<const Piece>& piece) {
    auto result = std::make_shared<PieceResult>();
    result->piece = piece;
    auto line = std::make_shared<FlatLine>();
    line->points.resize(6, 2);
    line->points << 50, 0, 100, 0, 100, 50, 50, 50, 0, 50, 0, 0;
    line->arc = {50, 100, 150, 200, 250, 300, 350};
    result->flat.emplace();
    result->flat->Q = piece->mesh.V.leftCols<2>();
    result->flat->line = line;
    auto plan = std::make_shared<OutlinePlan>();
    plan->mirrored.emplace().isSymmetric = true;
    result->plan = plan;
    return result;
}

/// Announced changes, and whether the last one touched some part of the document.
struct Told {
    template <class... Keys>
    explicit Told(Document& document, Keys... keys) {
        QObject::connect(&document, &Document::changed, &context, [=, this](const auto& what) {
            ++count;
            content = what.touchesContent();
            pieces = what.hasOtherPieces();
            touched = {what.touches(keys)...};
        });
    }

    int count = 0;
    bool content = false, pieces = false;
    std::vector<bool> touched;
    QObject context;
};

}  // namespace

class DocumentTest : public QObject {
    Q_OBJECT

private slots:
    void newGarmentClearsResultsAndSelectionInOneChange() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        document.setSelection({0, 1});
        const Told told(document, DocumentChange::Selection);
        QSignalSpy opened(&document, &Document::opened);
        test::setGarment(document, twoPieces(), nullptr);
        QCOMPARE(told.count, 1);
        QCOMPARE(opened.count(), 1);
        QVERIFY(told.pieces);
        QVERIFY(told.touched[0]);
        QVERIFY(document.selection().empty());
        QVERIFY(document.results().empty());
    }

    void revisionRisesWithGarmentAndOptionsOnly() {
        Document document;
        const auto start = document.revision();
        test::setGarment(document, twoPieces(), nullptr);
        const auto afterGarment = document.revision();
        QVERIFY(afterGarment > start);
        document.setSelection({1});
        document.setOverlay(Overlay::Strain);
        document.setView(&ViewState::wireframe, true);
        test::setResults(document, PieceResults(2, std::make_shared<PieceResult>()), nullptr);
        QCOMPARE(document.revision(), afterGarment);
        FlattenOptions natural;
        natural.method = Method::Natural;
        document.setOptions(natural);
        const auto afterMethod = document.revision();
        QVERIFY(afterMethod > afterGarment);
        natural.freeBoundary = FreeBoundary::Spectral;
        document.setOptions(natural);
        QVERIFY(document.revision() > afterMethod);
    }

    void settingWhatIsAlreadySoSaysNothing() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        document.setSelection({0});
        QSignalSpy spy(&document, &Document::changed);
        document.setSelection({0});
        document.setOverlay(document.view().overlay);
        document.setView(&ViewState::wireframe, false);
        document.setOptions(document.options());
        QCOMPARE(spy.count(), 0);
    }

    void selectionHoldsPiecesOfTheGarmentOnly() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        document.setSelection({-1, 1, 2, 99});
        QCOMPARE(document.selection(), Document::Selection{1});
    }

    void togglingAddsAndRemoves() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        document.toggleSelected(1);
        document.toggleSelected(0);
        QCOMPARE(document.selection(), (Document::Selection{0, 1}));
        document.toggleSelected(1);
        QCOMPARE(document.selection(), Document::Selection{0});
    }

    void changesNameWhatHasChanged() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        const Told told(document, DocumentChange::View, DocumentChange::Selection,
                        &Derived::results, &DocumentState::lines);
        document.setOverlay(Overlay::Area);
        QCOMPARE(told.touched, (std::vector{true, false, false, false}));
        QVERIFY(!told.content);
        document.setSelection({1});
        QCOMPARE(told.touched, (std::vector{false, true, false, false}));
        QVERIFY(!told.content);
        test::setResults(document, PieceResults(2, std::make_shared<PieceResult>()), nullptr);
        QCOMPARE(told.touched, (std::vector{false, false, true, false}));
        QVERIFY(told.content);
        LineSettings lines;
        lines.label.size = "38";
        document.setLines(lines, "Size");
        QCOMPARE(told.touched, (std::vector{false, false, false, true}));
        QVERIFY(told.content && !told.pieces);
    }

    void whatThePointerIsOnIsToldApart() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        QSignalSpy changed(&document, &Document::changed);
        QSignalSpy hovered(&document, &Document::hovered);
        document.setHover(Feature{.piece = 1});
        document.setHover(Feature{.piece = 1});
        document.setHover(Feature{.piece = 2});  // is none
        QCOMPARE(hovered.count(), 2);
        QCOMPARE(changed.count(), 0);
    }

    void withoutAGarmentSettingsAreNoSteps() {
        Document document;
        const Told told(document, &DocumentState::options, &DocumentState::proof);
        FlattenOptions natural;
        natural.method = Method::Natural;
        document.setOptions(natural);
        QCOMPARE(told.touched, (std::vector{true, false}));
        ProofPlan plan;
        plan.settings.edge = 7;
        document.edit("Edge", &DocumentState::proof, plan);
        QCOMPARE(told.touched, (std::vector{false, true}));
        QVERIFY(document.options() == natural && document.state().proof == plan);
        QVERIFY(document.isCurrent());
        QCOMPARE(document.history().count(), 0);
    }

    void selectedSeamIsOneOfTheGarments() {
        Document document;
        test::setGarment(document, test::makeSewnCap(), nullptr);
        const Told told(document, DocumentChange::Selection);
        document.setSeam(0);
        QCOMPARE(document.seam(), std::optional(0));
        QVERIFY(told.touched[0]);
        document.setSeam(0);
        QCOMPARE(told.count, 1);
        document.setSeam(document.seamCount());
        QVERIFY(!document.seam());
        document.setSeam(0);
        test::setGarment(document, twoPieces(), nullptr);
        QVERIFY(!document.seam());
    }

    void oneThingIsSelectedAtATime() {
        Document document;
        test::setGarment(document, test::makeSewnCap(), nullptr);
        const Feature run{.kind = Feature::Kind::Run, .piece = 0, .first = 0, .count = 1};
        QSignalSpy spy(&document, &Document::changed);
        document.setSelection({1});
        document.setSeam(0);
        QVERIFY(document.selection().empty());
        QCOMPARE(spy.count(), 2);
        document.setMark(run);
        QVERIFY(document.mark() && !document.seam());
        document.setMark(run, 0);  // of this seam
        QVERIFY(document.mark() && document.seam());
        document.setSelection({0});
        QVERIFY(!document.mark() && !document.seam());
        document.setSeam({});
        document.setMark({});
        QCOMPARE(document.selection(), Document::Selection{0});
        document.selectNothing();
        QVERIFY(document.selection().empty());
        const auto count = spy.count();
        document.selectNothing();
        QCOMPARE(spy.count(), count);
    }

    void easeIsSwappedInAndEverythingElseStays() {
        Document document;
        test::setGarment(document, test::makeSewnCap(), std::make_shared<Scene>());
        test::setResults(document, PieceResults(2, std::make_shared<PieceResult>()),
                         std::make_shared<Scene>());
        document.setSeam(0);
        const auto before = document.garment();
        const auto scene = document.scene();
        const auto revision = document.revision();
        const Told told(document, &Derived::garment, &DocumentState::inputs, &Derived::results,
                        &DocumentState::settings);
        document.setSeamEase(0, 0.04);
        QCOMPARE(told.touched, (std::vector{true, true, false, false}));
        QVERIFY(!told.pieces);
        QCOMPARE(document.garment()->seams.seams[0].ease, std::optional(0.04));
        QCOMPARE(document.history().undoText(), "Set ease of " + seamName(document, 0));
        QVERIFY(!before->seams.seams[0].ease);  // a job may hold it
        QCOMPARE(document.garment()->pieces[0], before->pieces[0]);
        QCOMPARE(document.scene(), scene);
        QCOMPARE(document.results().size(), std::size_t(2));
        QCOMPARE(document.seam(), std::optional(0));
        QCOMPARE(document.revision(), revision);
        document.setSeamEase(0, 0.04);
        QCOMPARE(told.count, 1);
        document.setSeamEase(0, std::nullopt);
        QVERIFY(!document.garment()->seams.seams[0].ease);
    }

    void anEditIsAStepThatUndoBringsBackWhole() {
        Document document;
        test::setGarment(document, twoPieces(), std::make_shared<Scene>());
        const test::Moment start = test::momentOf(document);
        DocumentState next = start.state;
        test::said(next, document, 1).placement = Placement{{10, 20}, 0.5, true};
        next.fabric = *fabricPreset("denim");
        const Told told(document, &DocumentState::settings, &DocumentState::fabric,
                        &DocumentState::lines);
        document.edit("Move", next);
        QCOMPARE(told.touched, (std::vector{true, true, false}));
        QVERIFY(document.state() == next);
        QCOMPARE(document.history().undoText(), QString("Move"));
        document.history().undo();
        QVERIFY(test::momentOf(document) == start);
        document.history().redo();
        QVERIFY(document.state() == next);
        QCOMPARE(told.count, 3);
    }

    void anEditThatChangesNothingIsNoStep() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        QSignalSpy spy(&document, &Document::changed);
        document.edit("Nothing", document.state());
        QCOMPARE(spy.count(), 0);
        QCOMPARE(document.history().count(), 0);
    }

    void theEditsOfOneGestureAreOneStep() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        const test::Moment start = test::momentOf(document);
        const auto move = [&document](double x, int gesture) {
            DocumentState next = document.state();
            test::said(next, document, 0).placement = Placement{{x, 0}};
            document.edit("Move", next, gesture);
        };
        const int first = document.newGesture();
        for (const double x : {1, 2, 3}) {
            move(x, first);
        }
        const int second = document.newGesture();
        move(5, second);
        QCOMPARE(document.history().count(), 2);
        document.history().undo();
        QCOMPARE(document.settings()[0].placement->offset.x(), 3.0);
        document.history().undo();
        QVERIFY(test::momentOf(document) == start);
    }

    void aGestureThatEndsWhereItBeganVanishes() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        DocumentState away = document.state();
        const DocumentState start = away;
        test::said(away, document, 0).grain = 0.3;
        const int gesture = document.newGesture();
        document.edit("Turn grain", away, gesture);
        document.edit("Turn grain", start, gesture);
        QVERIFY(document.state() == start);
        QCOMPARE(document.history().count(), 0);
    }

    void whatWasWorkedOutComesBackWithItsState() {
        Document document;
        test::setGarment(document, twoPieces());
        const auto resultsBy = [&document](Method method) {
            PieceResults results;
            for (const auto& piece : document.garment()->pieces) {
                auto result = std::make_shared<PieceResult>();
                result->piece = piece;
                result->options.method = method;
                results.push_back(std::move(result));
            }
            return results;
        };
        const PieceResults first = resultsBy(Method::Isometric),
                           second = resultsBy(Method::Natural);
        test::setResults(document, first, std::make_shared<Scene>());
        QVERIFY(document.isFlattened());
        FlattenOptions natural;
        natural.method = Method::Natural;
        document.setOptions(natural);
        QVERIFY(document.results() == first);  // until others come
        QVERIFY(!document.isFlattened());
        test::setResults(document, second, std::make_shared<Scene>());
        document.history().undo();
        QVERIFY(document.results() == first);
        QVERIFY(document.isFlattened());
        document.history().redo();
        QVERIFY(document.results() == second);
        document.cache().setMaxBytes(0);  // nothing is counted of what has no size
        document.history().undo();
        QVERIFY(document.results() == first);
    }

    void aStepToOtherPiecesKeepsTheSelectionById() {
        Document document;
        test::setGarment(document, twoPieces());
        document.setSelection({0, 1});
        test::editGarment(document, "Cut",
                          test::makeGarment({{"sleeve", test::makeSheet(30, 50, 1, 1)},
                                             {"front", test::makeSheet(90, 50, 2, 1)}}));
        QCOMPARE(document.selection(), Document::Selection{1});
        QCOMPARE(document.settings().size(), std::size_t(2));
        const auto revision = document.revision();
        document.history().undo();
        QVERIFY(document.revision() > revision);
        QCOMPARE(document.selection(), Document::Selection{0});
    }

    void stepsThatCameToNothingAreTakenBackForGood() {
        Document document;
        test::setGarment(document, twoPieces());
        const DocumentState start = document.state();
        DocumentState next = start;
        next.inputs.loading.weld = true;  // nobody works out what that gives
        document.edit("Weld", next);
        QVERIFY(!document.isCurrent());
        next.fabric = *fabricPreset("jersey");
        document.edit("Fabric", next);
        DocumentState rest = next;
        rest.inputs = start.inputs;
        QSignalSpy spy(&document, &Document::changed);
        document.takeBack(rest);
        QCOMPARE(spy.count(), 1);
        QVERIFY(document.isCurrent());
        QCOMPARE(document.history().count(), 1);
        QCOMPARE(document.history().undoText(), QString("Fabric"));
        QCOMPARE(document.fabric().id, std::string("jersey"));
        document.history().undo();
        QVERIFY(document.state() == start);
        document.edit("Weld", next);
        document.takeBack(start);
        QCOMPARE(document.history().count(), 0);
    }

    void aStepBackThatCameToNothingIsDoneAgain() {
        Document document;
        test::setGarment(document, twoPieces());
        DocumentState next = document.state();
        next.fabric = *fabricPreset("jersey");
        document.edit("Fabric", next);
        test::editGarment(document, "Cut", test::makeGarment({{"a", test::makeSheet(9, 9, 1, 1)}}));
        const test::Moment cut = test::momentOf(document);
        next = document.state();
        test::said(next, document, 0).quantity = 4;
        document.edit("Quantity", next);
        document.cache().clear();
        for (int step = 0; step < 3; ++step) {
            document.history().undo();
        }
        QVERIFY(!document.isCurrent());  // nobody knows any more what followed from that
        DocumentState rest = document.state();
        rest.inputs = document.derived().inputs;
        document.takeBack(rest);
        QVERIFY(test::momentOf(document) == cut);  // back to what can be shown, no farther
        QCOMPARE(document.history().index(), 2);
        QCOMPARE(document.history().count(), 3);
    }

    void anotherGarmentHasNoHistory() {
        Document document;
        test::setGarment(document, twoPieces(), nullptr);
        DocumentState next = document.state();
        next.fabric = *fabricPreset("jersey");
        document.edit("Fabric", next);
        test::setGarment(document, twoPieces(), nullptr);
        QCOMPARE(document.history().count(), 0);
        QCOMPARE(document.fabric().id, std::string("jersey"));
    }

    void symmetricPieceIsCutOnTheFoldWhereThatIsSaid() {
        Document document;
        const auto garment = twoPieces();
        test::setGarment(document, garment, nullptr);
        test::setResults(document, {drawnSymmetric(garment->pieces[0]), nullptr}, nullptr);
        QCOMPARE(cutAsOf(document, 0), CutAs::Whole);
        DocumentState next = document.state();
        test::said(next, document, 0).byHalf = true;
        test::said(next, document, 1).byHalf = true;
        document.edit("Half", next);
        QCOMPARE(cutAsOf(document, 0), CutAs::OnFold);
        QCOMPARE(cutAsOf(document, 1), CutAs::Whole);  // it is not flat
    }

    void titleIsTheFilesName() {
        Document document;
        QVERIFY(document.title().isEmpty());
        test::setGarment(document, twoPieces(), nullptr);
        QCOMPARE(document.title(), QString("garment.obj"));
    }
};

TOILE_WINDOW_TEST(DocumentTest)
#include "document_test.moc"
