// SPDX-License-Identifier: GPL-3.0-or-later
// Takes docs/window.md's pictures, each of a state that a person comes to; with TOILE_UPDATE_DOCS
// set they are written.
#include <QFile>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <filesystem>

#include "app/jobs/ready_checker.h"
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

    /// The last: what has been translated stays.
    void german() {
        useLanguage(Language::German);
        openTshirt();
        keep("german");
    }
};

TOILE_WINDOW_TEST(WindowPicturesTest)
#include "window_pictures_test.moc"
