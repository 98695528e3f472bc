// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the pictures of docs/window.md, each of a state that a user reaches; docs/make_pictures.sh
// runs it. No test: nothing is checked but that the pictures can be taken.
#include <QFile>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QTreeWidget>
#include <filesystem>

#include "app/jobs/ready_checker.h"
#include "app/marker/cloth_view.h"
#include "app/marker/marker_window.h"
#include "app/panels/proposals_form.h"
#include "app/session/cut_proposals.h"
#include "app/settings/language.h"
#include "app/settings/theme.h"
#include "tests/app/support/doc_picture.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

Q_DECLARE_METATYPE(Preparation)

class WindowPicturesTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }

    bool isDone() {
        return fixture_.waitUntilIdle() &&
               QTest::qWaitFor([this] { return fixture_.window().views().isUpToDate(); },
                               test::kPatience);
    }

    void openTshirt(QSize size = {1400, 900}) {
        fixture_.open(size, NewGarment::Pattern);
        QVERIFY(fixture_.openAndWait(fixture_.path("tshirt.obj")));
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        QVERIFY(isDone());
    }

    void chooseFabric(const char* id) {
        DocumentState next = document().state();
        next.fabric = *fabricPreset(id);
        document().edit("Fabric", std::move(next));
        QVERIFY(isDone());
    }

    void keep(const char* name, const QPixmap& picture) {
        test::keepForDocs(QString("window-%1").arg(name), picture);
    }
    void keep(const char* name) {
        QTest::qWait(300);  // what comes a moment later is there
        keep(name, fixture_.window().grab());
    }

    QPointF inPattern(int piece) {
        const auto at = static_cast<std::size_t>(piece);
        const Eigen::Vector2d pixel = fixture_.patternView().camera().toScreen(
            document().settings()[at].placement->applied(document().scene()->pieces[at].label));
        return {pixel.x(), pixel.y()};
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj",
                            fixture_.path("tshirt.obj")));
    }

    void cleanup() {
        applyTheme(Theme::System);
        fixture_.close();
    }

    void welcome() {
        fixture_.open({1400, 900}, NewGarment::Pattern);
        keep("welcome");
    }

    void firstSight() {
        openTshirt();
        keep("first-sight");
    }

    void strain() {
        openTshirt();
        document().setOverlay(Overlay::Strain);
        chooseFabric("woven");
        keep("strain");
    }

    void selection() {
        openTshirt();
        QTest::mouseClick(&fixture_.patternView(), Qt::LeftButton, {}, inPattern(0).toPoint());
        QCOMPARE(document().selection(), Document::Selection{0});
        keep("selection");
    }

    void findings() {
        openTshirt();
        chooseFabric("woven");
        fixture_.action(ActionId::GoToProblems).trigger();
        QVERIFY(isDone());
        QVERIFY(QTest::qWaitFor([this] { return fixture_.window().checker().isUpToDate(); },
                                test::kPatience));
        keep("findings");
    }

    void contextMenu() {
        openTshirt();
        const QPointF at = inPattern(1);
        test::sendMouse(fixture_.patternView(), QEvent::MouseButtonPress, at, Qt::RightButton,
                        Qt::RightButton);
        test::sendMouse(fixture_.patternView(), QEvent::MouseButtonRelease, at, Qt::RightButton,
                        Qt::NoButton);
        QMenu* menu = nullptr;
        QTRY_VERIFY((menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())));
        QCOMPARE(menu->objectName(), QString("pieceContext"));
        QPixmap picture = fixture_.window().grab();
        QPainter(&picture).drawPixmap(fixture_.window().mapFromGlobal(menu->pos()), menu->grab());
        menu->close();
        keep("context-menu", picture);
    }

    void smallScreen() {
        openTshirt({1280, 680});
        QVERIFY(fixture_.window().height() <= 680);
        keep("small");
    }

    void dark() {
        applyTheme(Theme::Dark);
        openTshirt();
        keep("dark");
    }

    void garmentsAsTheyCome_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<Preparation>("preparing");
        // Tubes and closed pieces, with what helps beside them.
        QTest::newRow("import") << "garments/suit_mh.obj" << Preparation{};
        QTest::newRow("shell") << "thick/tee_sim_thick.obj" << Preparation{};
        QTest::newRow("scan") << "scans/dress_scan.obj"
                              << Preparation{.as = FileKind::Scan, .scan = {.edgeLength = 10}};
    }

    void garmentsAsTheyCome() {
        QFETCH(QString, file);
        QFETCH(Preparation, preparing);
        const auto path =
            std::filesystem::path(TOILE_SOURCE_DIR) / "../shared/data" / file.toStdString();
        if (!std::filesystem::exists(path)) {
            QSKIP(qPrintable("needs the shared " + file));
        }
        fixture_.open({1400, 900}, NewGarment::Pattern);
        fixture_.workspace().setPreparing(preparing);
        fixture_.workspace().setAutoCut(preparing.as == FileKind::Scan);
        fixture_.window().openFiles({QString::fromStdString(path.string())});
        QVERIFY(isDone());
        keep(QTest::currentDataTag());
    }

    /// A T-shirt whose panels have become one skin, with proposed cuts.
    void proposals() {
        QFile panels(fixture_.path("tshirt.obj"));
        QFile skin(fixture_.path("skin.obj"));
        QVERIFY(panels.open(QFile::ReadOnly) && skin.open(QFile::WriteOnly));
        for (const QByteArray& line : panels.readAll().split('\n')) {
            if (!line.startsWith("o ")) {
                skin.write(line + '\n');
            }
        }
        skin.close();
        fixture_.open({1400, 900}, NewGarment::Pattern);
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        fixture_.workspace().setWeld(true);
        QVERIFY(fixture_.openAndWait(fixture_.path("skin.obj")));
        fixture_.action(ActionId::ProposeCuts).trigger();
        CutProposals& proposals = fixture_.workspace().proposals();
        QTRY_VERIFY_WITH_TIMEOUT(
            proposals.state() == CutProposals::State::Known && !proposals.isSolving(),
            test::kPatience);
        auto& table = fixture_.find<QTreeWidget>("proposalTable");
        const auto armhole = table.findItems("left armhole", Qt::MatchExactly);
        proposals.select(
            armhole.isEmpty() ? 0 : std::size_t(table.indexOfTopLevelItem(armhole.front())));
        QTest::qWait(300);
        QPixmap picture = fixture_.window().grab();
        for (auto* form : fixture_.window().findChildren<ProposalsForm*>()) {
            QPainter painter(&picture);
            const QPixmap shown = form->grab();
            const QPoint at = fixture_.window().mapFromGlobal(form->pos());
            painter.drawPixmap(at, shown);
            painter.setPen(QColor(120, 120, 120));
            painter.drawRect(QRect(at, shown.size()));
        }
        keep("proposals", picture);
    }

    void marker() {
        openTshirt();
        QVERIFY(fixture_.waitForResults());
        fixture_.action(ActionId::LayOnCloth).trigger();
        auto& window = fixture_.find<MarkerWindow>("markerWindow");
        MarkerDesk& desk = window.desk();
        QTRY_VERIFY_WITH_TIMEOUT(desk.marker() && !desk.isRunning(), test::kPatience);
        QTest::mouseClick(window.findChild<QPushButton*>("markerImprove"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(desk.marker()->rounds >= 30 || !desk.isRunning(), test::kPatience);
        desk.stop();
        QTRY_VERIFY_WITH_TIMEOUT(!desk.isRunning(), test::kPatience);
        window.resize(1280, 760);
        window.view().frameAll();
        QTest::qWait(300);
        test::keepForDocs("marker-window", window.grab());
    }

    /// The last: what has been translated stays.
    void german() {
        useLanguage(Language::German);
        openTshirt();
        keep("german");
    }
};

TOILE_WINDOW_TEST(WindowPicturesTest)
#include "window_pictures_test.moc"
