// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern sewn back together in the window: by real keys and clicks, what is seen of it on its
// way and once it is there, and what becomes of it when the pattern is edited.
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <algorithm>

#include "app/document/line_facts.h"
#include "app/document/shown_proof.h"
#include "app/jobs/file_jobs.h"
#include "app/jobs/ready_checker.h"
#include "app/panels/proof_form.h"
#include "app/panels/proof_model.h"
#include "app/render/sewn_cloth.h"
#include "app/session/pattern_proof.h"
#include "app/views/colour_bar.h"
#include "app/views/feature_text.h"
#include "app/views/garment_view.h"
#include "app/views/sewn_run.h"
#include "app/views/way_bars.h"
#include "app/widgets/stated_edit.h"
#include "core/project/project_file.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class ProofPanelTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    PatternProof& proof() { return fixture_.workspace().proof(); }

    template <class Widget>
    Widget& find(const char* name) {
        return fixture_.find<Widget>(name);
    }

    void openSample(const QString& name) { QVERIFY(fixture_.openAndWait(fixture_.path(name))); }

    void press(ActionId id) {
        const QKeySequence keys = fixture_.action(id).shortcut();
        QTest::keySequence(&fixture_.window(), keys);
    }

    bool waitUntilProved() {
        return QTest::qWaitFor([this] { return !proof().isRunning() && isProved(); },
                               test::kPatience) &&
               fixture_.waitForResults();
    }

    bool isProved() { return document().isProofCurrent(); }

    /// Cloth of the garment on its way to be sewn, so far off from where it was designed.
    std::shared_ptr<const ShownProof> onItsWay(double millimetres) {
        ShownProof way;
        way.ground =
            proofGround(document().derived(), document().state(), document().settings(), {});
        std::vector<Points3> places;
        for (const auto& piece : document().garment()->pieces) {
            places.emplace_back((piece->mesh.V.array() + millimetres).matrix());
        }
        const auto& scene = document().scene();
        way.cloth = sewnCloth(scene, lineAnchors(*scene), places, nullptr);
        return std::make_shared<const ShownProof>(std::move(way));
    }

    std::shared_ptr<const ShownProof> as(SewnPattern sewn) {
        ShownProof other = *document().proof();
        other.plan.sewn = sewn;
        other.ground =
            proofGround(document().derived(), document().state(), document().settings(), sewn);
        other.cloth = sewnCloth(document().scene(), *other.proof, sewn);
        return std::make_shared<const ShownProof>(std::move(other));
    }

    ReadyChecker& checker() { return fixture_.window().checker(); }
    bool waitUntilChecked() {
        return QTest::qWaitFor([this] { return checker().isUpToDate(); }, test::kPatience);
    }

    void prove() {
        press(ActionId::ProveBySewing);
        QVERIFY(waitUntilProved());
    }

    QString sentence() { return find<QLabel>("proofSentence").text(); }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        // A sheet, which is sewn in no time.
        test::writeObj(fixture_.path("sheet.obj").toStdString(),
                       {{"sheet", test::makeSheet(200, 160, 8, 6)}});
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj",
                            fixture_.path("tshirt.obj")));
    }

    void init() { fixture_.open(); }
    void cleanup() { fixture_.close(); }

    void withoutAGarmentThereIsNothingToSew() {
        QVERIFY(!fixture_.action(ActionId::ProveBySewing).isEnabled());
        openSample("sheet.obj");
        QVERIFY(fixture_.action(ActionId::ProveBySewing).isEnabled());
        QVERIFY(!fixture_.action(ActionId::SaveProof).isEnabled());
        QVERIFY(!fixture_.action(ActionId::PlaySewn).isEnabled());
    }

    void aKeyProvesAndShowsWhatCameOfIt() {
        openSample("sheet.obj");
        prove();
        QVERIFY(find<QWidget>("proofDock").isVisible());
        QVERIFY2(sentence().contains(" mm from the design on average"), qPrintable(sentence()));
        QCOMPARE(find<QTreeView>("proofTable").model()->rowCount(), 1);
        QCOMPARE(document().view().overlay, Overlay::Gap);
        QCOMPARE(document().history().count(), 0);  // it is no step
        QVERIFY(!find<QLabel>("proofOutdated").isVisible());
        QVERIFY(find<QWidget>("sewnBar").isVisible());
    }

    void theButtonOfTheListProvesToo() {
        openSample("sheet.obj");
        press(ActionId::GoToProof);
        QVERIFY(find<QPushButton>("proveButton").isVisible());
        QTest::mouseClick(&find<QPushButton>("proveButton"), Qt::LeftButton);
        QVERIFY(waitUntilProved());
        QCOMPARE(find<QPushButton>("proveButton").text(), QString("Prove again"));
    }

    void anOverlayOfSewnClothAsksForTheProof() {
        openSample("sheet.obj");
        fixture_.action(overlayAction(Overlay::Gap)).trigger();
        QVERIFY(find<QPushButton>("proveButton").isVisible());
        const QImage before = fixture_.garmentPicture();
        QVERIFY(!shownValueAt(document(), {.piece = 0, .face = 0}));
        prove();
        QVERIFY(shownValueAt(document(), {.piece = 0, .face = 0}));
        QVERIFY(fixture_.garmentPicture() != before);
    }

    void theOverlaysShowWhatWasMeasured() {
        openSample("sheet.obj");
        prove();
        const auto& found = *document().proof()->proof;
        const auto cloth = sewnOf(document());
        QVERIFY(cloth && cloth->isMeasured);
        QCOMPARE(cloth->vertices.size(), document().scene()->vertices.size());
        const auto& face = document().garment()->pieces[0]->mesh.F.row(0);
        const SurfaceHit corner{.piece = 0, .face = 0, .barycentric = {1, 0, 0}};
        QVERIFY(std::abs(*shownValueAt(document(), corner) - found.pieces[0].gap[face[0]]) < 1e-4);
        fixture_.action(overlayAction(Overlay::WornStrain)).trigger();
        QVERIFY(std::abs(*shownValueAt(document(), corner) -
                         100 * found.pieces[0].strain[face[0]]) < 1e-4);
    }

    void theSliderLaysTheGarmentAsItIsSewn() {
        openSample("tshirt.obj");
        prove();
        document().setOverlay(Overlay::None);
        QVERIFY(fixture_.waitForResults());
        auto& slider = find<QSlider>("sewnSlider");
        auto& morph = find<QSlider>("morphSlider");
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_Home);  // it may still be on its way there
        const QImage designed = fixture_.garmentPicture();
        QTest::keyClick(&slider, Qt::Key_End);
        QCOMPARE(fixture_.garmentView().sewnWay(), 1.0);
        QVERIFY(fixture_.garmentPicture() != designed);
        // Of the two ways it goes one at a time.
        morph.setFocus();
        QTest::keyClick(&morph, Qt::Key_End);
        QCOMPARE(fixture_.garmentView().sewnWay(), 0.0);
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_End);
        QCOMPARE(fixture_.garmentView().morph(), 0.0);
        QTest::keyClick(&slider, Qt::Key_Home);
        QVERIFY(fixture_.garmentPicture() == designed);
    }

    void linesComeAlongWithTheCloth() {
        openSample("sheet.obj");
        prove();
        const auto cloth = sewnOf(document());
        const Scene& scene = *document().scene();
        const VertexRun& seam = scene.garmentLines.seams.front()[0];
        for (std::uint32_t i = seam.first; i < seam.first + seam.count; ++i) {
            const SewnVertex& line = cloth->lineVertices[i];
            QCOMPARE(line.isSewn, 1.0F);
            const auto nearest =
                std::ranges::min_element(cloth->vertices, {}, [&line](const SewnVertex& vertex) {
                    return (wornPoint(vertex) - wornPoint(line)).norm();
                });
            QVERIFY((wornPoint(*nearest) - wornPoint(line)).norm() < 20);
        }
    }

    void anEditMakesItOfAnEarlierPattern() {
        openSample("sheet.obj");
        prove();
        fixture_.action(ActionId::QualityDraft).trigger();
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(!isProved());
        QVERIFY(find<QLabel>("proofOutdated").isVisible());
        QVERIFY(!sewnOf(document()));
        QVERIFY(!find<QWidget>("sewnBar").isVisible());
        QVERIFY(!fixture_.action(ActionId::SaveProof).isEnabled());
        QVERIFY(!shownValueAt(document(), {.piece = 0, .face = 0}));
        press(ActionId::Undo);  // and it is of this pattern again
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(isProved());
        QVERIFY(sewnOf(document()) != nullptr);
        QVERIFY(!find<QLabel>("proofOutdated").isVisible());
    }

    void whatDoesNotTouchTheClothLeavesIt() {
        openSample("sheet.obj");
        prove();
        document().setSelection({0});
        press(ActionId::TurnLeft);
        QVERIFY(isProved() && sewnOf(document()));
        DocumentState next = document().state();
        next.settings.begin()->second.placement = Placement{};
        document().edit("Move", next);
        QVERIFY(isProved());
    }

    void allowancesAndNotchesLeaveIt() {
        openSample("sheet.obj");
        prove();
        const auto before = sewnOf(document());
        LineSettings lines = document().state().lines;
        lines.allowance = AllowanceWidths{};
        lines.notches = NotchRules{};
        document().setLines(lines, "Allowance");
        QVERIFY(fixture_.waitUntilIdle() && fixture_.waitForResults());
        QVERIFY(isProved());
        QVERIFY(sewnOf(document()) != nullptr);  // on the scene that has them
        QVERIFY(sewnOf(document()) != before);
        const LineFacts facts =
            lineFacts(*document().garment(), document().results(), document().state().lines);
        lines.segments.push_back({facts.segments[0].segments[0].place});
        lines.segments.back().edge = EdgeKind::Slit;
        document().setLines(lines, "Kind of edge");
        QVERIFY(fixture_.waitUntilIdle() && fixture_.waitForResults());
        QVERIFY(isProved());
    }

    void whatElseWasSewnIsNoProofOfThisPattern() {
        openSample("sheet.obj");
        prove();
        QVERIFY(waitUntilChecked());
        QVERIFY(checker().plan().proof == document().proof()->proof);
        document().showProof(as(SewnPattern::Designer));
        QVERIFY(waitUntilChecked());
        QVERIFY(!checker().plan().proof);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(find<ColourBar>("colourBar").summary().contains("designer's panels"));
        QVERIFY(find<QLabel>("proofOutdated").isVisible());  // this pattern is asked for
    }

    void anotherReferenceMakesItOld() {
        openSample("sheet.obj");
        prove();
        document().showProof(as(SewnPattern::Reference));
        QVERIFY(isProved());
        DocumentState next = document().state();
        next.reference.path = "reference.dxf";
        next.reference.file = std::make_shared<const PatternFile>();
        document().edit("Reference", next);
        QVERIFY(!isProved());
    }

    void otherSettingsAreSaid() {
        openSample("sheet.obj");
        prove();
        QVERIFY(!find<QLabel>("proofOutdated").isVisible());
        find<QAbstractButton>("proofGravity").click();
        QVERIFY(find<QLabel>("proofOutdated").isVisible());
        QVERIFY(isProved() && sewnOf(document()));  // and it is shown on
    }

    void aPlanIsOfItsGarment() {
        openSample("sheet.obj");
        ProofPlan plan;
        plan.sewn = SewnPattern::Designer;
        plan.body = "body.obj";
        plan.settings.pressure = 30;
        plan.settings.stiffness.warp = 40;
        document().edit("Plan", &DocumentState::proof, plan);
        openSample("sheet.obj");  // again
        QVERIFY(proof().plan() == plan);
        openSample("tshirt.obj");
        QVERIFY(proof().plan() == ProofPlan());  // another garment starts afresh
    }

    void withoutAReferenceTheOwnPatternIsSewn() {
        openSample("sheet.obj");
        ProofPlan plan;
        plan.sewn = SewnPattern::Reference;
        document().edit("Plan", &DocumentState::proof, plan);
        QVERIFY(proof().plan().sewn == SewnPattern::Own);
        find<QAbstractButton>("proofGravity").click();
        QVERIFY(document().state().proof.sewn == SewnPattern::Reference);  // it stays said
        DocumentState next = document().state();
        next.reference.path = "reference.dxf";
        next.reference.file = std::make_shared<const PatternFile>();
        document().edit("Reference", next);
        QVERIFY(proof().plan().sewn == SewnPattern::Reference);
    }

    void whatIsSaidIsAStep() {
        openSample("sheet.obj");
        press(ActionId::GoToProof);
        find<QAbstractButton>("proofGravity").click();
        QCOMPARE(document().history().count(), 1);
        QVERIFY(!document().history().isClean());
        auto& pressure = find<QAbstractSpinBox>("proofPressure");
        pressure.setFocus();
        for (int step = 0; step < 3; ++step) {
            QTest::keyClick(&pressure, Qt::Key_Up);
        }
        QCOMPARE(document().state().proof.settings.pressure, 13.0);
        QCOMPARE(document().history().count(), 2);  // of one gesture
        document().history().undo();
        QCOMPARE(pressure.text().section(' ', 0, 0).toDouble(), 10.0);
        QVERIFY(find<QAbstractButton>("proofGravity").isChecked());
        document().history().undo();
        QVERIFY(document().state().proof == ProofPlan{});
        QVERIFY(!find<QAbstractButton>("proofGravity").isChecked());
    }

    void aProjectKeepsWhatIsSaid() {
        openSample("sheet.obj");
        ProofPlan plan;
        plan.sewn = SewnPattern::Designer;
        plan.body = fixture_.path("body.obj").toStdString();  // which need not be there
        plan.bodyUnit = LengthUnit::Inch;
        plan.settings.hasGravity = true;
        plan.settings.stiffness.bending = 20e-6;
        document().edit("Plan", &DocumentState::proof, plan);
        const Project project =
            projectOf(document().state(), document().derived(), document().view());
        QVERIFY(writeProject(fixture_.path("sheet.toile").toStdString(), project));
        openSample("tshirt.obj");
        openSample("sheet.toile");
        QVERIFY(document().state().proof == plan);
        QVERIFY(document().history().isClean());
        QVERIFY(find<QToolButton>("proofMeasured").isChecked());
        QVERIFY(find<StatedEdit>("proofStiffnessBending").stated().has_value());
    }

    void measuredClothIsStatedAndLeftToTheFabricAgain() {
        openSample("sheet.obj");
        press(ActionId::GoToProof);
        auto& warp = find<StatedEdit>("proofStiffnessWarp");
        QVERIFY(!warp.isVisible());
        find<QToolButton>("proofMeasured").click();
        QVERIFY(warp.isVisible());
        QVERIFY2(warp.text().startsWith("From fabric"), qPrintable(warp.text()));
        const auto type = [&warp](const QString& text) {
            warp.setFocus();
            warp.selectAll();
            QTest::keyClick(&warp, Qt::Key_Delete);
            QTest::keyClicks(&warp, text);
            QTest::keyClick(&warp, Qt::Key_Return);
        };
        const auto stated = [this] { return document().state().proof.settings.stiffness; };
        type("1250");
        QCOMPARE(*stated().warp, 1250.0);
        QVERIFY(warp.font().bold());
        QTest::keyClick(&warp, Qt::Key_Up);
        QCOMPARE(*stated().warp, 1350.0);
        type("0.5");  // less than any cloth
        QCOMPARE(*stated().warp, kMinStretch);
        QVERIFY2(warp.text().startsWith("1 "), qPrintable(warp.text()));
        type("");
        QVERIFY(!stated().warp);
        QVERIFY(!warp.font().bold());
        QTest::keyClick(&warp, Qt::Key_Up);  // from what holds
        QVERIFY(std::abs(*stated().warp - clothStiffness(document().fabric()).warp) < 1e-3);
        auto& bending = find<StatedEdit>("proofStiffnessBending");
        bending.setFocus();
        bending.selectAll();
        QTest::keyClicks(&bending, "0");
        QTest::keyClick(&bending, Qt::Key_Return);
        QCOMPARE(*stated().bending, 0.0);
    }

    void aBodyHasAUnit() {
        openSample("sheet.obj");
        press(ActionId::GoToProof);
        auto& unit = find<QComboBox>("proofBodyUnit");
        QVERIFY(!unit.isVisible());
        ProofPlan plan;
        plan.body = "body.obj";
        plan.bodyUnit = FileUnit::ofMillimetres(12.5);
        document().edit("Plan", &DocumentState::proof, plan);
        QVERIFY(unit.isVisible());
        QVERIFY2(unit.currentText().contains("12.5"), qPrintable(unit.currentText()));
        unit.setFocus();
        QTest::keyClick(&unit, Qt::Key_Home);
        QVERIFY(!document().state().proof.bodyUnit);
        QTest::keyClick(&unit, Qt::Key_Down);
        QVERIFY(document().state().proof.bodyUnit == FileUnit(LengthUnit::Millimetre));
        QCOMPARE(unit.count(), 6);  // what was so long is offered no more
    }

    void aProofOfSettledPiecesIsOfThemOnceTheyAreThere() {
        openSample("sheet.obj");
        prove();
        const auto flat = document().results();
        Derived warm = document().derived();
        auto other = std::make_shared<PieceResult>(*flat.front());
        other->fingerprint ^= 1U;  // other points
        warm.results.front() = other;
        document().show(warm, document().state().settings);
        QVERIFY(!isProved());
        Derived settled = document().derived();
        settled.results.front() = std::make_shared<PieceResult>(*flat.front());
        document().show(settled, document().state().settings);
        QVERIFY(isProved());
    }

    void aBodyElsewhereIsRefused() {
        openSample("sheet.obj");
        auto far = test::makeSheet(200, 160, 8, 6);
        far.V.array() += 1e5;
        test::writeObj(fixture_.path("far.obj").toStdString(), {{"far", far}});
        ProofPlan plan;
        plan.body = fixture_.path("far.obj").toStdString();
        document().edit("Plan", &DocumentState::proof, plan);
        press(ActionId::ProveBySewing);
        QVERIFY(QTest::qWaitFor([this] { return !proof().isRunning(); }, test::kPatience));
        QVERIFY(!document().proof());
    }

    void escapeStopsItAndShowsWhatWasThere() {
        openSample("sheet.obj");
        prove();
        const auto first = document().proof();
        auto& slider = find<QSlider>("sewnSlider");
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_Home);
        QTest::keyClick(&slider, Qt::Key_PageUp);
        const int share = slider.value();
        QVERIFY(share > 0);
        press(ActionId::ProveBySewing);
        QVERIFY(find<QToolButton>("stopProof").isVisible());
        document().showSewing(onItsWay(5));
        QVERIFY(!find<QWidget>("sewnBar").isVisible());
        press(ActionId::Cancel);
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(document().proof() == first);
        QVERIFY(!document().sewing());
        QVERIFY(sewnOf(document()) == first->cloth);
        QVERIFY(find<QWidget>("sewnBar").isVisible());
        QCOMPARE(slider.value(), share);
    }

    void clothOnItsWayIsSeenAndNotYetMeasured() {
        openSample("sheet.obj");
        document().setOverlay(Overlay::Gap);
        QVERIFY(fixture_.waitForResults());
        const QImage designed = fixture_.garmentPicture(), flat = fixture_.patternPicture();
        document().showSewing(onItsWay(20));
        QCOMPARE(fixture_.garmentView().sewnWay(), 1.0);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(fixture_.garmentPicture() != designed);
        QVERIFY(fixture_.patternPicture() == flat);  // in its own colours
        QVERIFY(find<ColourBar>("colourBar").summary().contains("sewing"));
        // On the way to the pattern it is not in the way.
        find<QSlider>("morphSlider").setFocus();
        QTest::keyClick(&find<QSlider>("morphSlider"), Qt::Key_End);
        QCOMPARE(fixture_.garmentView().sewnWay(), 0.0);
    }

    void theWorkLeavesClothOnItsWay() {
        openSample("sheet.obj");
        const auto mailbox = std::make_shared<Mailbox<ShownProof>>();
        std::shared_ptr<const ShownProof> found;
        const auto job = proofJob(document(), {}, mailbox, [&](auto made) { found = made; });
        Progress progress;
        QVERIFY(job->process(progress));
        job->finalize();
        QVERIFY(found && found->proof);
        const auto sewing = mailbox->take();
        QVERIFY(sewing && !sewing->proof && !sewing->cloth->isMeasured);
        QVERIFY(sewing->ground == found->ground);
        QVERIFY(sewing->cloth->scene == document().scene());
        QVERIFY(!mailbox->take());
    }

    void theCheckGoesOnWhileItIsProvedAgain() {
        openSample("sheet.obj");
        prove();
        QVERIFY(waitUntilChecked());
        const auto known = checker().plan().proof;
        QVERIFY(known != nullptr);
        for (const double step : {3.0, 2.0, 1.0}) {
            document().showSewing(onItsWay(step));
            QVERIFY(checker().isUpToDate());
        }
        QVERIFY(checker().plan().proof == known);
    }

    void trianglesAreNoFinerThanCanBeSewn() {
        openSample("sheet.obj");
        press(ActionId::GoToProof);
        auto& edge = find<QAbstractSpinBox>("proofEdge");
        for (int twice = 0; twice < 2; ++twice) {
            edge.setFocus();
            edge.selectAll();
            QTest::keyClicks(&edge, "0.1 mm");
            QTest::keyClick(&edge, Qt::Key_Return);
            QCOMPARE(proof().plan().settings.edge, kMinProofEdge);
            QVERIFY2(!edge.text().contains("0.1"), qPrintable(edge.text()));
        }
    }

    void aClickGoesToThePiece() {
        openSample("sheet.obj");
        prove();
        auto& table = find<QTreeView>("proofTable");
        const QModelIndex row = table.model()->index(0, 0);
        test::click(*table.viewport(), table.visualRect(row).center());
        QCOMPARE(document().selection(),
                 Document::Selection{row.data(ProofModel::PieceRole).toInt()});
        QVERIFY(fixture_.window().views().shownSpot().has_value());
    }

    void theFormSaysHowItIsSewn() {
        openSample("sheet.obj");
        press(ActionId::GoToProof);
        auto& pressure = find<QAbstractSpinBox>("proofPressure");
        pressure.setFocus();
        pressure.selectAll();
        QTest::keyClicks(&pressure, "25");
        QTest::keyClick(&pressure, Qt::Key_Return);
        QCOMPARE(proof().plan().settings.pressure, 25.0);
        find<QAbstractButton>("proofGravity").click();
        QVERIFY(proof().plan().settings.hasGravity);
        find<QAbstractButton>("proofSelfContact").click();
        QVERIFY(proof().plan().settings.touchesItself);
        fixture_.window().garmentActions().fileDialogs().openBody =
            [this](QWidget*, const QString&) { return fixture_.path("tshirt.obj"); };
        emit fixture_.window().findChild<ProofForm*>()->bodyWanted();
        QCOMPARE(proof().plan().body.filename().string(), std::string("tshirt.obj"));
    }

    void theReportIsSaved() {
        openSample("sheet.obj");
        prove();
        const QString file = fixture_.path("tshirt.proof.json");
        fixture_.window().garmentActions().fileDialogs().saveReport =
            [file](QWidget*, const QString&, const QString&) { return file; };
        find<QToolButton>("saveProofButton").click();
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll().toStdString(),
                 writeProof(*document().garment(), *document().proof()->proof));
    }
};

TOILE_WINDOW_TEST(ProofPanelTest)

#include "proof_panel_test.moc"
