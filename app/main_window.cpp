// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeView>
#include <QUrl>
#include <QVBoxLayout>

#include "app/actions/file_dialogs.h"
#include "app/actions/garment_actions.h"
#include "app/panels/garment_summary.h"
#include "app/panels/messages_panel.h"
#include "app/panels/pieces_panel.h"
#include "app/panels/seams_panel.h"
#include "app/panels/welcome_page.h"
#include "app/settings/preferences.h"
#include "app/views/view_area.h"
#include "app/widgets/banner.h"
#include "app/widgets/garment_card.h"

namespace toile {

namespace {

constexpr int kMessageMilliseconds = 6000;

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
      garmentActions_(new GarmentActions(actions_, workspace_, preferences, *this)) {
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
    connect(&workspace_.document(), &Document::changed, this, &MainWindow::onChanged);
    for (QAction* action : actions_.all()) {
        addAction(action);  // shortcuts work whichever menu is hidden
    }
    resize(QSize(1600, 1000).boundedTo(screen()->availableSize()));
    restoreGeometry(preferences_.windowGeometry());
    showGarmentParts(false);
    updateTitle();
}

MainWindow::~MainWindow() {
    // The panels and views look at the document until they are gone; it is a member, so they have
    // to go before it.
    workspace_.jobs().shutdown();
    for (QWidget* part :
         std::initializer_list<QWidget*>{piecesDock_, seamsDock_, messagesDock_, centralWidget()}) {
        delete part;
    }
}

void MainWindow::makeCentre() {
    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    banner_ = new Banner(centre);
    connect(garmentActions_, &GarmentActions::failed, banner_, &Banner::showSentence);
    card_ = new GarmentCard(centre);
    connect(card_, &GarmentCard::unitChosen, &workspace_, &Workspace::setUnit);
    connect(card_, &GarmentCard::upAxisChosen, &workspace_, &Workspace::setUpAxis);
    connect(card_, &GarmentCard::kept, this, [this] { keptGuesses_ = workspace_.openPaths(); });
    pages_ = new QStackedWidget(centre);
    auto* welcome = new WelcomePage(pages_);
    connect(welcome, &WelcomePage::openWanted, &actions_[ActionId::Open], &QAction::trigger);
    connect(welcome, &WelcomePage::sampleWanted, this,
            [this](const QString& path) { openFiles({path}); });
    views_ = new ViewArea(workspace_.document(), pages_);
    connect(&actions_[ActionId::Frame], &QAction::triggered, views_, &ViewArea::frameSelection);
    pages_->addWidget(welcome);
    pages_->addWidget(views_);
    layout->addWidget(banner_);
    layout->addWidget(card_);
    layout->addWidget(pages_, 1);
    setCentralWidget(centre);
}

void MainWindow::makeDocks() {
    pieces_ = new PiecesPanel(workspace_.document());
    seams_ = new SeamsPanel(workspace_.document());
    messages_ = new MessagesPanel(workspace_.document());
    piecesDock_ = makeDock(tr("Pieces"), "piecesDock", pieces_);
    seamsDock_ = makeDock(tr("Seams"), "seamsDock", seams_);
    messagesDock_ = makeDock(tr("Messages"), "messagesDock", messages_);
    tabifyDockWidget(piecesDock_, seamsDock_);
    tabifyDockWidget(seamsDock_, messagesDock_);
    piecesDock_->raise();
    resizeDocks({piecesDock_}, {215}, Qt::Vertical);
    connectPanels();
}

QDockWidget* MainWindow::makeDock(const QString& title, const char* name, QWidget* panel) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(panel);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    return dock;
}

void MainWindow::connectPanels() {
    connect(pieces_, &PiecesPanel::activated, views_, &ViewArea::frameSelection);
    connect(seams_, &SeamsPanel::activated, views_, &ViewArea::frameSeam);
    connect(seams_, &SeamsPanel::easeWanted, &workspace_, &Workspace::setEase);
    connect(seams_, &SeamsPanel::cutRemovalWanted, &workspace_, &Workspace::removeCut);
    connect(messages_, &MessagesPanel::countChanged, this, [this](int count) {
        messagesDock_->setWindowTitle(count == 0 ? tr("Messages") : tr("Messages (%1)").arg(count));
    });
    connect(&actions_[ActionId::GoToPieces], &QAction::triggered, this,
            [this] { goTo(Panel::Pieces); });
    connect(&actions_[ActionId::GoToSeams], &QAction::triggered, this,
            [this] { goTo(Panel::Seams); });
    connect(&actions_[ActionId::GoToMessages], &QAction::triggered, this,
            [this] { goTo(Panel::Messages); });
    connect(&actions_[ActionId::StateEase], &QAction::triggered, this, [this] {
        goTo(Panel::Seams);
        seams_->editEase();
    });
}

void MainWindow::goTo(Panel panel) {
    QDockWidget* dock = panel == Panel::Pieces  ? piecesDock_
                        : panel == Panel::Seams ? seamsDock_
                                                : messagesDock_;
    QWidget* list = panel == Panel::Pieces  ? static_cast<QWidget*>(&pieces_->table())
                    : panel == Panel::Seams ? static_cast<QWidget*>(&seams_->table())
                                            : messages_;
    dock->show();
    dock->raise();
    list->setFocus();
}

void MainWindow::makeStatusBar() {
    hints_ =
        new QLabel(tr("Drag: turn or move · Shift+drag: move · Wheel: zoom · Click: select · "
                      "Double click: frame a piece"));
    hints_->setContentsMargins(8, 0, 8, 0);
    hints_->setMinimumWidth(60);
    statusBar()->addWidget(hints_, 1);

    summary_ = new QLabel;
    summary_->setObjectName("garmentSummary");
    summary_->setContentsMargins(8, 0, 8, 0);
    statusBar()->addPermanentWidget(summary_);
    makeWorkDisplay();
}

void MainWindow::makeWorkDisplay() {
    work_ = new QWidget;
    auto* row = new QHBoxLayout(work_);
    row->setContentsMargins(0, 0, 0, 0);
    task_ = new QLabel;
    progress_ = new QProgressBar;
    progress_->setObjectName("progress");
    progress_->setRange(0, 1000);
    progress_->setFixedWidth(180);
    progress_->setTextVisible(false);
    auto* cancel = new QToolButton;
    cancel->setObjectName("cancelButton");
    cancel->setDefaultAction(&actions_[ActionId::Cancel]);
    cancel->setAutoRaise(true);
    row->addWidget(task_);
    row->addWidget(progress_);
    row->addWidget(cancel);
    statusBar()->addPermanentWidget(work_);
    work_->hide();
}

void MainWindow::connectJobs() {
    JobRunner& jobs = workspace_.jobs();
    connect(&jobs, &JobRunner::started, this, [this](const QString& title) {
        task_->setText(title);
        progress_->setValue(0);
        work_->show();
    });
    connect(&jobs, &JobRunner::progressed, this, [this](double fraction) {
        progress_->setValue(static_cast<int>(fraction * progress_->maximum()));
    });
    connect(&jobs, &JobRunner::idle, work_, &QWidget::hide);
    connect(&jobs, &JobRunner::failed, this,
            [this](const QString&, const QString& sentence) { banner_->showSentence(sentence); });
    connect(&jobs, &JobRunner::cancelled, this, [this](const QString& title) {
        if (!workspace_.jobs().hasWaiting()) {
            statusBar()->showMessage(tr("%1: cancelled").arg(title), kMessageMilliseconds);
        }
    });
    connect(&workspace_, &Workspace::exported, this, [this](const QString& path) {
        statusBar()->showMessage(tr("Written: %1").arg(path), kMessageMilliseconds);
    });
}

void MainWindow::onChanged(DocumentChanges what) {
    if (!what.testFlag(DocumentChange::Garment)) {
        return;
    }
    banner_->hide();
    showGarmentParts(workspace_.document().garment() != nullptr);
    updateTitle();
    updateSummary();
    askAboutGarment();
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
    hints_->setVisible(shown);
    // Only the first garment brings the docks in; one that the person has closed stays closed.
    const bool first = shown && !piecesDock_->toggleViewAction()->isEnabled();
    const auto docks = {piecesDock_, seamsDock_, messagesDock_};
    for (QDockWidget* dock : docks) {
        dock->toggleViewAction()->setEnabled(shown);
        if (!shown) {
            dock->hide();
        }
    }
    if (first) {
        for (QDockWidget* dock : docks) {
            dock->show();
        }
        piecesDock_->raise();
        restoreState(preferences_.windowState());  // as the person left them, where known
    }
}

void MainWindow::updateTitle() {
    const QString garment = workspace_.document().title();
    setWindowTitle(garment.isEmpty() ? tr("Toile") : tr("%1 – Toile").arg(garment));
}

void MainWindow::openFiles(const QStringList& files) {
    garmentActions_->openFiles(files);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    preferences_.setWindowGeometry(saveGeometry());
    if (workspace_.document().garment()) {
        preferences_.setWindowState(saveState());
    }
    // Out of sight at once: the worker may need a moment to notice.
    hide();
    workspace_.jobs().shutdown();
    event->accept();
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
