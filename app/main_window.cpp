// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTreeView>
#include <QUndoView>
#include <QUrl>
#include <QVBoxLayout>

#include "app/actions/file_dialogs.h"
#include "app/actions/garment_actions.h"
#include "app/actions/project_actions.h"
#include "app/actions/recovery.h"
#include "app/compare/compare_window.h"
#include "app/panels/garment_summary.h"
#include "app/panels/pieces_panel.h"
#include "app/panels/problems_panel.h"
#include "app/panels/seams_panel.h"
#include "app/panels/welcome_page.h"
#include "app/panels/work_display.h"
#include "app/settings/preferences.h"
#include "app/views/garment_view.h"
#include "app/views/morph_bar.h"
#include "app/views/tools/tool_box.h"
#include "app/views/view_area.h"
#include "app/widgets/banner.h"
#include "app/widgets/column_chooser.h"
#include "app/widgets/garment_card.h"
#include "app/widgets/hint_label.h"

namespace toile {

namespace {

constexpr int kMessageMilliseconds = 6000;
constexpr double kPartOfTheScreen = 0.92;

QStringList openableFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile() && isOpenable(url.toLocalFile())) {
            files << url.toLocalFile();
        }
    }
    return files;
}

}  // namespace

MainWindow::MainWindow(Preferences& preferences, QWidget* parent)
    : QMainWindow(parent),
      preferences_(preferences),
      workspace_(this),
      actions_(this),
      garmentActions_(new GarmentActions(actions_, workspace_, preferences, *this)),
      tools_(new ToolBox(workspace_, this)) {
    garmentActions_->setParent(this);
    setObjectName("mainWindow");
    setAcceptDrops(true);
    setUnifiedTitleAndToolBarOnMac(true);
    makeCentre();
    makeDocks();
    makeMenus();
    makeToolBar();
    makeStatusBar();
    connectJobs();
    connectShell();
    connectChecks();
    connect(&workspace_.document(), &Document::changed, this, &MainWindow::onChanged);
    for (QAction* action : actions_.all()) {
        addAction(action);  // shortcuts work whichever menu is hidden
    }
    // The window's own frame takes its part of the screen.
    resize(QSize(1600, 1000).boundedTo(screen()->availableSize() * kPartOfTheScreen));
    restoreGeometry(preferences_.windowGeometry());
    showGarmentParts(false);
    updateTitle();
}

MainWindow::~MainWindow() {
    // The panels and views look at the document until they are gone; it is a member, so they have
    // to go before it.
    workspace_.shutdown();
    delete compare_;
    delete recovery_;        // a clean exit: nothing is left to recover
    delete garmentActions_;  // it saves the document to its end
    for (QWidget* part :
         std::initializer_list<QWidget*>{piecesDock_, seamsDock_, problemsDock_, historyDock_,
                                         positionDock_, fabricDock_, centralWidget()}) {
        delete part;
    }
    delete tools_;  // after the views, which work with them, and before the workspace
}

void MainWindow::makeCentre() {
    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    banner_ = new Banner(centre);
    connect(garmentActions_, &GarmentActions::failed, banner_, &Banner::showSentence);
    recoveryCard_ = new RecoveryCard(centre);
    connect(&workspace_, &Workspace::refused, banner_, &Banner::showSentence);
    card_ = new GarmentCard(centre);
    connect(card_, &GarmentCard::unitChosen, &workspace_, &Workspace::setUnit);
    connect(card_, &GarmentCard::upAxisChosen, &workspace_, &Workspace::setUpAxis);
    connect(card_, &GarmentCard::kept, this, [this] { keptGuesses_ = workspace_.openPaths(); });
    pages_ = new QStackedWidget(centre);
    auto* welcome = new WelcomePage(preferences_, pages_);
    connect(welcome, &WelcomePage::openWanted, &actions_[ActionId::Open], &QAction::trigger);
    connect(welcome, &WelcomePage::filesWanted, this, &MainWindow::openFiles);
    views_ = new ViewArea(workspace_.document(), *tools_, pages_);
    connect(views_, &ViewArea::failed, banner_, &Banner::showSentence);
    actions_.on(ActionId::Frame, views_, &ViewArea::frameSelection);
    pages_->addWidget(welcome);
    auto* work = new QWidget(pages_);
    auto* row = new QHBoxLayout(work);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(makeToolPalette());
    row->addWidget(views_, 1);
    pages_->addWidget(work);
    connectTools();
    layout->addWidget(banner_);
    layout->addWidget(recoveryCard_);
    layout->addWidget(card_);
    layout->addWidget(pages_, 1);
    setCentralWidget(centre);
}

