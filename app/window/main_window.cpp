// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QStatusBar>
#include <QUrl>

#include "app/actions/file_dialogs.h"
#include "app/actions/garment_actions.h"
#include "app/actions/project_actions.h"
#include "app/base/text.h"
#include "app/render/render_style.h"
#include "app/settings/length_display.h"
#include "app/settings/preferences.h"
#include "app/settings/theme.h"
#include "app/views/canvas.h"
#include "app/views/pattern_view.h"
#include "app/views/tools/cut_tools.h"
#include "app/views/tools/tool_box.h"
#include "app/views/view_area.h"
#include "app/widgets/banner.h"
#include "app/widgets/garment_card.h"
#include "app/window/window_context_menus.h"
#include "app/window/window_dialogs.h"
#include "app/window/window_menus.h"
#include "app/window/window_status.h"
#include "core/formats/read_pattern.h"

namespace toile::app {
namespace {

constexpr int kBarAir = 8, kBelowCaption = 40;

constexpr double kPartOfTheScreen = 0.92;
/// Version of the docks and their arrangement. Layouts of other versions are ignored.
constexpr int kLayoutVersion = 2;

QStringList openableFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile() && isOpenable(url.toLocalFile())) {
            files << url.toLocalFile();
        }
    }
    return files;
}

/// The single dragged pattern file, to compare with; empty for anything else.
QString patternFile(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    const QString file =
        urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
    return patternFileKind(pathOf(file)) ? file : QString();
}

}  // namespace

OutdatedBar::OutdatedBar(Workspace& workspace, const ActionRegistry& actions, QWidget& view)
    : QWidget(&view),
      workspace_(workspace),
      actions_(actions),
      exportTip_(actions[ActionId::ExportPattern].toolTip()),
      printTip_(actions[ActionId::PrintPattern].toolTip()) {
    setObjectName("outdatedBar");
    setAutoFillBackground(true);
    auto* label = new QLabel(tr("The pattern is out of date"), this);
    auto* button = new QPushButton(tr("Flatten now"), this);
    button->setObjectName("flattenNow");
    button->setToolTip(tr("Flatten the pieces that edits have changed"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kBarAir, kBarAir / 2, kBarAir / 2, kBarAir / 2);
    row->addWidget(label);
    row->addWidget(button);
    hide();
    view.installEventFilter(this);
    connect(button, &QPushButton::clicked, this,
            [this] { actions_[ActionId::FlattenAgain].trigger(); });
    connect(&workspace_, &Workspace::patternAged, this, &OutdatedBar::follow);
}

void OutdatedBar::follow(PatternAge age) {
    const bool isOutdated = age != PatternAge::UpToDate && !workspace_.document().results().empty();
    // The status bar shows running jobs, so this shows waiting ones only.
    const bool isWaiting = isOutdated && age == PatternAge::OutOfDate;
    const QString why = tr("The pattern is out of date. Flatten it first");
    actions_[ActionId::ExportPattern].setToolTip(isOutdated ? why : exportTip_);
    actions_[ActionId::PrintPattern].setToolTip(isOutdated ? why : printTip_);
    setVisible(isWaiting);
    if (isWaiting) {
        placeIt();
    }
}

bool OutdatedBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) {
        placeIt();
    }
    return QWidget::eventFilter(watched, event);
}

void OutdatedBar::placeIt() {
    adjustSize();
    move((parentWidget()->width() - width()) / 2, kBelowCaption);
    raise();
}

MainWindow::MainWindow(Preferences& preferences, QWidget* parent)
    : QMainWindow(parent),
      preferences_(preferences),
      garmentActions_(std::make_unique<GarmentActions>(actions_, workspace_, preferences, *this)),
      tools_(std::make_unique<ToolBox>(workspace_)),
      centre_(std::make_unique<WindowCentre>(workspace_, actions_, *tools_, preferences, this)),
      docks_(std::make_unique<WindowDocks>(*this, workspace_, actions_, views(), preferences)),
      status_(std::make_unique<WindowStatus>(*statusBar(), workspace_, actions_,
                                             garmentActions_->project().session(), checker())),
      dialogs_(std::make_unique<WindowDialogs>(*this, workspace_, actions_, views(), preferences,
                                               garmentActions_->fileDialogs())),
      contextMenus_(std::make_unique<WindowContextMenus>(*this, workspace_.document(), actions_,
                                                         garmentActions_->materials(), views())) {
    setObjectName("mainWindow");
    setAcceptDrops(true);
    setUnifiedTitleAndToolBarOnMac(true);
    setCentralWidget(centre_.get());
    fillMenuBar(*this, actions_, docks_->all(), garmentActions_->project().recent(),
                garmentActions_->materials());
    app::addToolBar(*this, actions_, workspace_);
    contextMenus_->serve(docks_->list(Panel::Pieces), "pieceContext");
    contextMenus_->serve(docks_->list(Panel::Seams), "seamContext");
    connectParts();
    connect(&preferences_, &Preferences::choicesChanged, this, &MainWindow::followChoices);
    followChoices(preferences_.choices());
    addActions(actions_.all());  // so that shortcuts work in hidden menus, too
    // Leave space for the window's frame.
    resize(QSize(1600, 1000).boundedTo(screen()->availableSize() * kPartOfTheScreen));
    restoreGeometry(preferences_.windowGeometry());
    showGarmentParts(false);
    updateTitle();
}

