// SPDX-License-Identifier: GPL-3.0-or-later
// Darts in the panel of lines, and darts that become seams: real keys and clicks, and what they
// leave in the document and in the pattern.
#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/document/line_edits.h"
#include "app/jobs/file_jobs.h"
#include "app/widgets/number_edits.h"
#include "core/pattern/darts.h"
#include "core/pattern/pattern.h"
#include "core/project/project_file.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

/// A sheet with a dart of 62 mm from its lower edge.
class DartFormTest : public test::ToolBench {
    Q_OBJECT

private:
    const LineSettings& lines() { return document().state().lines; }
    void undo() { fixture_.action(ActionId::Undo).trigger(); }
    QString label(const char* name) { return fixture_.find<QLabel>(name).text(); }
    bool isShown(const char* name) { return fixture_.find<QWidget>(name).isVisible(); }

    QDoubleSpinBox& field(const char* name) { return fixture_.find<QDoubleSpinBox>(name); }

    void type(const char* name, const QString& text) {
        field(name).setFocus();
        field(name).selectAll();
        QTest::keyClicks(&field(name), text);
        QTest::keyClick(&field(name), Qt::Key_Return);
    }

    bool isFlatAgain() {
        return QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience) &&
               fixture_.waitForResults();
    }

    int dart() {
        const auto& seams = document().garment()->seams.seams;
        const auto found = std::ranges::find(seams, SeamKind::Dart, &Seam::kind);
        return found == seams.end() ? -1 : static_cast<int>(found - seams.begin());
    }

    PieceDart drawn() {
        const Pattern pattern =
            makePattern(*document().garment(), document().results(), document().state().lines);
        const std::vector<PieceDart> darts = findDarts(pattern.pieces[0]);
        return darts.size() == 1 ? darts.front() : PieceDart{};
    }

    void openDart() {
        openSheets();
        fixture_.workspace().cuts().add({"", UserCut::Kind::Dart, {{103, 0, 0}, {103, 62, 0}}});
        QVERIFY(QTest::qWaitFor([this] { return document().garment()->cuts.size() == 1; },
                                test::kPatience));
        QVERIFY(waitForPieces(2));
        fixture_.action(ActionId::GoToLines).trigger();
        document().setSeam(dart());
    }