void MainWindow::makeDocks() {
    pieces_ = new PiecesPanel(workspace_.document());
    seams_ = new SeamsPanel(workspace_.document());
    piecesDock_ = makeDock(tr("Pieces"), "piecesDock", pieces_);
    seamsDock_ = makeDock(tr("Seams"), "seamsDock", seams_);
    makeProblems();
    history_ = new QUndoView(&workspace_.document().history());
    history_->setObjectName("historyList");
    history_->setEmptyLabel(tr("As opened"));
    historyDock_ = makeDock(tr("History"), "historyDock", history_);
    makePropertyDocks();
    arrangeDocks();
    connectPanels();
}

QDockWidget* MainWindow::makeDock(const QString& title, const char* name, QWidget* panel) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(panel);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    return dock;
}

void MainWindow::connectLooks() {
    GarmentView* view = views_->garmentView();
    if (!view) {
        return;
    }
    constexpr std::pair<ActionId, ViewKey> kLooks[] = {
        {ActionId::LookFront, ViewKey::Front},
        {ActionId::LookBack, ViewKey::Back},
        {ActionId::LookRight, ViewKey::Right},
        {ActionId::LookLeft, ViewKey::Left},
        {ActionId::LookTop, ViewKey::Top},
        {ActionId::LookBottom, ViewKey::Bottom},
        {ActionId::Orthographic, ViewKey::Orthographic},
    };
    for (const auto& [id, key] : kLooks) {
        actions_.on(id, view, [view, key = key] { view->look(key); });
    }
    connect(view, &GarmentView::orthographicChanged, &actions_[ActionId::Orthographic],
            &QAction::setChecked);
    actions_.on(ActionId::PlayMorph, views_->morphBar(), &MorphBar::play);
}

void MainWindow::connectPanels() {
    constexpr auto kPieces = "pieces";
    pieces_->columns().setHidden(preferences_.hiddenColumns(kPieces, PiecesPanel::hiddenAtFirst()));
    connect(&pieces_->columns(), &ColumnChooser::chosen, this,
            [this](const QStringList& hidden) { preferences_.setHiddenColumns(kPieces, hidden); });
    connectLooks();
    connect(pieces_, &PiecesPanel::activated, views_, &ViewArea::frameSelection);
    connect(seams_, &SeamsPanel::activated, views_, &ViewArea::frameSeam);
    connect(seams_, &SeamsPanel::easeWanted, &workspace_, &Workspace::setEase);
    connect(seams_, &SeamsPanel::cutRemovalWanted, &workspace_, &Workspace::removeCut);
    connect(seams_, &SeamsPanel::joinRemovalWanted, &workspace_, &Workspace::removeJoin);
    actions_.on(ActionId::GoToPieces, this, [this] { goTo(Panel::Pieces); });
    actions_.on(ActionId::GoToSeams, this, [this] { goTo(Panel::Seams); });
    actions_.on(ActionId::GoToHistory, this, [this] { goTo(Panel::History); });
    actions_.on(ActionId::StateEase, this, [this] {
        goTo(Panel::Seams);
        seams_->editEase();
    });
}

void MainWindow::goTo(Panel panel) {
    const auto [dock, list] = [this, panel]() -> std::pair<QDockWidget*, QWidget*> {
        switch (panel) {
            case Panel::Pieces:
                return {piecesDock_, &pieces_->table()};
            case Panel::Seams:
                return {seamsDock_, &seams_->table()};
            case Panel::ProblemList:
                return {problemsDock_, &problems_->table()};
            case Panel::History:
                break;
        }
        return {historyDock_, history_};
    }();
    dock->show();
    dock->raise();
    list->setFocus();
}

void MainWindow::makeStatusBar() {
    hints_ = new HintLabel;
    hints_->setObjectName("toolHint");
    hints_->setContentsMargins(8, 0, 8, 0);
    hints_->setMinimumWidth(60);
    statusBar()->addWidget(hints_, 1);
    connect(tools_, &ToolBox::changed, this, &MainWindow::updateHint);
    connect(views_, &ViewArea::entered, this, [this](ViewKind view) {
        viewInUse_ = view;
        updateHint();
    });
    updateHint();

    summary_ = new QLabel;
    summary_->setObjectName("garmentSummary");
    summary_->setContentsMargins(8, 0, 8, 0);
    statusBar()->addPermanentWidget(summary_);
    statusBar()->addPermanentWidget(
        new WorkDisplay({&workspace_.jobs(), &workspace_.writing()}, actions_[ActionId::Cancel]));
}

void MainWindow::updateHint() {
    if (!workspace_.document().garment()) {
        hints_->setHint({});
        return;
    }
    hints_->setHint(QString("%1 · %2").arg(
        tools_->current().hint(viewInUse_),
        cameraHint(preferences_.navigation(), viewInUse_ == ViewKind::Pattern)));
}