MainWindow::~MainWindow() {
    // Delete in this order: each part uses the following ones and the document until its end.
    workspace_.shutdown();
    contextMenus_.reset();
    dialogs_.reset();
    recovery_.reset();  // the clean exit removes the recovery file
    garmentActions_.reset();
    docks_.reset();
    centre_.reset();
    tools_.reset();
}

void MainWindow::connectParts() {
    const ProjectSession& session = garmentActions_->project().session();
    connect(garmentActions_.get(), &GarmentActions::failed, &banner(), &Banner::showSentence);
    connect(garmentActions_.get(), &GarmentActions::done, status_.get(), &WindowStatus::say);
    connect(&session, &ProjectSession::noticed, &banner(), &Banner::showSentence);
    connect(&session, &ProjectSession::changed, this, &MainWindow::updateTitle);
    connect(centre_.get(), &WindowCentre::filesWanted, this, &MainWindow::openFiles);
    connect(centre_.get(), &WindowCentre::hintChanged, this, &MainWindow::updateHint);
    connect(status_.get(), &WindowStatus::summaryWanted, centre_.get(), &WindowCentre::askAgain);
    if (PatternView* pattern = views().patternView()) {
        new OutdatedBar(workspace_, actions_, *pattern);
    }
    const auto proposeDart = [this](int piece, const Eigen::Vector2d& flat) {
        tools_->choose(ToolId::Dart);
        tools_->dart().propose(piece, flat);
        views().takeKeyboard(ViewKind::Garment);
    };
    connect(docks_.get(), &WindowDocks::dartWanted, this, proposeDart);
    connect(docks_.get(), &WindowDocks::bodyWanted, garmentActions_.get(),
            &GarmentActions::askForBody);
    connect(docks_.get(), &WindowDocks::unitWanted, centre_.get(), &WindowCentre::askAgain);
    actions_.on(ActionId::DartHere, this, [this, proposeDart] {
        if (const auto spot = contextMenus_->placeForDart()) {
            proposeDart(spot->piece, spot->flat);
        } else {
            centre_->banner().showSentence(
                tr("Right-click the place for the dart, or mark the worst spots first."));
        }
    });
    connect(&card(), &GarmentCard::kept, this, [this] { checker().setGuessesKept(true); });
    connect(&workspace_.document(), &Document::opened, this, &MainWindow::adaptToWeight);
    connect(&workspace_.document(), &Document::changed, this, &MainWindow::onChanged);
    actions_.on(ActionId::Quit, this, &QWidget::close);
}

void MainWindow::followChoices(const Choices& before) {
    const Choices& now = preferences_.choices();
    LengthDisplay::instance().choose(now.lengthUnit,
                                     now.lengthUnit == LengthUnit::Inch ? now.inchDenominator : 0);
    if (now.theme != before.theme) {
        applyTheme(now.theme);
    }
    Canvas::setNavigation(now.navigation);
    updateHint();
    workspace_.setNewLines(now.newGarment == NewGarment::Pattern ? withPattern({})
                                                                 : LineSettings{});
    actions_.setPlain(now.menus == Menus::Plain);
    setMarkColours(now.selectionColour, now.seamColour);
    views().repaintViews();
    if (now.autoFlattenTriangles != before.autoFlattenTriangles) {
        adaptToWeight();
    }
}

void MainWindow::goTo(Panel panel) {
    docks_->goTo(panel);
}

void MainWindow::updateHint() {
    status_->setHint(workspace_.document().garment() ? centre_->hint() : QString());
}

