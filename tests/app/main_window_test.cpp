// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QAbstractItemModel>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QItemSelectionModel>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QMouseEvent>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>
#include <filesystem>
#include <memory>

#include "app/actions/garment_actions.h"
#include "app/panels/figures.h"
#include "app/render/gl_support.h"
#include "app/render/scene.h"
#include "app/render/scene_renderer.h"
#include "app/resources.h"
#include "app/settings/preferences.h"
#include "app/views/garment_view.h"
#include "app/views/pattern_view.h"
#include "app/views/view_area.h"
#include "app/widgets/banner.h"
#include "app/widgets/colour_bar.h"
#include "tests/app/support/garments.h"

using namespace toile;

namespace {

constexpr int kPatience = 30000;

void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
               Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QMouseEvent event(type, at, widget.mapToGlobal(at), button, buttons, modifiers);
    QApplication::sendEvent(&widget, &event);
}

void dragMouse(QWidget& widget, const QPointF& from, const QPointF& to, Qt::MouseButton button,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    sendMouse(widget, QEvent::MouseButtonPress, from, button, button, modifiers);
    for (int i = 1; i <= 8; ++i) {
        sendMouse(widget, QEvent::MouseMove, from + (to - from) * i / 8.0, Qt::NoButton, button,
                  modifiers);
    }
    sendMouse(widget, QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
}

void turnWheel(QWidget& widget, const QPointF& at, int notches) {
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

int countPixels(const QImage& image, const QColor& colour, int tolerance) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            count += std::abs(pixel.red() - colour.red()) <= tolerance &&
                     std::abs(pixel.green() - colour.green()) <= tolerance &&
                     std::abs(pixel.blue() - colour.blue()) <= tolerance;
        }
    }
    return count;
}

}  // namespace

/// The window as a person meets it: a garment of a bent strip and a cap, real mouse and keys.
class MainWindowTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    std::unique_ptr<Preferences> preferences_;
    std::unique_ptr<MainWindow> window_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    Document& document() { return window_->workspace().document(); }
    QWidget& garmentView() { return *window_->views().garmentView(); }
    QWidget& patternView() { return *window_->views().patternView(); }

    QPointF onGarment(int piece) {
        const auto& box = document().scene()->pieces[static_cast<std::size_t>(piece)].box;
        const auto at = window_->views().garmentView()->camera().project(box.center());
        return {at.x(), at.y()};
    }

    QPointF onPattern(int piece) {
        const auto& entry = document().scene()->pieces[static_cast<std::size_t>(piece)];
        const auto at =
            window_->views().patternView()->camera().toScreen(entry.label + entry.offset);
        return {at.x(), at.y()};
    }

    bool openAndWait(const QStringList& files) {
        window_->openFiles(files);
        return waitForResults();
    }

    bool waitForResults() {
        return QTest::qWaitFor(
            [this] {
                return !window_->workspace().jobs().isBusy() && !document().results().empty() &&
                       window_->views().isUpToDate();
            },
            kPatience);
    }

    /// Opens the menu with the mouse, as a person does.
    QMenu& openMenu(const char* name) {
        auto* menu = window_->findChild<QMenu*>(name);
        QMenuBar* bar = window_->menuBar();
        QTest::mouseClick(bar, Qt::LeftButton, {},
                          bar->actionGeometry(menu->menuAction()).center());
        return *menu;
    }

    QImage picture(QWidget& view) { return static_cast<QOpenGLWidget&>(view).grabFramebuffer(); }

