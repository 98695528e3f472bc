// SPDX-License-Identifier: GPL-3.0-or-later
// The fabric panel: real key and mouse events, what they leave in the document and its history, and
// that the overlays follow without anything being flattened again.
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QTreeView>
#include <new>

#include "app/document/layout.h"
#include "app/jobs/file_jobs.h"
#include "app/panels/fabric_panel.h"
#include "app/panels/pieces_model.h"
#include "app/render/overlay_figures.h"
#include "app/render/overlay_values.h"
#include "app/text/fabric_name.h"
#include "app/views/colour_bar.h"
#include "app/views/overlay_watcher.h"
#include "app/widgets/banner.h"
#include "app/widgets/number_edits.h"
#include "core/check/piece_check.h"
#include "core/project/project_file.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class FabricTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    int steps() { return document().history().index(); }
    QString lastStep() { return document().history().undoText(); }
    PercentEdit& field(const char* name) { return fixture_.find<PercentEdit>(name); }
    QComboBox& preset() { return fixture_.find<QComboBox>("fabricPreset"); }
    QComboBox& material() { return fixture_.find<QComboBox>("pieceMaterial"); }
    const std::string& materialOf(std::size_t piece) {
        return document().settings()[piece].material;
    }
    void typeMaterial(const QString& name) {
        QLineEdit& edit = *material().lineEdit();
        edit.setFocus();
        edit.selectAll();
        QTest::keyClick(&edit, Qt::Key_Delete);
        QTest::keyClicks(&edit, name);
        QTest::keyClick(&edit, Qt::Key_Return);
    }
    bool isMaterialColumnShown() {
        return !fixture_.find<QTreeView>("pieceTable").isColumnHidden(PiecesModel::MaterialName);
    }
    QString label(const char* name) { return fixture_.find<QLabel>(name).text(); }

    void type(const char* name, const QString& text) {
        field(name).setFocus();
        field(name).selectAll();
        QTest::keyClicks(&field(name), text);
        QTest::keyClick(&field(name), Qt::Key_Return);
    }

    void undo() { fixture_.action(ActionId::Undo).trigger(); }

    FabricQuestion question() {
        return {document().scene(),
                placesOf(document().settings(), {}, document().state().materials),
                document().fabric()};
    }