void MainWindow::connectJobs() {
    for (JobRunner* jobs : {&workspace_.jobs(), &workspace_.writing()}) {
        connect(jobs, &JobRunner::failed, this, [this](const QString&, const QString& sentence) {
            banner_->showSentence(sentence);
        });
        connect(jobs, &JobRunner::cancelled, this, [this](const QString& title, bool replaced) {
            if (!replaced) {
                statusBar()->showMessage(tr("%1: cancelled").arg(title), kMessageMilliseconds);
            }
        });
    }
    ProjectSession& session = garmentActions_->project().session();
    connect(&session, &ProjectSession::changed, this, &MainWindow::updateTitle);
    connect(&session, &ProjectSession::noticed, banner_, &Banner::showSentence);
    connect(&session, &ProjectSession::saved, this, [this](const QString& path) {
        statusBar()->showMessage(tr("Saved: %1").arg(path), kMessageMilliseconds);
    });
}

void MainWindow::onChanged(DocumentChanges what) {
    if (what & (DocumentChange::Garment | DocumentChange::Seams)) {
        banner_->hide();  // what it says was about what is no more
    }
    if (what.testFlag(DocumentChange::Results) && summary_->text().isEmpty()) {
        updateSummary();  // a scene is here again
        askAboutGarment();
    }
    if (!what.testFlag(DocumentChange::Garment)) {
        return;
    }
    if (what.testFlag(DocumentChange::Opened)) {
        adaptToWeight();
    }
    showGarmentParts(workspace_.document().garment() != nullptr);
    updateTitle();
    updateSummary();
    askAboutGarment();
}

void MainWindow::adaptToWeight() {
    if (!workspace_.document().garment()) {
        return;
    }
    Eigen::Index triangles = 0;
    for (const auto& piece : workspace_.document().garment()->pieces) {
        triangles += piece->mesh.F.rows();
    }
    const bool light = triangles <= preferences_.autoFlattenTriangles();
    workspace_.setAutoFlatten(light);
    actions_[ActionId::AutoFlatten].setChecked(light);
    if (!light) {
        statusBar()->showMessage(tr("A heavy garment: edits are flattened when you ask for it, %1")
                                     .arg(actions_[ActionId::FlattenAgain].shortcut().toString(
                                         QKeySequence::NativeText)),
                                 kMessageMilliseconds);
    }
}

void MainWindow::updateSummary() {
    summary_->setText(garmentSummary(workspace_.document()));
    summary_->setToolTip(garmentReasons(workspace_.document()));
}

void MainWindow::askAboutGarment() {
    const bool kept = keptGuesses_ == workspace_.openPaths();
    card_->ask(kept ? GarmentQuestions{} : garmentQuestions(workspace_.document()));
}

void MainWindow::showGarmentParts(bool shown) {
    pages_->setCurrentIndex(shown ? 1 : 0);
    updateHint();
    // Only the first garment brings the docks in; one that the person has closed stays closed.
    const bool first = shown && !piecesDock_->toggleViewAction()->isEnabled();
    for (QDockWidget* dock : docks()) {
        dock->toggleViewAction()->setEnabled(shown);
        if (!shown) {
            dock->hide();
        }
    }
    if (first) {
        showDocks();
        // As the person left them, where known.
        restoreState(preferences_.windowState(), kLayoutVersion);
    }
}

void MainWindow::updateTitle() {
    const ProjectSession& session = garmentActions_->project().session();
    const QString garment = session.title();
    setWindowTitle(garment.isEmpty() ? tr("Toile") : tr("%1[*] – Toile").arg(garment));
    setWindowModified(session.isModified());
}

Recovery& MainWindow::keepRecoveryFiles(const QString& folder) {
    const auto wanted = [this] { return autosaveTimes(preferences_.autosaveMinutes()); };
    Recovery& recovery = startRecovery(folder, wanted());
    connect(&preferences_, &Preferences::autosaveMinutesChanged, &recovery,
            [&recovery, wanted] { recovery.autosave().setTimes(wanted()); });
    return recovery;
}

Recovery& MainWindow::keepRecoveryFiles(const QString& folder, const AutosaveTimes& times) {
    return startRecovery(folder, times);
}

Recovery& MainWindow::startRecovery(const QString& folder,
                                    const std::optional<AutosaveTimes>& times) {
    delete recovery_;
    recovery_ =
        new Recovery(workspace_, garmentActions_->project(), *recoveryCard_, folder, times, this);
    connect(&recovery_->autosave(), &Autosave::failed, this, [this](const QString& sentence) {
        statusBar()->showMessage(tr("Unsaved changes are not kept: %1").arg(sentence),
                                 kMessageMilliseconds);
    });
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
    // Out of sight at once: the worker may need a moment to notice.
    hide();
    workspace_.shutdown();
    event->accept();
}

bool MainWindow::mayClose() {
    // The answer may come after this, once the project is saved: then the window closes itself.
    enum class Answer { None, Now, Later };
    const auto answer = std::make_shared<Answer>(Answer::None);
    if (workspace_.writing().isBusy()) {
        workspace_.whenWritten([this] { close(); });  // where it fails there is something to read
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
    if (!openableFiles(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList files = openableFiles(*event->mimeData());
    if (files.isEmpty()) {
        return;
    }
    event->acceptProposedAction();
    openFiles(files);
}

}  // namespace toile