private slots:
    void anIntakeThatIsTypedIsDrawnAndTakenBack() {
        openDart();
        QVERIFY(isShown("dartIntake"));
        QVERIFY(label("dartLegs").contains("62"));
        const int before = document().history().index();
        type("dartIntake", "20");
        QCOMPARE(document().history().index(), before + 1);
        QVERIFY(isFlatAgain());
        QVERIFY(std::abs(drawn().intake - 20) < 1e-6);
        QVERIFY(std::abs(drawn().leg - 62) < 0.01);
        QVERIFY(fixture_.find<QToolButton>("dartIntakeReset").isEnabled());
        // The angle says the same.
        const auto& angle = fixture_.find<QDoubleSpinBox>("dartAngle");
        QVERIFY(std::abs(angle.value() * std::acos(-1) / 180 - drawn().angle) < 1e-3);
        undo();
        QVERIFY(isFlatAgain());
        QVERIFY(lines().darts.empty());
        QVERIFY(std::abs(drawn().intake) < 1e-6);
        type("dartAngle", "30");
        QVERIFY(isFlatAgain());
        QVERIFY(std::abs(drawn().angle * 180 / std::acos(-1) - 30) < 1e-4);
        fixture_.find<QToolButton>("dartIntakeReset").click();
        QVERIFY(isFlatAgain());
        QVERIFY(lines().darts.empty());
    }

    void anIntakeOutOfReachIsRefusedInWords() {
        openDart();
        QVERIFY(!isShown("dartRefusal"));
        type("dartIntake", "130");
        QVERIFY(isShown("dartRefusal"));
        QVERIFY(lines().darts.empty());
        QCOMPARE(field("dartIntake").value(), 0.0);  // as it is, and not as it was typed
        type("dartAngle", "180");
        QVERIFY(isShown("dartRefusal"));
        QCOMPARE(field("dartAngle").value(), 0.0);
        // The legs reach so far, but that is a corner and no dart.
        for (const char* angle : {"60", "90", "179"}) {
            type("dartAngle", angle);
            QVERIFY(isShown("dartRefusal"));
            QVERIFY(label("dartRefusal").contains("62"));
            QVERIFY(lines().darts.empty());
        }
        type("dartIntake", "30");
        QVERIFY(!isShown("dartRefusal"));
        QCOMPARE(lines().darts.size(), std::size_t(1));
    }

    void anIntakeBelowTheLeastIsTheLeastAndShownSo() {
        openDart();
        for (int time = 0; time < 2; ++time) {
            type("dartIntake", "0.05");
            QCOMPARE(lines().darts.at(0).intake, std::optional(kMinIntake));
            QCOMPARE(field("dartIntake").value(), kMinIntake);
            QVERIFY(isFlatAgain());
        }
    }

    void legsReachAsFarAsTheyAreLongInThePattern() {
        openDart();
        const int seam = dart();
        fixture_.document().setSeamEase(seam, 0.1);
        document().setEaseDrawn(seam, true);
        QVERIFY(isFlatAgain());
        // Legs of 62 and 68.2 mm; at 65.3 they open by 60 degrees.
        for (const char* outOfReach : {"6.1", "65.4", "130.3"}) {
            type("dartIntake", outOfReach);
            QVERIFY(isShown("dartRefusal"));
            QVERIFY(lines().darts.empty());
        }
        for (const double within : {6.3, 65.2}) {
            type("dartIntake", QString::number(within));
            QVERIFY(!isShown("dartRefusal"));
            QVERIFY(isFlatAgain());
            QVERIFY(std::abs(drawn().intake - within) < 1e-6);
            for (const Error& note : document().results()[0]->flat->notes) {
                QVERIFY(note.code != ErrorCode::LineNotDrawn);
            }
        }
    }

    void theLayIsChosenAndAProjectKeepsBoth() {
        openDart();
        type("dartIntake", "25");
        auto& lay = fixture_.find<QComboBox>("dartLay");
        for (const DartLay wanted : {DartLay::Second, DartLay::First}) {
            lay.setFocus();
            QTest::keyClick(&lay, wanted == DartLay::Second ? Qt::Key_End : Qt::Key_Up);
            QVERIFY(isFlatAgain());
            QCOMPARE(drawn().lay, wanted);
        }
        const LineSettings said = lines();
        QCOMPARE(said.darts.size(), std::size_t(1));
        const QString file = fixture_.path("dart.toile");
        QVERIFY(writeProject(file.toStdString(), projectOf(document().state(), document().derived(),
                                                           document().view())));
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(lines() == said);
        QVERIFY(std::abs(drawn().intake - 25) < 1e-6);
    }

    void aDartBecomesASeamAndADartAgain() {
        openDart();
        type("dartIntake", "20");
        QVERIFY(isFlatAgain());
        const DocumentState before = document().state();
        const Points2 flat = document().results()[0]->flat->Q;
        QAction& toSeam = fixture_.action(ActionId::DartToSeam);
        QAction& toDart = fixture_.action(ActionId::SeamToDart);
        QVERIFY(toSeam.isEnabled() && !toDart.isEnabled());
        toSeam.trigger();
        QVERIFY(waitForPieces(3));
        QCOMPARE(dart(), -1);
        QVERIFY(document().seam());
        QVERIFY(!toSeam.isEnabled() && toDart.isEnabled());
        QVERIFY(!isShown("dartIntake"));
        QCOMPARE(document().state().lines.darts.size(), std::size_t(1));
        toDart.trigger();
        QVERIFY(waitForPieces(2));
        QVERIFY(isFlatAgain());
        QVERIFY(document().state().inputs == before.inputs);
        QVERIFY(lines() == before.lines);
        QVERIFY((document().results()[0]->flat->Q - flat).cwiseAbs().maxCoeff() < 1e-6);
        QVERIFY(document().seam() && *document().seam() == dart());
        undo();
        QVERIFY(waitForPieces(3));
        undo();
        QVERIFY(waitForPieces(2));
        QVERIFY(document().state().inputs == before.inputs && lines() == before.lines);
    }
};

TOILE_WINDOW_TEST(DartFormTest)
#include "dart_form_test.moc"