private slots:
    void initTestCase() {
        test::writeObj(
            fixture_.path("two.obj").toStdString(),
            {{"sheet", test::makeSheet(120, 80, 6, 4, {-300, 0, 0})}, {"cap", test::makeCap(0)}});
        Project project;
        project.files = {{fixture_.path("two.obj").toStdString()}};
        project.fabric = *fabricPreset("woven");
        QVERIFY(writeProject(fixture_.path("two.toile").toStdString(), project));
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("two.toile")));
    }

    void cleanup() { fixture_.close(); }

    void atFirstNoFabricIsStatedAndNothingIsBeyondIt() {
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("two.obj")));
        QVERIFY(!hasLimits(document().fabric()));
        fixture_.action(ActionId::GoToFabric).trigger();
        QCOMPARE(preset().currentText(), QString("Not set"));
        QVERIFY(fixture_.find<QLabel>("fabricUnstated").isVisible());
        QVERIFY(!field("fabricWarpMost").isVisible());
        QCOMPARE(fabricFit(question())->any, 0.0);
        fixture_.action(overlayAction(Overlay::Weft)).trigger();
        auto& bar = fixture_.find<ColourBar>("colourBar");
        QTRY_VERIFY_WITH_TIMEOUT(fixture_.window().views().isUpToDate(), test::kPatience);
        QVERIFY2(!bar.summary().contains("limits"), qPrintable(bar.summary()));
        QTest::keyClick(&preset(), Qt::Key_Down);
        QVERIFY(document().fabric() == *fabricPreset("woven"));
        QVERIFY(!fixture_.find<QLabel>("fabricUnstated").isVisible());
        QVERIFY(field("fabricWarpMost").isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(bar.summary().contains("limits"), test::kPatience);
        undo();
        QVERIFY(!field("fabricWarpMost").isVisible());
        QTest::keyClick(&preset(), Qt::Key_End);  // Custom begins with a woven's limits
        QCOMPARE(document().fabric().id, std::string("custom"));
        QVERIFY(document().fabric().bias == fabricPreset("woven")->bias);
    }

    void aPresetIsOneStepAndFlattensNothing() {
        const PieceResults results = document().results();
        const auto scene = document().scene();
        fixture_.action(ActionId::GoToFabric).trigger();
        QVERIFY(preset().hasFocus());
        QCOMPARE(preset().currentText(), QString("Woven"));
        for (int down = 0; down < 3; ++down) {
            QTest::keyClick(&preset(), Qt::Key_Down);
        }
        QCOMPARE(document().fabric().id, std::string("jersey"));
        QVERIFY(document().fabric() == *fabricPreset("jersey"));
        QCOMPARE(lastStep(), QString("Set fabric: jersey"));
        QCOMPARE(field("fabricWeftMost").value(), 35.0);
        QCOMPARE(field("fabricWeftMost").text(), QString("+35 %"));
        QCOMPARE(steps(), 3);
        QVERIFY(!fixture_.workspace().jobs().isBusy());
        QVERIFY(document().results() == results);
        QVERIFY(document().scene() == scene);
        while (steps() > 0) {
            undo();
        }
        QVERIFY(document().fabric() == *fabricPreset("woven"));
        QCOMPARE(preset().currentText(), QString("Woven"));
        QCOMPARE(field("fabricWeftMost").value(), 3.0);
    }

    void theClothThatThePiecesTakeIsThatOfTheirArrangement() {
        const auto needed = [this] { return label("fabricNeed"); };
        const QString before = needed();
        QVERIFY2(before.contains("at this width"), qPrintable(before));
        Placement far = placementOf(document(), 0);
        far.offset.y() += 1000;
        place(document(), "Move", {{0, far}});
        QVERIFY(needed() != before);
        undo();
        QCOMPARE(needed(), before);
    }

    void aClothThatIsTooNarrowIsSaid() {
        auto& width = fixture_.find<LengthEdit>("fabricWidth");
        QCOMPARE(width.value(), fabricPreset("woven")->width);
        width.selectAll();
        QTest::keyClicks(&width, "5 cm");
        QTest::keyClick(&width, Qt::Key_Return);
        QCOMPARE(document().fabric().width, 50.0);
        QVERIFY(isRuleOfThumb(document().fabric()));  // its limits are as they were
        QVERIFY(label("fabricNeed").contains("wider than the fabric"));
        QTest::keyClick(&preset(), Qt::Key_Down);   // denim
        QCOMPARE(document().fabric().width, 50.0);  // typed, so it stays
        undo();
        undo();
        QCOMPARE(width.value(), fabricPreset("woven")->width);
        QTest::keyClick(&preset(), Qt::Key_Down);  // denim
        QCOMPARE(document().fabric().width, fabricPreset("denim")->width);
        QVERIFY(!label("fabricNeed").contains("wider than the fabric"));
    }

    void typedLimitsAreACustomFabric() {
        type("fabricWarpMost", "12,5 %");
        QCOMPARE(document().fabric().id, std::string("custom"));
        QCOMPARE(document().fabric().warp.most, 0.125);
        QCOMPARE(document().fabric().warp.least, -0.01);
        QVERIFY(document().fabric().bias == fabricPreset("woven")->bias);
        QCOMPARE(preset().currentText(), QString("Custom"));
        QCOMPARE(lastStep(), QString("Set fabric limits"));
        type("fabricWarpMost", "13");
        type("fabricWarpMost", "13");
        QTest::keyClick(&field("fabricWarpMost"), Qt::Key_Up);
        QCOMPARE(document().fabric().warp.most, 0.135);
        QCOMPARE(steps(), 1);  // one field, one after the other
        type("fabricBiasLeast", "-7");
        QCOMPARE(document().fabric().bias.least, -0.07);
        QCOMPARE(steps(), 2);
        undo();
        undo();
        QCOMPARE(steps(), 0);
        QVERIFY(document().fabric() == *fabricPreset("woven"));
        QCOMPARE(field("fabricWarpMost").text(), QString("+2 %"));
    }

    void limitsStayOnTheirSideOfNothing() {
        for (const auto& [name, text] :
             std::initializer_list<std::pair<const char*, QString>>{{"fabricWarpLeast", "5"},
                                                                    {"fabricWarpLeast", "-50.5"},
                                                                    {"fabricWeftMost", "-1"},
                                                                    {"fabricWeftMost", "201"},
                                                                    {"fabricBiasMost", "much"},
                                                                    {"fabricBiasMost", "1e999"},
                                                                    {"fabricBiasMost", ""}}) {
            type(name, text);
            QVERIFY2(document().fabric() == *fabricPreset("woven"), qPrintable(text));
        }
        QCOMPARE(steps(), 0);
        type("fabricWarpLeast", "0");
        QCOMPARE(document().fabric().warp.least, 0.0);
        type("fabricWeftMost", "200");
        QCOMPARE(document().fabric().weft.most, 2.0);
    }

    void theColourBarEndsAtTheNewLimits() {
        fixture_.action(overlayAction(Overlay::Weft)).trigger();
        auto& bar = fixture_.find<ColourBar>("colourBar");
        QTRY_VERIFY_WITH_TIMEOUT(bar.summary().contains("+3 %"), test::kPatience);
        const QString woven = bar.summary();
        type("fabricWeftMost", "1.5");
        QTRY_VERIFY_WITH_TIMEOUT(bar.summary().contains("+1.5 %"), test::kPatience);
        QVERIFY(bar.summary() != woven);
        undo();
        QTRY_COMPARE_WITH_TIMEOUT(bar.summary(), woven, test::kPatience);
    }

    void thePictureIsHatchedAnew() {
        if (!fixture_.window().views().patternView()) {
            QSKIP("no OpenGL here");
        }
        fixture_.action(overlayAction(Overlay::Weft)).trigger();
        const QImage woven = fixture_.patternPicture();
        type("fabricWeftMost", "60");
        type("fabricWeftLeast", "-40");
        QVERIFY(fixture_.patternPicture() != woven);
    }

    void whatIsBeyondAgreesWithTheOverlays() {
        for (const Fabric& fabric : fabricPresets().subspan(1)) {
            DocumentState next = document().state();
            next.fabric = fabric;
            document().edit("Test", std::move(next));
            const auto fit = fabricFit(question());
            QVERIFY(fit);
            const std::pair<Overlay, double> shares[] = {
                {Overlay::Warp, fit->warp}, {Overlay::Weft, fit->weft}, {Overlay::Bias, fit->bias}};
            for (const auto& [overlay, share] : shares) {
                const OverlayFigures figures = overlayFigures(
                    {document().scene(), placesOf(document().settings()), fabric, overlay});
                QVERIFY(std::abs(figures.histogram->beyond() - share) < 1e-12);
                QVERIFY(share <= fit->any + 1e-12);
            }
            QVERIFY(fit->any <= fit->warp + fit->weft + fit->bias + 1e-12);
        }
    }

    void smoothingChangesNoFigure() {
        auto& bar = fixture_.find<ColourBar>("colourBar");
        const auto figures = [&] {
            return QStringList{bar.summary(),
                               label("fabricBeyondWarp"),
                               label("fabricBeyondWeft"),
                               label("fabricBeyondBias"),
                               label("fabricBeyondAny"),
                               label("fabricWorst")};
        };
        for (int overlay = 0; overlay < kOverlayCount; ++overlay) {
            document().setOverlay(static_cast<Overlay>(overlay));
            document().setView(&ViewState::valuesPerTriangle, false);
            QTRY_VERIFY_WITH_TIMEOUT(fixture_.window().views().isUpToDate(), test::kPatience);
            const QStringList smooth = figures();
            document().setView(&ViewState::valuesPerTriangle, true);
            QTRY_VERIFY_WITH_TIMEOUT(fixture_.window().views().isUpToDate(), test::kPatience);
            QCOMPARE(figures(), smooth);
        }
    }

    void readyToCutCountsWhatThePanelCounts() {
        const Scene& scene = *document().scene();
        double all = 0, warp = 0, weft = 0, bias = 0;
        for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
            const StrainExcesses found = strainExcesses(
                document().garment()->pieces[i]->mesh, document().results()[i]->flat->Q,
                document().fabric(), grainOf(document().settings()[i]));
            double area = 0;
            const TriangleRun& run = scene.pieces[i].patternRun;
            for (std::uint32_t face = run.first; face < run.first + run.count; ++face) {
                area += double(scene.faces[face].flatArea);
            }
            all += area;
            warp += area * found.warp.share;
            weft += area * found.weft.share;
            bias += area * found.bias.share;
        }
        const auto fit = fabricFit(question());
        QVERIFY(fit && fit->any > 0);
        QVERIFY(std::abs(warp / all - fit->warp) < 1e-5);
        QVERIFY(std::abs(weft / all - fit->weft) < 1e-5);
        QVERIFY(std::abs(bias / all - fit->bias) < 1e-5);
    }

    void theWorstPieceIsNamedAndShown() {
        type("fabricWarpMost", "0.5");
        type("fabricWarpLeast", "-0.5");
        const auto fit = fabricFit(question());
        QVERIFY(fit && fit->worst);
        QCOMPARE(fit->worst->piece, 1);  // a flat sheet is not strained
        QVERIFY(fit->worst->share > 0 && fit->worst->share <= 1);
        QVERIFY(label("fabricWorst").contains(">cap</a>"));
        QVERIFY(label("fabricBeyondWarp") != QString("0 %"));
        auto& worst = fixture_.find<QLabel>("fabricWorst");
        worst.setFocus();
        QTest::keyClick(&worst, Qt::Key_Tab);  // to its link
        emit worst.linkActivated("piece");
        QCOMPARE(document().selection(), Document::Selection{1});
        type("fabricWarpMost", "200");
        type("fabricWarpLeast", "-50");
        type("fabricWeftMost", "200");
        type("fabricWeftLeast", "-50");
        type("fabricBiasMost", "200");
        type("fabricBiasLeast", "-50");
        QCOMPARE(label("fabricBeyondAny"), QString("0 %"));
        QCOMPARE(label("fabricWorst"), QString("All strain is within the fabric's limits."));
    }

    void largeGarmentsAreLookedAtElsewhere() {
        test::writeObj(fixture_.path("large.obj").toStdString(),
                       {{"sheet", test::makeSheet(400, 300, 100, 80)}});
        QVERIFY(fixture_.openAndWait(fixture_.path("large.obj")));
        auto* panel = fixture_.window().findChild<FabricPanel*>();
        QTRY_VERIFY_WITH_TIMEOUT(panel->isUpToDate(), test::kPatience);
        QVERIFY(panel->fit());
        DocumentState next = document().state();
        next.fabric = *fabricPreset("denim");
        document().edit("Test", std::move(next));
        QVERIFY(!panel->isUpToDate());
        QTRY_VERIFY_WITH_TIMEOUT(panel->isUpToDate(), test::kPatience);
        QVERIFY(*panel->fit() == *fabricFit(question()));
    }

    void lackOfMemoryIsSaidWhereTheFiguresWouldBe() {
        test::writeObj(fixture_.path("large.obj").toStdString(),
                       {{"sheet", test::makeSheet(400, 300, 100, 80)}});
        QVERIFY(fixture_.openAndWait(fixture_.path("large.obj")));
        FabricPanel panel(
            document(), nullptr,
            [](const FabricQuestion&) -> std::optional<FabricFit> { throw std::bad_alloc(); });
        QVERIFY(!panel.isUpToDate());
        QTRY_VERIFY_WITH_TIMEOUT(panel.isUpToDate(), test::kPatience);
        QVERIFY(!panel.fit());
        const QString said = panel.findChild<QLabel*>("fabricWorst")->text();
        QVERIFY2(said.contains("not enough memory"), qPrintable(said));
    }

    void theWindowSaysWhatTheOverlayCouldNotWorkOut() {
        QVERIFY(fixture_.window().banner().isHidden());
        emit fixture_.window().findChild<OverlayWatcher*>()->failed("there is not enough memory.");
        QVERIFY(!fixture_.window().banner().isHidden());
        QVERIFY(fixture_.window().banner().sentence().contains("memory"));
    }

    void typedLimitsAreSavedAndRead() {
        type("fabricBiasMost", "17.25");
        const Fabric typed = document().fabric();
        const auto file = fixture_.path("typed.toile");
        QVERIFY(writeProject(file.toStdString(), projectOf(document().state(), document().derived(),
                                                           document().view())));
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(document().fabric() == typed);
        QCOMPARE(field("fabricBiasMost").text(), QString("+17.25 %"));
        QCOMPARE(preset().currentText(), QString("Custom"));
        QCOMPARE(steps(), 0);
    }

    void aMaterialHasAFabricOfItsOwn() {
        auto& of = fixture_.find<QComboBox>("fabricMaterial");
        QVERIFY(of.isHidden());
        QVERIFY(!isMaterialColumnShown());
        const auto woven = fabricFit(question());
        QVERIFY(woven && woven->any > 0);
        document().setSelection({1});  // the cap, which is all that is strained
        typeMaterial("Lining");
        QCOMPARE(materialOf(1), std::string("Lining"));
        QCOMPARE(materialOf(0), std::string());
        QCOMPARE(lastStep(), QString("Set material of cap to Lining"));
        QCOMPARE(steps(), 1);
        QVERIFY(isMaterialColumnShown());
        QVERIFY(*fabricFit(question()) == *woven);  // it begins with the garment's fabric

        QVERIFY(!of.isHidden());
        of.setFocus();
        const QString ofGarment = label("fabricNeed");
        QTest::keyClick(&of, Qt::Key_Down);
        const QString own = label("fabricNeed");
        QCOMPARE(of.currentText(), QString("Lining"));
        QVERIFY(own.contains("at this width") && own != ofGarment);
        QCOMPARE(preset().currentText(), QString("Woven"));
        preset().setFocus();
        QTest::keyClick(&preset(), Qt::Key_End);   // Custom: the limits stay
        QTest::keyClick(&preset(), Qt::Key_Home);  // not stated
        QCOMPARE(fabricFit(question())->any, 0.0);
        QTest::keyClick(&preset(), Qt::Key_Down);
        for (const char* least : {"fabricWarpLeast", "fabricWeftLeast", "fabricBiasLeast"}) {
            type(least, "-50");
        }
        for (const char* most : {"fabricWarpMost", "fabricWeftMost", "fabricBiasMost"}) {
            type(most, "200");
        }
        QVERIFY(document().fabric() == *fabricPreset("woven"));
        QCOMPARE(document().fabricOf(1).bias.most, 2.0);
        QVERIFY(document().fabricOf(0) == *fabricPreset("woven"));
        QCOMPARE(fabricFit(question())->any, 0.0);
        QCOMPARE(label("fabricBeyondAny"), QString("0 %"));
        const OverlayFigures figures = overlayFigures(
            {document().scene(), question().places, document().fabric(), Overlay::Weft});
        QCOMPARE(figures.histogram->beyond(), 0.0);

        const auto file = fixture_.path("lined.toile");
        QVERIFY(writeProject(file.toStdString(), projectOf(document().state(), document().derived(),
                                                           document().view())));
        const MaterialList materials = document().state().materials;
        while (steps() > 1) {
            undo();
        }
        QVERIFY(*fabricFit(question()) == *woven);
        undo();
        QCOMPARE(materialOf(1), std::string());
        QVERIFY(document().state().materials.empty());
        QVERIFY(of.isHidden());
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(file));
        QCOMPARE(materialOf(1), std::string("Lining"));
        QVERIFY(document().state().materials == materials);
        QCOMPARE(fabricFit(question())->any, 0.0);
    }

    void aPieceIsHatchedByItsOwnLimits() {
        if (!fixture_.window().views().patternView()) {
            QSKIP("no OpenGL here");
        }
        document().setView(&ViewState::worstSpots, false);
        fixture_.action(overlayAction(Overlay::Weft)).trigger();
        document().setSelection({1});
        typeMaterial("Lining");
        document().setSelection({});
        const QImage asTheGarment = fixture_.patternPicture();
        DocumentState next = document().state();
        next.materials.front().fabric.weft = {-0.5, 2};
        document().edit("Test", std::move(next));
        const QImage unhatched = fixture_.patternPicture();
        QVERIFY(unhatched != asTheGarment);
        undo();
        QVERIFY(fixture_.patternPicture() == asTheGarment);
    }

    void aMaterialIsSetOnAllThatIsSelected() {
        document().setSelection({0, 1});
        QVERIFY(material().findText("Interfacing") >= 0);
        typeMaterial("  stiff   canvas ");
        QCOMPARE(materialOf(0), std::string("stiff canvas"));
        QCOMPARE(materialOf(1), std::string("stiff canvas"));
        QCOMPARE(steps(), 1);
        typeMaterial("stiff canvas");
        QCOMPARE(steps(), 1);
        document().setSelection({0});
        typeMaterial("");
        QCOMPARE(lastStep(), QString("Set material of sheet to garment's fabric"));
        QCOMPARE(document().state().materials.size(), std::size_t(1));
        document().setSelection({0, 1});
        QCOMPARE(material().currentText(), QString());  // they differ
        QCOMPARE(material().lineEdit()->placeholderText(), QString("various"));
        const int before = steps();
        QTest::keyClick(material().lineEdit(), Qt::Key_Return);
        QCOMPARE(steps(), before);
        document().setSelection({1});
        typeMaterial("");
        QVERIFY(document().state().materials.empty());  // nothing was said of it, and none has it
        undo();
        QCOMPARE(materialOf(1), std::string("stiff canvas"));
    }

    void theManualListsThePresets() {
        QFile page(TOILE_SOURCE_DIR "/docs/overlays.md");
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(page.readAll());
        PercentEdit edit;
        const auto span = [&edit](const StrainLimits& limits) -> QString {
            return QString("%1 to %2")
                .arg(edit.textFromValue(100 * limits.least).remove(" %"),
                     edit.textFromValue(100 * limits.most));
        };
        for (const Fabric& fabric : fabricPresets().subspan(1)) {
            QString name = fabricName(fabric);
            name[0] = name[0].toUpper();
            const QString row =
                QString("| %1 | %2 | %3 | %4 |")
                    .arg(name, span(fabric.warp), span(fabric.weft), span(fabric.bias));
            QVERIFY2(text.contains(row), qPrintable(row));
        }
    }

    void withoutAGarmentThereIsAHint() {
        Document none;
        FabricPanel panel(none);
        auto* pages = panel.findChild<QStackedWidget*>();
        QCOMPARE(pages->currentWidget()->objectName(), QString("fabricEmpty"));
        QVERIFY(!static_cast<QLabel*>(pages->currentWidget())->text().isEmpty());
    }
};

TOILE_WINDOW_TEST(FabricTest)
#include "fabric_test.moc"