void MainWindow::onChanged(const DocumentChange& what) {
    if (what.touches(&Derived::garment, &DocumentState::labels)) {
        banner().hide();  // the message may refer to the previous garment
    }
    if (what.touches(&Derived::results, &Derived::scene) && !status_->hasSummary()) {
        status_->updateSummary();  // the scene exists again
        centre_->ask();
    }
    if (!what.hasOtherPieces()) {
        // A file was read as another kind, or mirrored pieces differ.
        if (what.touches(&Derived::garment, &Derived::symmetry)) {
            centre_->ask();
        }
        return;
    }
    showGarmentParts(workspace_.document().garment() != nullptr);
    updateTitle();
    status_->updateSummary();
    centre_->ask();
    checker().setGuessesKept(centre_->areGuessesKept());
}

void MainWindow::adaptToWeight() {
    if (!workspace_.document().garment()) {
        return;
    }
    Eigen::Index triangles = 0;
    for (const auto& piece : workspace_.document().garment()->pieces) {
        triangles += piece->mesh.F.rows();
    }
    const bool light = triangles <= preferences_.choices().autoFlattenTriangles;
    workspace_.setAutoFlatten(light);
    actions_[ActionId::AutoFlatten].setChecked(light);
    if (!light) {
        status_->say(tr("Large garment: press %1 to flatten your edits")
                         .arg(actions_[ActionId::FlattenAgain].shortcut().toString(
                             QKeySequence::NativeText)));
    }
}

void MainWindow::showGarmentParts(bool shown) {
    centre_->showViews(shown);
    updateHint();
    if (docks_->setAvailable(shown)) {
        // Restore the user's layout, if there is one.
        restoreState(preferences_.windowState(), kLayoutVersion);
    }
}

void MainWindow::updateTitle() {
    const ProjectSession& session = garmentActions_->project().session();
    const QString garment = session.title();
    setWindowTitle(garment.isEmpty() ? tr("Toile") : tr("%1[*] – Toile").arg(garment));
    setWindowModified(session.isModified());
}

Recovery& MainWindow::keepRecoveryFiles(const QString& folder,
                                        const std::optional<AutosaveTimes>& times) {
    const Choices& choices = preferences_.choices();
    recovery_.reset();
    recovery_ =
        std::make_unique<Recovery>(workspace_, garmentActions_->project(), centre_->recoveryCard(),
                                   folder, times ? times : autosaveTimes(choices.autosaveMinutes));
    Autosave& autosave = recovery_->autosave();
    connect(&autosave, &Autosave::failed, this, [this](const QString& sentence) {
        status_->say(tr("Unsaved changes are not backed up: %1").arg(sentence));
    });
    if (!times) {
        connect(&preferences_, &Preferences::choicesChanged, &autosave,
                [&autosave, &choices](const Choices& before) {
                    if (choices.autosaveMinutes != before.autosaveMinutes) {
                        autosave.setTimes(autosaveTimes(choices.autosaveMinutes));
                    }
                });
    }
    return *recovery_;
}

void MainWindow::openFiles(const QStringList& files) {
    garmentActions_->openFiles(files);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayClose()) {
        event->ignore();
        return;
    }
    preferences_.setWindowGeometry(saveGeometry());
    if (workspace_.document().garment()) {
        preferences_.setWindowState(saveState(kLayoutVersion));
    }
    // Hide at once, because the worker may need a moment to stop.
    hide();
    workspace_.shutdown();
    event->accept();
}

bool MainWindow::mayClose() {
    // If the user saves first, the answer comes later. Then the window closes itself.
    enum class Answer { None, Now, Later };
    const auto answer = std::make_shared<Answer>(Answer::None);
    if (workspace_.writing().isBusy()) {
        workspace_.whenWritten([this] { close(); });  // not if writing fails: show the error
        return false;
    }
    if (!closingAnyway_) {
        garmentActions_->project().leaveThen([this, answer] {
            if (*answer == Answer::None) {
                *answer = Answer::Now;
                return;
            }
            closingAnyway_ = true;
            close();
            closingAnyway_ = false;
        });
    }
    const bool now = closingAnyway_ || *answer == Answer::Now;
    *answer = Answer::Later;
    return now;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QMimeData& dragged = *event->mimeData();
    const bool isOpen = workspace_.document().garment() != nullptr;
    if (!openableFiles(dragged).isEmpty() || (isOpen && !patternFile(dragged).isEmpty())) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList files = openableFiles(*event->mimeData());
    const QString pattern = patternFile(*event->mimeData());
    if (!files.isEmpty()) {
        event->acceptProposedAction();
        openFiles(files);
    } else if (!pattern.isEmpty() && workspace_.document().garment()) {
        event->acceptProposedAction();
        garmentActions_->openReference(pattern);
    }
}

}  // namespace toile::app