private slots:
    void initTestCase() {
        loadResources();
        QLocale::setDefault(QLocale::c());
        if (!glProblem().isEmpty()) {
            QSKIP("no OpenGL 3.3 context can be made here");
        }
        test::writeObj(path("pair.obj").toStdString(),
                       {{"strip", test::makeBentStrip(-140)}, {"cap", test::makeCap(140)}});
        test::writeObj(path("mixed.obj").toStdString(), {{"strip", test::makeBentStrip(-140)},
                                                         {"ball", test::makeTetrahedron(120)}});
    }

    void init() {
        preferences_ = std::make_unique<Preferences>(QString());
        window_ = std::make_unique<MainWindow>(*preferences_);
        window_->workspace().setUnit(LengthUnit::Millimetre);
        window_->resize(1200, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        QApplication::setActiveWindow(window_.get());
    }

    void cleanup() { window_.reset(); }

    void emptyWindowInvites() {
        QVERIFY(window_->findChild<QWidget*>("welcome")->isVisible());
        QVERIFY(!window_->views().isVisible());
        QVERIFY(!window_->actions()[ActionId::ExportSvg].isEnabled());
        QVERIFY(!window_->findChild<QWidget*>("pieceTable")->isVisible());
    }

    void garmentIsReadFlattenedAndShown() {
        QVERIFY(openAndWait({path("pair.obj")}));
        QCOMPARE(document().pieceCount(), 2);
        for (const auto& result : document().results()) {
            QVERIFY(result->flat);
        }
        QVERIFY(window_->windowTitle().startsWith("pair.obj"));
        QVERIFY(window_->views().isVisible());
        auto* table = window_->findChild<QTreeView*>("pieceTable");
        QCOMPARE(table->model()->rowCount(), 2);
        QCOMPARE(table->model()->index(0, 0).data().toString(), QString("strip"));
        QCOMPARE(table->model()->index(0, 1).data().toString(), QString("Flat"));
    }

    void clickingAPieceInEitherViewSelectsItEverywhere() {
        QVERIFY(openAndWait({path("pair.obj")}));
        auto* table = window_->findChild<QTreeView*>("pieceTable");
        const QColor selection = renderStyle(window_->palette()).selection;
        const int before3d = countPixels(picture(garmentView()), selection, 24);
        const int before2d = countPixels(picture(patternView()), selection, 24);

        QTest::mouseClick(&garmentView(), Qt::LeftButton, {}, onGarment(1).toPoint());
        QCOMPARE(document().selection(), Document::Selection{1});
        QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
        QCOMPARE(table->selectionModel()->selectedRows().front().row(), 1);
        QVERIFY(window_->findChild<QLabel*>("pieceDetails")->text().contains("cap"));
        QVERIFY(countPixels(picture(garmentView()), selection, 24) > before3d + 200);
        QVERIFY(countPixels(picture(patternView()), selection, 24) > before2d + 200);

        QTest::mouseClick(&patternView(), Qt::LeftButton, {}, onPattern(0).toPoint());
        QCOMPARE(document().selection(), Document::Selection{0});
        QTest::mouseClick(&patternView(), Qt::LeftButton, Qt::ControlModifier,
                          onPattern(1).toPoint());
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));
        QTest::mouseClick(&patternView(), Qt::LeftButton, {}, QPoint(3, 3));
        QVERIFY(document().selection().empty());
    }

    void selectingInTheTableSelectsInTheViews() {
        QVERIFY(openAndWait({path("pair.obj")}));
        auto* table = window_->findChild<QTreeView*>("pieceTable");
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualRect(table->model()->index(1, 0)).center());
        QCOMPARE(document().selection(), Document::Selection{1});
    }

    void keysSwitchTheOverlays() {
        QVERIFY(openAndWait({path("pair.obj")}));
        const auto* legend = window_->findChild<ColourBar*>("colourBar");
        const QImage checker = picture(patternView());
        const std::pair<Qt::Key, Overlay> keys[] = {{Qt::Key_1, Overlay::None},
                                                    {Qt::Key_3, Overlay::Area},
                                                    {Qt::Key_4, Overlay::Angle},
                                                    {Qt::Key_5, Overlay::Strain},
                                                    {Qt::Key_2, Overlay::Checker}};
        QString last = legend->summary();
        for (const auto& [key, overlay] : keys) {
            QTest::keyClick(&garmentView(), key);
            QCOMPARE(document().view().overlay, overlay);
            QVERIFY(legend->summary() != last);
            last = legend->summary();
            QCOMPARE(picture(patternView()) == checker, overlay == Overlay::Checker);
        }
        QTest::keyClick(&garmentView(), Qt::Key_W);
        QVERIFY(document().view().wireframe);
    }

    void wheelZoomsToTheCursor() {
        QVERIFY(openAndWait({path("pair.obj")}));
        const Camera2D& sheet = window_->views().patternView()->camera();
        const Eigen::Vector2d before = sheet.toWorld(100, 140);
        const double scale = sheet.pixelsPerMillimetre();
        turnWheel(patternView(), {100, 140}, 3);
        QVERIFY(sheet.pixelsPerMillimetre() > 1.3 * scale);
        QVERIFY((sheet.toWorld(100, 140) - before).norm() < 1e-6);

        const QPointF cap = onGarment(1);
        const double distance = window_->views().garmentView()->camera().distance();
        turnWheel(garmentView(), cap, 2);
        QVERIFY(window_->views().garmentView()->camera().distance() < distance);
        // The middle of the cap's box lies behind its surface, so it drifts, but hardly.
        QVERIFY(QLineF(onGarment(1), cap).length() < 12);
    }

    void dragTurnsTheGarmentAndMovesTheSheet() {
        QVERIFY(openAndWait({path("pair.obj")}));
        const auto& camera = window_->views().garmentView()->camera();
        const Eigen::Vector3d point(0, 0, 80);
        for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton}) {
            const Eigen::Vector2d before = camera.project(point);
            dragMouse(garmentView(), {200, 200}, {290, 180}, button);
            QVERIFY((camera.project(point) - before).norm() > 5);
        }
        const double distance = camera.distance();
        const Eigen::Vector3d middle = camera.pointAtTargetDepth(200, 200);
        dragMouse(garmentView(), {200, 200}, {240, 230}, Qt::MiddleButton, Qt::ShiftModifier);
        QVERIFY((camera.project(middle) - Eigen::Vector2d(240, 230)).norm() < 1e-6);
        QCOMPARE(camera.distance(), distance);
        QVERIFY(document().selection().empty());  // a drag is no click

        const Camera2D& sheet = window_->views().patternView()->camera();
        const Eigen::Vector2d corner = sheet.toWorld(50, 50);
        dragMouse(patternView(), {50, 50}, {90, 20}, Qt::LeftButton);
        QVERIFY((sheet.toScreen(corner) - Eigen::Vector2d(90, 20)).norm() < 1e-6);

        QTest::keyClick(&patternView(), Qt::Key_F);
        (void)picture(patternView());
        const auto box = document().scene()->sheetBox;
        QVERIFY(sheet.visible().contains(box));
    }

    void doubleClickFramesThePiece() {
        QVERIFY(openAndWait({path("pair.obj")}));
        const double scale = window_->views().patternView()->camera().pixelsPerMillimetre();
        QTest::mouseDClick(&patternView(), Qt::LeftButton, {}, onPattern(1).toPoint());
        QVERIFY(window_->views().patternView()->camera().pixelsPerMillimetre() > 1.2 * scale);
        QCOMPARE(document().selection(), Document::Selection{1});
    }

    void checkerboardIsTrueToScaleInThePattern() {
        QVERIFY(openAndWait({path("pair.obj")}));
        QTest::mouseDClick(&patternView(), Qt::LeftButton, {}, onPattern(0).toPoint());
        document().setSelection({});
        const QImage image = picture(patternView());
        const auto& camera = window_->views().patternView()->camera();
        const auto& piece = document().scene()->pieces[0];
        const double squarePixels = 10 * camera.pixelsPerMillimetre() * image.devicePixelRatio();
        // Along a line across the piece, a little above its lower edge, away from the name.
        const double y = piece.flatBox.min().y() + 25 + piece.offset.y();
        const Eigen::Vector2d from =
            camera.toScreen({piece.flatBox.min().x() + 15 + piece.offset.x(), y});
        const Eigen::Vector2d to =
            camera.toScreen({piece.flatBox.max().x() - 15 + piece.offset.x(), y});
        const int row = qRound(from.y() * image.devicePixelRatio());
        int least = 255, largest = 0, changes = 0;
        bool wasLight = false, first = true;
        const int begin = qRound(from.x() * image.devicePixelRatio());
        const int end = qRound(to.x() * image.devicePixelRatio());
        for (int x = begin; x <= end; ++x) {
            const int lightness = qGray(image.pixel(x, row));
            least = std::min(least, lightness);
            largest = std::max(largest, lightness);
        }
        for (int x = begin; x <= end; ++x) {
            const bool light = qGray(image.pixel(x, row)) > (least + largest) / 2;
            changes += !first && light != wasLight;
            wasLight = light;
            first = false;
        }
        QVERIFY2(largest - least > 40, "squares stand out from each other");
        const double squares = (end - begin) / squarePixels;
        QVERIFY2(std::abs(changes - squares) <= 1.5,
                 qPrintable(QString("%1 changes on %2 squares").arg(changes).arg(squares)));
    }

    void garmentShowsTheCheckerboardToo() {
        QVERIFY(openAndWait({path("pair.obj")}));
        const QImage checker = picture(garmentView());
        document().setOverlay(Overlay::None);
        const QImage plain = picture(garmentView());
        int differing = 0;
        for (int y = 0; y < plain.height(); ++y) {
            for (int x = 0; x < plain.width(); ++x) {
                differing += std::abs(qGray(plain.pixel(x, y)) - qGray(checker.pixel(x, y))) > 12;
            }
        }
        QVERIFY(differing > 5000);
    }

    void movingTheCameraUploadsNothing() {
        QVERIFY(openAndWait({path("pair.obj")}));
        const int uploads = window_->views().garmentView()->renderer().meshUploads();
        dragMouse(garmentView(), {200, 200}, {260, 240}, Qt::LeftButton);
        document().setOverlay(Overlay::Strain);
        document().setSelection({1});
        document().setWireframe(true);
        (void)picture(garmentView());
        QCOMPARE(window_->views().garmentView()->renderer().meshUploads(), uploads);
    }

    void exportWritesWhereThePersonSays() {
        QVERIFY(openAndWait({path("pair.obj")}));
        QString suggested;
        FileDialogs dialogs = FileDialogs::native();
        dialogs.save = [&](QWidget*, const QString& suggestion, const QString&) {
            suggested = suggestion;
            return path("out");  // without an ending
        };
        window_->garmentActions().setFileDialogs(dialogs);
        QSignalSpy exported(&window_->workspace(), &Workspace::exported);
        window_->actions()[ActionId::ExportSvg].trigger();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QVERIFY(suggested.endsWith("pair-pattern.svg"));
        QFile file(path("out.svg"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY(text.contains("<svg") && text.contains("strip") && text.contains("cap"));
    }

    void openActionAsksAndOpens() {
        FileDialogs dialogs = FileDialogs::native();
        dialogs.open = [&](QWidget*, const QString&) { return QStringList{path("pair.obj")}; };
        window_->garmentActions().setFileDialogs(dialogs);
        QTest::mouseClick(window_->findChild<QWidget*>("welcomeOpen"), Qt::LeftButton);
        QVERIFY(waitForResults());
        QCOMPARE(preferences_->openFolder(), QFileInfo(path("pair.obj")).absolutePath());
    }

    void droppedFilesAreOpened() {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path("pair.obj")), QUrl::fromLocalFile("notes.txt")});
        QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton,
                              Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &drop);
        QVERIFY(waitForResults());
        QCOMPARE(document().pieceCount(), 2);
    }

    void failedPieceIsNamedAndTheOthersGoOn() {
        QVERIFY(openAndWait({path("mixed.obj")}));
        QVERIFY(document().results()[0]->flat);
        QVERIFY(document().results()[1]->error);
        auto* table = window_->findChild<QTreeView*>("pieceTable");
        QVERIFY(table->model()->index(1, 1).data().toString() != "Flat");
        document().setSelection({1});
        QVERIFY(window_->findChild<QLabel*>("pieceDetails")->text().contains("ball"));
    }

    void unreadableFileLeavesTheGarmentAlone() {
        QVERIFY(openAndWait({path("pair.obj")}));
        window_->openFiles({path("missing.obj")});
        QTRY_VERIFY_WITH_TIMEOUT(window_->banner().isVisible(), kPatience);
        QVERIFY(window_->banner().sentence().contains("missing.obj"));
        QCOMPARE(document().pieceCount(), 2);
        QVERIFY(!document().results().empty());
        QVERIFY(openAndWait({path("pair.obj")}));
        QVERIFY(!window_->banner().isVisible());
    }

    void anotherMethodFlattensAgain() {
        QVERIFY(openAndWait({path("pair.obj")}));
        QVERIFY(document().results()[1]->quality->maxBoundaryLengthError < 1e-9);
        window_->actions()[ActionId::MethodNatural].trigger();
        QTRY_COMPARE_WITH_TIMEOUT(document().results()[1]->options.method, Method::Natural,
                                  kPatience);
        QVERIFY(document().results()[1]->quality->maxBoundaryLengthError > 1e-4);
        QVERIFY(!window_->actions()[ActionId::SolverSlcp].isEnabled());
    }

    void everyMethodStandsInTheFlattenMenu() {
        QMenu& menu = openMenu("flattenMenu");
        QTRY_VERIFY(menu.isVisible());
        bool keepsLengths = true;
        QString section;
        std::size_t found = 0;
        for (const QAction* action : menu.actions()) {
            if (action->isSeparator()) {
                section = action->text();
                continue;
            }
            for (const MethodTraits& method : allMethods()) {
                if (action != &window_->actions()[actionOf(method.method)]) {
                    continue;
                }
                ++found;
                QVERIFY2(keepsLengths || !method.keepsLengths, "free outlines come last");
                keepsLengths = method.keepsLengths;
                QCOMPARE(section, keepsLengths ? QString("Seam lines keep their length")
                                               : QString("Seam lines may change"));
                QCOMPARE(action->text().remove('&'), methodName(method.method));
                QVERIFY(!action->statusTip().isEmpty());
                QCOMPARE(action->isChecked(), document().options().method == method.method);
            }
        }
        QCOMPARE(found, allMethods().size());
        QString letters;
        for (const QAction* action : menu.actions()) {
            const qsizetype mark = action->text().indexOf('&');
            if (mark >= 0) {
                const QChar letter = action->text().at(mark + 1).toLower();
                QVERIFY2(!letters.contains(letter), qPrintable(action->text()));
                letters += letter;
            }
        }
        menu.close();
    }

    void choosingAMethodInTheMenuFlattensAgain() {
        QVERIFY(openAndWait({path("pair.obj")}));
        QMenu& menu = openMenu("flattenMenu");
        QTRY_VERIFY(menu.isVisible());
        QAction& curvature = window_->actions()[ActionId::MethodCurvature];
        QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(&curvature).center());
        QVERIFY(curvature.isChecked());
        QTRY_COMPARE_WITH_TIMEOUT(document().results()[1]->options.method, Method::Curvature,
                                  kPatience);
        QVERIFY(document().results()[1]->quality->maxBoundaryLengthError < 1e-9);
        document().setSelection({1});
        const QString details = window_->findChild<QLabel*>("pieceDetails")->text();
        QVERIFY2(details.contains(methodName(Method::Curvature)), qPrintable(details));
    }

    void qualityIsForTheIsometricMethodOnly() {
        QVERIFY(openAndWait({path("pair.obj")}));
        ActionRegistry& actions = window_->actions();
        auto* quality = window_->findChild<QMenu*>("qualityMenu");
        for (const Method method : {Method::Natural, Method::Isometric, Method::Wang2005}) {
            actions[actionOf(method)].trigger();
            const bool isometric = method == Method::Isometric;
            QCOMPARE(actions[ActionId::QualityFine].isEnabled(), isometric);
            QCOMPARE(quality->menuAction()->isEnabled(), isometric);
        }
        QVERIFY(actions[ActionId::QualityStandard].isChecked());
        actions[ActionId::MethodIsometric].trigger();
        QMenu& menu = openMenu("flattenMenu");
        QTRY_VERIFY(menu.isVisible());
        QTest::keyClick(&menu, Qt::Key_Q);
        QTRY_VERIFY(quality->isVisible());
        QTest::mouseClick(quality, Qt::LeftButton, {},
                          quality->actionGeometry(&actions[ActionId::QualityDraft]).center());
        QCOMPARE(document().options().quality, Quality::Draft);
        QVERIFY(!actions[ActionId::QualityStandard].isChecked());
        QTRY_COMPARE_WITH_TIMEOUT(document().results()[1]->options.quality, Quality::Draft,
                                  kPatience);
        QCOMPARE(document().results()[1]->options.method, Method::Isometric);
    }

    void unitActionReadsTheFileAgain() {
        QVERIFY(openAndWait({path("pair.obj")}));
        const double area = document().results()[0]->quality->area3d;
        window_->actions()[ActionId::UnitCentimetre].trigger();
        QTRY_VERIFY_WITH_TIMEOUT(
            !document().results().empty() && document().results()[0]->quality->area3d > 50 * area,
            kPatience);
    }

    void closedDockStaysClosedNextTime() {
        Preferences kept(path("preferences.ini"));
        {
            MainWindow first(kept);
            first.show();
            first.openFiles({path("pair.obj")});
            auto* dock = first.findChild<QDockWidget*>("messagesDock");
            QTRY_VERIFY_WITH_TIMEOUT(dock->toggleViewAction()->isChecked(), kPatience);
            dock->toggleViewAction()->trigger();
            first.close();
        }
        MainWindow second(kept);
        second.show();
        second.openFiles({path("pair.obj")});
        QTRY_VERIFY_WITH_TIMEOUT(second.workspace().document().garment(), kPatience);
        QVERIFY(!second.findChild<QDockWidget*>("messagesDock")->toggleViewAction()->isChecked());
        QVERIFY(second.findChild<QDockWidget*>("piecesDock")->toggleViewAction()->isChecked());
    }

    void closingWhileAJobRunsIsSafe() {
        window_->openFiles({path("pair.obj")});
        QVERIFY(window_->workspace().jobs().isBusy());
        window_->close();
        QVERIFY(!window_->workspace().jobs().isBusy());
    }

    void cancelActionIsThereWhileAJobRuns() {
        QAction& cancel = window_->actions()[ActionId::Cancel];
        QVERIFY(!cancel.isEnabled());
        window_->openFiles({path("pair.obj")});
        QVERIFY(cancel.isEnabled());
        QVERIFY(window_->findChild<QProgressBar*>("progress")->isVisible());
        QTest::mouseClick(window_->findChild<QToolButton*>("cancelButton"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().jobs().isBusy(), kPatience);
        QVERIFY(!cancel.isEnabled());
        QVERIFY(!window_->findChild<QProgressBar*>("progress")->isVisible());
    }
};

int main(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat());
    QApplication application(argc, argv);
    MainWindowTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "main_window_test.moc"
