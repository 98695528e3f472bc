// SPDX-License-Identifier: GPL-3.0-or-later
// From choosing a file to a pattern that lies as it should: what is seen on the way, what is asked,
// and where what is made of it goes.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <QTimer>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/actions/own_folders.h"
#include "app/render/scene.h"
#include "app/widgets/busy_sheet.h"
#include "app/widgets/garment_card.h"
#include "app/widgets/number_edits.h"
#include "app/window/window_busy.h"
#include "app/window/window_centre.h"
#include "core/project/piece_settings.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

namespace {

/// A sleeve of 14.4 units, as MakeHuman writes a garment of 1.44 m: one tube, and two islands in
/// its UV map, of which Toile cannot know that they are panels; and two buttons of an island each.
void writeTubeInDecimetres(const std::string& path) {
    constexpr int kAround = 12, kRings = 9;
    std::ofstream out(path);
    for (int ring = 0; ring < kRings; ++ring) {
        for (int k = 0; k < kAround; ++k) {
            const double angle = 2 * kPi * k / kAround;
            out << "v " << std::cos(angle) << ' ' << 1.8 * ring << ' ' << std::sin(angle) << '\n';
        }
    }
    constexpr int kUvs = kAround + 2;  // the islands' borders are there twice
    for (int ring = 0; ring < kRings; ++ring) {
        for (int u = 0; u < kUvs; ++u) {
            out << "vt " << 0.03 * u * u << ' ' << 0.02 * ring * ring << '\n';
        }
    }
    for (int ring = 0; ring + 1 < kRings; ++ring) {
        for (int k = 0; k < kAround; ++k) {
            out << 'f';
            for (const auto& [dk, dr] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}}) {
                out << ' ' << (ring + dr) * kAround + (k + dk) % kAround + 1 << '/'
                    << (ring + dr) * kUvs + k + dk + (k >= kAround / 2 ? 1 : 0) + 1;
            }
            out << '\n';
        }
    }
    for (int button = 0; button < 2; ++button) {
        const double y = 4 + 3 * button, u = 5 + button;
        out << "v 0 " << y << " 1.2\nv 0.15 " << y << " 1.2\nv 0.15 " << y + 0.15 << " 1.2\nv 0 "
            << y + 0.15 << " 1.2\n";
        out << "vt " << u << " 0\nvt " << u + 0.1 << " 0\nvt " << u + 0.1 << " 0.1\nvt " << u
            << " 0.1\nf -4/-4 -3/-3 -2/-2 -1/-1\n";
    }
}

}  // namespace

class OpeningTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    GarmentCard& card() { return fixture_.window().card(); }

    QPushButton* cardButton(const QString& text) {
        for (auto* button : card().findChildren<QPushButton*>()) {
            if (button->text() == text && button->isVisible()) {
                return button;
            }
        }
        return nullptr;
    }

    int flatCount() {
        return static_cast<int>(std::ranges::count_if(
            document().garment()->pieces, [](const auto& piece) { return !piece->defect; }));
    }

    /// Says that the garment is so tall and divides it by the card's button.
    void typeHeightAndDivide(const QString& file) {
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(card().isVisible());
        auto& field = fixture_.find<LengthEdit>("otherLength");
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, "180 cm");
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(std::abs(document().scene()->box.sizes().y() - 1800) < 1e-6);
        divideByIslands();
        QVERIFY(std::abs(document().scene()->box.sizes().y() - 1800) < 1e-6);
    }

    void divideByIslands() {
        const int before = flatCount();
        QPushButton* divide = cardButton("Split by UV islands");
        QVERIFY(divide);
        QTest::mouseClick(divide, Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(flatCount() > before);
        QVERIFY(!cardButton("Split by UV islands"));
    }

    void chooseInMenuBar(const char* name, ActionId id) {
        QMenuBar& bar = *fixture_.window().menuBar();
        auto* menu = bar.findChild<QMenu*>(name);
        QTest::mouseClick(&bar, Qt::LeftButton, {},
                          bar.actionGeometry(menu->menuAction()).center());
        QVERIFY(menu->isVisible());
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(&fixture_.action(id)).center());
    }

    /// Leaves out all pieces below that many square centimetres, by the dialog. What can be flat of
    /// the others, and nothing else, is the pattern then.
    void leaveOutBelow(int area) {
        const double height = document().scene()->box.sizes().y();
        std::set<int> wanted;
        for (int k = 0; k < document().pieceCount(); ++k) {
            const Piece& piece = *document().garment()->pieces[std::size_t(k)];
            if (!piece.defect && wornArea(piece) >= 100.0 * area) {
                wanted.insert(k);
            }
        }
        QVERIFY(static_cast<int>(wanted.size()) < flatCount());
        chooseInMenuBar("pieceMenu", ActionId::LeaveOutSmall);
        auto& field = fixture_.find<QDoubleSpinBox>("leaveOutArea");
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, QString::number(area));
        QTest::mouseClick(&fixture_.find<QPushButton>("leaveOutNow"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        std::set<int> flat;
        for (int k = 0; k < document().pieceCount(); ++k) {
            if (document().patternPiece(k)) {
                flat.insert(k);
            }
        }
        QCOMPARE(flat, wanted);
        QCOMPARE(document().scene()->box.sizes().y(), height);
    }

    /// What the window makes of a file.
    struct Seen {
        LoadOptions loading;
        FlattenOptions options;
        ViewState view;
        double yaw, pitch;
        std::vector<Points2> flat;
    };

    Seen seen() {
        const Camera3D& camera = fixture_.garmentView().camera();
        Seen now{test::typed(document().loading()),
                 document().options(),
                 document().view(),
                 camera.yaw(),
                 camera.pitch(),
                 {}};
        for (const auto& result : document().results()) {
            now.flat.push_back(result->flat ? result->flat->Q : Points2());
        }
        return now;
    }

    /// Opens the file alone, and after another one of which everything was set otherwise.
    void expectOpenedAsTheFirst(const QString& file, const QString& before) {
        QVERIFY(fixture_.openAndWait(file));
        const Seen alone = seen();
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(before));
        for (const ActionId id :
             {ActionId::SplitUv, ActionId::CloseSlits, overlayAction(Overlay::Strain),
              ActionId::LookBack, ActionId::Wireframe}) {
            fixture_.action(id).trigger();
            QVERIFY(fixture_.waitForResults());
        }
        fixture_.workspace().setMethod(Method::Curvature);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(document().loading() != alone.loading && document().view() != alone.view);
        QVERIFY(fixture_.garmentView().camera().yaw() != alone.yaw);
        QVERIFY(fixture_.openAndWait(file));
        const Seen second = seen();
        QVERIFY(second.loading == alone.loading);
        QVERIFY(second.options == alone.options);
        QVERIFY(second.view == alone.view);
        QCOMPARE(second.yaw, alone.yaw);
        QCOMPARE(second.pitch, alone.pitch);
        QVERIFY(second.flat == alone.flat);
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("shirt.obj").toStdString(),
                       {{"front", test::makeSheet(300, 500, 6, 8)},
                        {"back", test::makeSheet(300, 500, 6, 8, {400, 0, 0})}});
        writeTubeInDecimetres(fixture_.path("tube.obj").toStdString());
    }

    void init() { fixture_.open(); }

    void cleanup() { fixture_.close(); }

    void whatIsReadIsSaidAtOnce() {
        auto& page = fixture_.find<BusySheet>("busyPage");
        QVERIFY(!page.isVisible());
        fixture_.window().openFiles({fixture_.path("shirt.obj")});
        QVERIFY(page.isVisible());  // before any event
        QVERIFY(page.task().contains("shirt.obj"));
        QVERIFY(!fixture_.find<QWidget>("welcome").isVisible());
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!page.isVisible());
    }

    void aSecondFileIsOpenedAsIfItWereTheFirst() {
        expectOpenedAsTheFirst(fixture_.path("shirt.obj"), fixture_.path("tube.obj"));
    }

    void leggingsAfterASuitAreOpenedAsIfTheyWereTheFirst() {
        const QString garments = TOILE_SOURCE_DIR "/../shared/data/garments/";
        const QString suit = garments + "suit_mh.obj", leggings = garments + "leggings.ply";
        if (!QFile::exists(suit) || !QFile::exists(leggings)) {
            QSKIP("needs the shared suit_mh.obj and leggings.ply");
        }
        expectOpenedAsTheFirst(leggings, suit);
    }

    void cancellingTheReadingLeadsBackToTheWelcome() {
        fixture_.window().openFiles({fixture_.path("shirt.obj")});
        auto& page = fixture_.find<BusySheet>("busyPage");
        QTest::mouseClick(page.findChild<QPushButton*>("busyCancel"), Qt::LeftButton);
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(!page.isVisible());
        QVERIFY(fixture_.find<QWidget>("welcome").isVisible());
        QVERIFY(!document().garment());
    }

    void thePatternThatIsAwaitedIsCovered() {
        auto& busy = *fixture_.window().findChild<WindowBusy*>();
        busy.setDelay(0);
        auto& sheet = fixture_.find<BusySheet>("busySheet");
        int covered = 0;
        connect(&fixture_.workspace().jobs(), &JobRunner::started, &sheet, [&] {
            covered += document().garment() && sheet.isVisibleTo(&fixture_.patternView());
        });
        QVERIFY(fixture_.openAndWait(fixture_.path("shirt.obj")));
        QCOMPARE(covered, 1);
        QVERIFY(!sheet.isVisible());
        fixture_.action(ActionId::FlattenAgain).trigger();  // the pattern is there meanwhile
        QVERIFY(!sheet.isVisible());
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(covered, 1);
    }

    void aPatternIsFramedOnArrivalWhateverWasDraggedBefore() {
        QVERIFY(fixture_.openAndWait(fixture_.path("shirt.obj")));
        (void)fixture_.patternPicture();
        const double usual = fixture_.patternView().pixelsPerMillimetre();
        fixture_.close();

        fixture_.open();
        bool dragged = false;
        connect(&fixture_.workspace().jobs(), &JobRunner::started, this, [&] {
            if (!document().garment() || dragged) {
                return;
            }
            dragged = true;  // while the sheet is empty
            test::drag(fixture_.patternView(), {200, 200}, {300, 260}, Qt::MiddleButton);
            test::turnWheel(fixture_.patternView(), {200, 200}, 3);
        });
        QVERIFY(fixture_.openAndWait(fixture_.path("shirt.obj")));
        QVERIFY(dragged);
        (void)fixture_.patternPicture();
        QVERIFY(std::abs(fixture_.patternView().pixelsPerMillimetre() / usual - 1) < 1e-9);

        // What is there stays where a person puts it.
        test::turnWheel(fixture_.patternView(), {200, 200}, 3);
        const double near = fixture_.patternView().pixelsPerMillimetre();
        QVERIFY(near > usual);
        fixture_.action(ActionId::FlattenAgain).trigger();
        QVERIFY(fixture_.waitForResults());
        (void)fixture_.patternPicture();
        QCOMPARE(fixture_.patternView().pixelsPerMillimetre(), near);
    }

    void aTubeInDecimetresGetsItsHeightAndItsPanels() {
        typeHeightAndDivide(fixture_.path("tube.obj"));
        QCOMPARE(flatCount(), 4);
        leaveOutBelow(10);
        QVERIFY(document().patternPiece(0) && document().patternPiece(1));
    }

    void aSuitOfMakeHumanHasItsHeightAndGetsItsPanels() {
        const std::filesystem::path suit =
            std::filesystem::path(TOILE_SOURCE_DIR) / "../shared/data/garments/suit_mh.obj";
        if (!std::filesystem::exists(suit)) {
            QSKIP("needs the shared suit_mh.obj");
        }
        QVERIFY(fixture_.openAndWait(QString::fromStdString(suit.string())));
        const double height = document().scene()->box.sizes().y();
        QVERIFY2(height > 1300 && height < 1900, qPrintable(QString::number(height)));
        divideByIslands();
        leaveOutBelow(20);
    }

    void theQuestionBeforeLeavingNamesWhatIsSaved() {
        const auto asked = [this](const QString& name) {
            QString text;
            QTimer::singleShot(0, this, [&text] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                text = box->text();
                box->reject();
            });
            (void)FileDialogs::native().askToSave(&fixture_.window(), name);
            return text;
        };
        QCOMPARE(asked("shirt.obj"), QString("Save the pattern made from shirt.obj as a project?"));
        QCOMPARE(asked("shirt.toile"), QString("Save the changes to the project shirt.toile?"));
    }

    void aSampleIsSavedAmongTheDocuments() {
        QVERIFY(!samplePaths().isEmpty());
        QStringList suggested;
        fixture_.window().garmentActions().fileDialogs().saveProject =
            [&suggested](QWidget*, const QString& suggestion) {
                suggested << suggestion;
                return QString();
            };
        QVERIFY(fixture_.openAndWait(samplePaths().front()));
        fixture_.action(ActionId::SaveAs).trigger();
        QVERIFY(fixture_.openAndWait(fixture_.path("shirt.obj")));
        fixture_.action(ActionId::SaveAs).trigger();
        QCOMPARE(suggested.size(), 2);
        QCOMPARE(QFileInfo(suggested[0]).absolutePath(),
                 QFileInfo(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
                     .absoluteFilePath());
        QCOMPARE(suggested[1], fixture_.path("shirt.toile"));
        QCOMPARE(writingFolder(samplePaths().front(), fixture_.path("shirt.toile")),
                 QFileInfo(fixture_.path("shirt.toile")).absolutePath());
    }
};

TOILE_WINDOW_TEST(OpeningTest)
#include "opening_test.moc"
