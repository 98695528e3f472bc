// SPDX-License-Identifier: GPL-3.0-or-later
// Seam allowances and notches in the panel of lines, in the pattern view and its layers, on the
// sheet, and in garments that are opened.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/document/layout.h"
#include "app/document/line_facts.h"
#include "app/document/mirrored_edits.h"
#include "app/jobs/file_jobs.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/render/scene_renderer.h"
#include "core/layout/free_place.h"
#include "core/project/project_file.h"
#include "core/symmetry/symmetry.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// A cap of two parts that are sewn to each other.
class AllowanceTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    const LineSettings& lines() { return document().state().lines; }
    int steps() { return document().history().index(); }
    void undo() { fixture_.action(ActionId::Undo).trigger(); }
    QCheckBox& box(const char* name) { return fixture_.find<QCheckBox>(name); }
    QComboBox& combo(const char* name) { return fixture_.find<QComboBox>(name); }
    QDoubleSpinBox& field(const char* name) { return fixture_.find<QDoubleSpinBox>(name); }
    const PatternPiece& piece(int k) { return *document().patternPiece(k); }

    void type(const char* name, const QString& text) {
        field(name).setFocus();
        field(name).selectAll();
        QTest::keyClicks(&field(name), text);
        QTest::keyClick(&field(name), Qt::Key_Return);
    }

    void choose(const char* name, Qt::Key key) {
        combo(name).setFocus();
        QTest::keyClick(&combo(name), key);
    }

    bool isDone() {
        return QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience) &&
               fixture_.waitForResults();
    }

    void open(const char* name, NewGarment start = NewGarment::Exact) {
        fixture_.close();
        fixture_.open({1400, 900}, start);
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        fixture_.workspace().setMethod(Method::Curvature);  // the quickest
        QVERIFY(fixture_.openAndWait(fixture_.path(name)));
        QVERIFY(isDone());
    }

    /// Widths beside the sewn seam, on both pieces.
    std::vector<double> seamWidths() {
        std::vector<double> widths;
        for (int k = 0; k < document().pieceCount(); ++k) {
            for (const PatternSegment& segment : piece(k).segments) {
                if (segment.kind == SeamKind::Seam) {
                    widths.push_back(segment.allowance);
                }
            }
        }
        return widths;
    }

    /// Pixels of a colour.
    static int count(const QImage& picture, const QColor& colour) {
        int pixels = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                pixels += picture.pixel(x, y) == colour.rgb() ? 1 : 0;
            }
        }
        return pixels;
    }

    QImage bareSheet() {
        document().setView(&ViewState::grid, false);
        document().setView(&ViewState::rulers, false);
        document().setView(&ViewState::labels, false);
        document().setView(&ViewState::grain, false);
        return fixture_.patternPicture();
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("cap.obj").toStdString(), test::sewnCapParts());
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj",
                            fixture_.path("tshirt.obj")));
    }

    void anEditUploadsNoMeshAndBuildsNoTree() {
        open("tshirt.obj", NewGarment::Pattern);
        const auto before = document().scene();
        QVERIFY(!before->patternLines.cutting.empty());
        const auto uploads = [this] {
            return std::pair(fixture_.garmentView().renderer().meshUploads(),
                             fixture_.patternView().renderer().meshUploads());
        };
        (void)fixture_.garmentPicture();
        (void)fixture_.patternPicture();
        const auto sent = uploads();
        LineSettings wider = lines();
        wider.allowance = AllowanceWidths{17, 45};
        document().setLines(wider, "Wider");
        QVERIFY(isDone());
        QVERIFY(fixture_.waitUntilIdle());
        (void)fixture_.garmentPicture();
        (void)fixture_.patternPicture();
        const auto after = document().scene();
        QVERIFY(after != before);
        QCOMPARE(after->cloth, before->cloth);  // which holds the trees
        QCOMPARE(uploads(), sent);
        QVERIFY(after->edgeBoxes.front().sizes().x() > before->edgeBoxes.front().sizes().x());
    }

    void init() {
        open("cap.obj");
        fixture_.action(ActionId::GoToLines).trigger();
    }

    void cleanup() { fixture_.close(); }

    void sizeAndDateStandOnTheLabels() {
        auto& size = fixture_.find<QLineEdit>("labelSize");
        auto& date = fixture_.find<QLineEdit>("labelDate");
        size.setFocus();
        QTest::keyClicks(&size, " 38 ");
        QTest::keyClick(&size, Qt::Key_Return);
        QCOMPARE(lines().label.size, std::string("38"));
        QCOMPARE(size.text(), QString("38"));
        QCOMPARE(steps(), 1);
        date.setFocus();  // the size that is only left again says nothing
        QTest::keyClicks(&date, "spring");
        QTest::keyClick(&date, Qt::Key_Return);
        QCOMPARE(steps(), 2);
        QVERIFY(isDone());
        QVERIFY(document().derived().pattern->label == (LabelTexts{"38", "spring"}));
        QTest::mouseClick(&fixture_.find<QToolButton>("labelToday"), Qt::LeftButton);
        QVERIFY(lines().label.date != "spring" && !lines().label.date.empty());
        QCOMPARE(date.text(), QString::fromStdString(lines().label.date));
        undo();
        QCOMPARE(date.text(), QString("spring"));
        undo();
        undo();
        QVERIFY(lines() == LineSettings{} && size.text().isEmpty());
    }

    void aHalfTypedTextDoesNotGoIntoTheNextGarment() {
        auto& size = fixture_.find<QLineEdit>("labelSize");
        size.setFocus();
        QTest::keyClicks(&size, "38");
        QVERIFY(fixture_.openAndWait(fixture_.path("tshirt.obj")));
        QVERIFY(size.text().isEmpty());
        QTest::keyClick(&size, Qt::Key_Return);
        QVERIFY(lines().label == LabelTexts{});
        QCOMPARE(steps(), 0);
    }

    void anAllowanceIsOneTickAndOneUndo() {
        QVERIFY(!document().derived().pattern->hasAllowance);
        box("allowance").setFocus();
        QTest::keyClick(&box("allowance"), Qt::Key_Space);
        QVERIFY(lines().allowance == AllowanceWidths{});
        QVERIFY(isDone());
        for (int k = 0; k < 2; ++k) {
            QVERIFY(piece(k).cuttingLine.rows() > 0);
        }
        type("allowanceSeam", "12");
        type("allowanceHem", "25");
        QVERIFY(lines().allowance == (AllowanceWidths{12, 25}));
        QCOMPARE(steps(), 3);
        type("allowanceHem", "501");  // more than can be
        QCOMPARE(lines().allowance->hem, 25.0);
        undo();
        undo();
        QCOMPARE(field("allowanceSeam").value(), AllowanceWidths{}.seam);
        undo();
        QVERIFY(lines() == LineSettings{} && !box("allowance").isChecked());
        // A width that is typed turns allowances on.
        type("allowanceSeam", "8");
        QCOMPARE(lines().allowance->seam, 8.0);
        QVERIFY(box("allowance").isChecked());
    }

    void notchesComeAndGoWithTheirFormAndKeepWhatWasPlaced() {
        box("notches").setFocus();
        QTest::keyClick(&box("notches"), Qt::Key_Space);
        QVERIFY(lines().notches == NotchRules{});
        QVERIFY(isDone());
        QVERIFY(!piece(0).notches.empty());
        choose("notchesForm", Qt::Key_End);
        type("notchesDepth", "7");
        QCOMPARE(lines().notches->form, NotchForm::Castle);
        QCOMPARE(lines().notches->depth, 7.0);
        LineSettings placed = lines();
        placed.notches->notches.push_back(
            {.line = document().garment()->seams.seams[0].place.left.line, .at = 0.3});
        document().setLines(placed, "Notch");
        box("notches").click();
        QVERIFY(!lines().notches);
        box("notches").click();
        QVERIFY(lines().notches == placed.notches);
    }

    void aWidthOfASegmentHoldsOnBothSidesOrOnOne() {
        QVERIFY(!field("segmentAllowance").isEnabled());
        document().setSeam(0);
        QCOMPARE(field("segmentAllowance").value(), AllowanceWidths{}.seam);
        QVERIFY(!field("segmentAllowance").font().bold());
        type("segmentAllowance", "17");
        QCOMPARE(steps(), 1);
        QVERIFY(isDone());
        QVERIFY(seamWidths() == (std::vector{17.0, 17.0}));
        QVERIFY(lines().allowance && field("segmentAllowance").font().bold());
        box("segmentBothSides").click();
        type("segmentAllowance", "5");
        QVERIFY(isDone());
        const auto widths = seamWidths();
        QVERIFY(std::ranges::count(widths, 5.0) == 1 && std::ranges::count(widths, 17.0) == 1);
        box("segmentBothSides").click();
        QTest::mouseClick(&fixture_.find<QToolButton>("segmentAllowanceReset"), Qt::LeftButton);
        QVERIFY(isDone());
        QVERIFY(seamWidths() == (std::vector{10.0, 10.0}));
        QVERIFY(lines().segments.empty());
        QCOMPARE(steps(), 3);
    }

    void aCornerIsChosenByItsName() {
        document().setSeam(0);
        QCOMPARE(combo("segmentCorner").currentIndex(), 0);
        choose("segmentCorner", Qt::Key_Down);
        QVERIFY(lines().segments.at(0).corner == CornerRule::Mitre);
        choose("segmentCorner", Qt::Key_End);
        QVERIFY(lines().segments.at(0).corner == CornerRule::Stepped);
        QVERIFY(isDone());
        choose("segmentCorner", Qt::Key_Home);
        QVERIFY(lines().segments.empty());
        undo();
        QCOMPARE(combo("segmentCorner").currentIndex(), combo("segmentCorner").count() - 1);
    }

    void aWidthIsSaidOfMirroredSegmentsToo() {
        open("tshirt.obj", NewGarment::Pattern);
        fixture_.action(ActionId::GoToLines).trigger();
        const Symmetry* symmetry = document().derived().symmetry.get();
        QVERIFY(symmetry);
        const auto& counterpart = symmetry->pieces.counterpart;
        int sleeve = 0;
        while (counterpart[std::size_t(sleeve)] < 0 || counterpart[std::size_t(sleeve)] == sleeve) {
            ++sleeve;
        }
        const auto& seams = document().garment()->seams.seams;
        const auto sewn = std::ranges::find_if(seams, [sleeve](const Seam& seam) {
            return seam.kind == SeamKind::Seam && seam.left.piece != seam.right.piece &&
                   (seam.left.piece == sleeve || seam.right.piece == sleeve);
        });
        QVERIFY(sewn != seams.end());
        document().setSeam(static_cast<int>(sewn - seams.begin()));
        type("segmentAllowance", "14");
        QVERIFY(isDone());
        const auto with = [this](int k) {
            return std::ranges::count(piece(k).segments, 14.0, &PatternSegment::allowance);
        };
        QVERIFY(with(sleeve) >= 1);
        QCOMPARE(with(counterpart[std::size_t(sleeve)]), with(sleeve));
        QCOMPARE(steps(), 1);
        setMirrorsEdits(document(), false);
        type("segmentAllowance", "16");
        QVERIFY(isDone());
        QCOMPARE(with(sleeve) + with(counterpart[std::size_t(sleeve)]), std::ptrdiff_t(1));
    }

    void theCuttingLineAndNotchesAreDrawnAsLayers() {
        QVERIFY(!fixture_.action(ActionId::CuttingLine).isEnabled());
        QVERIFY(!fixture_.action(ActionId::Notches).isEnabled());
        LineSettings both = lines();
        both.allowance = AllowanceWidths{};
        document().setLines(both, "Allowance");
        QVERIFY(isDone());
        const QColor colour = renderStyle(fixture_.patternView().palette()).cuttingLine;
        fixture_.patternView().frameAll();
        const QImage without = bareSheet();
        QVERIFY(count(without, colour) > 500);
        // The outermost line: all of it is within the view.
        both.notches = NotchRules{};
        document().setLines(both, "Notches");
        QVERIFY(isDone());
        const QImage all = fixture_.patternPicture();
        QVERIFY(all != without);
        fixture_.action(ActionId::Notches).trigger();
        QVERIFY(!document().view().notches);
        QVERIFY(fixture_.patternPicture() == without);
        fixture_.action(ActionId::CuttingLine).trigger();
        QVERIFY(count(fixture_.patternPicture(), colour) < 20);
        fixture_.action(ActionId::CuttingLine).trigger();
        fixture_.action(ActionId::Notches).trigger();
        QVERIFY(fixture_.patternPicture() == all);
    }

    void grainAndLabelsAreLayers() {
        for (const ActionId id : {ActionId::GrainArrows, ActionId::Labels}) {
            const QImage with = fixture_.patternPicture();
            QVERIFY(fixture_.action(id).isChecked());
            fixture_.action(id).trigger();
            QVERIFY(fixture_.patternPicture() != with);
            fixture_.action(id).trigger();
            QVERIFY(fixture_.patternPicture() == with);
        }
    }

    void aProjectKeepsLayersAndWhatWasSaid() {
        document().setSeam(0);
        type("segmentAllowance", "17");
        box("notches").click();
        QVERIFY(isDone());
        fixture_.action(ActionId::CuttingLine).trigger();
        fixture_.action(ActionId::Labels).trigger();
        const LineSettings said = lines();
        const ViewState view = document().view();
        const QString file = fixture_.path("allowance.toile");
        QVERIFY(writeProject(file.toStdString(), projectOf(document().state(), document().derived(),
                                                           document().view())));
        fixture_.close();
        fixture_.open({1400, 900}, NewGarment::Pattern);  // a project says itself what it is
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(lines() == said);
        QVERIFY(document().view() == view);
    }

    void aGarmentStartsAsThePreferencesSay() {
        QVERIFY(lines() == LineSettings{});
        open("cap.obj", NewGarment::Pattern);
        QVERIFY(lines() == withPattern({}));
        QCOMPARE(steps(), 0);
        QVERIFY(document().derived().pattern->hasAllowance && !piece(0).notches.empty());
    }

    void piecesMakeRoomForTheirAllowances() {
        open("tshirt.obj");
        const auto onSheet = [this] {
            std::vector<Points2> outlines;
            for (int k = 0; k < document().pieceCount(); ++k) {
                const Placement placement = placementOf(document(), k);
                outlines.push_back(
                    (cutOutline(document(), k) * placement.linear().transpose()).rowwise() +
                    placement.offset.transpose());
            }
            return outlines;
        };
        const auto before = document().settings();
        LineSettings wide = lines();
        wide.allowance = AllowanceWidths{40, 60};
        document().setLines(wide, "Allowance");
        QVERIFY(isDone());
        QVERIFY(overlappingOutlines(onSheet()).empty());
        undo();
        QVERIFY(isDone());
        QVERIFY(document().settings() == before);
        // What somebody has placed stays.
        PiecePlacements placements;
        for (int k = 0; k < document().pieceCount(); ++k) {
            placements[k] = movedBy(placementOf(document(), k), {1, 0});
        }
        place(document(), "Place", placements);
        document().setLines(wide, "Allowance");
        QVERIFY(isDone());
        for (const auto& [k, placement] : placements) {
            QVERIFY(placementOf(document(), k) == placement);
        }
        QVERIFY(!overlappingOutlines(onSheet()).empty());
    }

    void piecesOfANewPatternLieClearOfEachOther() {
        open("tshirt.obj", NewGarment::Pattern);
        for (int pass = 0; pass < 2; ++pass) {
            for (int a = 0; a < document().pieceCount(); ++a) {
                QVERIFY(boxOnSheet(document(), a)
                            .contains(outlineBox(flatOutline(document(), a),
                                                 placementOf(document(), a))));
                for (int b = 0; b < a; ++b) {
                    QVERIFY(!boxOnSheet(document(), a).intersects(boxOnSheet(document(), b)));
                }
            }
            fixture_.action(ActionId::LayOutAgain).trigger();
        }
        const Eigen::AlignedBox2d sheet =
            sheetBox(*document().scene(), placesOf(document().settings()));
        QVERIFY(sheet.contains(boxOnSheet(document(), allFlat(document()))));
    }
};

TOILE_WINDOW_TEST(AllowanceTest)
#include "allowance_test.moc"
