// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "app/actions/file_dialogs.h"
#include "app/actions/garment_actions.h"
#include "app/panels/messages_panel.h"
#include "app/panels/pieces_panel.h"
#include "app/panels/welcome_page.h"
#include "app/settings/preferences.h"
#include "app/views/view_area.h"
#include "app/widgets/banner.h"
#include "app/widgets/icon.h"
#include "core/base/version.h"

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
         std::initializer_list<QWidget*>{piecesDock_, messagesDock_, centralWidget()}) {
        delete part;
    }
}

void MainWindow::makeCentre() {
    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    banner_ = new Banner(centre);
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
    layout->addWidget(pages_, 1);
    setCentralWidget(centre);
}

void MainWindow::makeDocks() {
    auto* pieces = new PiecesPanel(workspace_.document());
    connect(pieces, &PiecesPanel::activated, views_, &ViewArea::frameSelection);
    piecesDock_ = new QDockWidget(tr("Pieces"), this);
    piecesDock_->setObjectName("piecesDock");
    piecesDock_->setWidget(pieces);
    addDockWidget(Qt::BottomDockWidgetArea, piecesDock_);

    auto* messages = new MessagesPanel(workspace_.document());
    messagesDock_ = new QDockWidget(tr("Messages"), this);
    messagesDock_->setObjectName("messagesDock");
    messagesDock_->setWidget(messages);
    addDockWidget(Qt::BottomDockWidgetArea, messagesDock_);
    connect(messages, &MessagesPanel::countChanged, this, [this](int count) {
        messagesDock_->setWindowTitle(count == 0 ? tr("Messages") : tr("Messages (%1)").arg(count));
    });
    tabifyDockWidget(piecesDock_, messagesDock_);
    piecesDock_->raise();
    resizeDocks({piecesDock_}, {190}, Qt::Vertical);
}

void MainWindow::makeMenus() {
    const auto fill = [this](QMenu& menu, std::initializer_list<ActionId> ids) {
        for (const ActionId id : ids) {
            menu.addAction(&actions_[id]);
        }
    };
    QMenu& file = *menuBar()->addMenu(tr("&File"));
    fill(file, {ActionId::Open});
    QMenu& unit = *file.addMenu(tr("&Unit of the file"));
    fill(unit, {ActionId::UnitAuto, ActionId::UnitMillimetre, ActionId::UnitCentimetre,
                ActionId::UnitMetre, ActionId::UnitInch});
    file.addSeparator();
    QMenu& exports = *file.addMenu(tr("&Export pattern"));
    exports.setObjectName("exportMenu");
    fill(exports,
         {ActionId::ExportSvg, ActionId::ExportDxf, ActionId::ExportObj, ActionId::ExportReport});
    file.addSeparator();
    fill(file, {ActionId::Quit});

    QMenu& edit = *menuBar()->addMenu(tr("&Edit"));
    fill(edit, {ActionId::SelectAll, ActionId::SelectNone});

    QMenu& view = *menuBar()->addMenu(tr("&View"));
    fill(view, {ActionId::OverlayNone, ActionId::OverlayChecker, ActionId::OverlayArea,
                ActionId::OverlayAngle, ActionId::OverlayStrain});
    view.addSeparator();
    fill(view, {ActionId::Wireframe, ActionId::Frame});
    view.addSeparator();
    view.addAction(piecesDock_->toggleViewAction());
    view.addAction(messagesDock_->toggleViewAction());

    QMenu& flatten = *menuBar()->addMenu(tr("F&latten"));
    fill(flatten, {ActionId::MethodWang2005, ActionId::MethodNatural});
    flatten.addSeparator();
    fill(flatten, {ActionId::SolverNewton, ActionId::SolverSlcp});
    flatten.addSeparator();
    fill(flatten, {ActionId::FlattenAgain, ActionId::Cancel});

    QMenu& help = *menuBar()->addMenu(tr("&Help"));
    fill(help, {ActionId::About});
    connect(&actions_[ActionId::About], &QAction::triggered, this, &MainWindow::showAbout);
    connect(&actions_[ActionId::Quit], &QAction::triggered, this, &QWidget::close);
}

void MainWindow::makeToolBar() {
    QToolBar& bar = *addToolBar(tr("Tools"));
    bar.setObjectName("toolBar");
    bar.setMovable(false);
    bar.setIconSize({20, 20});
    bar.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar.addAction(&actions_[ActionId::Open]);
    auto* exports = new QToolButton(&bar);
    exports->setText(tr("Export"));
    exports->setIcon(themedIcon("export"));
    exports->setToolTip(tr("Write the pattern to a file"));
    exports->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    exports->setPopupMode(QToolButton::InstantPopup);
    exports->setMenu(menuBar()->findChild<QMenu*>("exportMenu"));
    const QAction& exportAction = actions_[ActionId::ExportSvg];
    connect(&exportAction, &QAction::enabledChanged, exports, &QWidget::setEnabled);
    exports->setEnabled(exportAction.isEnabled());
    bar.addWidget(exports);
    bar.addSeparator();
    bar.addAction(&actions_[ActionId::FlattenAgain]);
    bar.addAction(&actions_[ActionId::Frame]);
    bar.addSeparator();
    for (const ActionId id :
         {ActionId::OverlayNone, ActionId::OverlayChecker, ActionId::OverlayArea,
          ActionId::OverlayAngle, ActionId::OverlayStrain}) {
        bar.addAction(&actions_[id]);
    }
    bar.addSeparator();
    bar.addAction(&actions_[ActionId::Wireframe]);
}

void MainWindow::makeStatusBar() {
    hints_ =
        new QLabel(tr("Drag: turn or move · Shift+drag: move · Wheel: zoom · Click: select · "
                      "Double click: frame a piece"));
    hints_->setContentsMargins(8, 0, 8, 0);
    hints_->setMinimumWidth(60);
    statusBar()->addWidget(hints_, 1);

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
}

void MainWindow::showGarmentParts(bool shown) {
    pages_->setCurrentIndex(shown ? 1 : 0);
    hints_->setVisible(shown);
    // Only the first garment brings the docks in; one that the person has closed stays closed.
    const bool first = shown && !piecesDock_->toggleViewAction()->isEnabled();
    for (QDockWidget* dock : {piecesDock_, messagesDock_}) {
        dock->toggleViewAction()->setEnabled(shown);
        if (!shown) {
            dock->hide();
        }
    }
    if (first) {
        piecesDock_->show();
        messagesDock_->show();
        piecesDock_->raise();
        restoreState(preferences_.windowState());  // as the person left them, where known
    }
}

void MainWindow::updateTitle() {
    const QString garment = workspace_.document().title();
    setWindowTitle(garment.isEmpty() ? tr("Toile") : tr("%1 – Toile").arg(garment));
}

void MainWindow::showAbout() {
    const std::string_view number = version();
    auto* box = new QMessageBox(this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About Toile"));
    box->setIconPixmap(QIcon(":/icons/toile.svg").pixmap(64, 64));
    box->setText(QString("<h3>Toile %1</h3>")
                     .arg(QString::fromUtf8(number.data(), static_cast<qsizetype>(number.size()))));
    box->setInformativeText(
        tr("Sewing patterns from 3D garments, every seam line at its true length: the "
           "length-preserved natural boundary of Wang (2005).\n\nFree software under the GNU "
           "General Public License, version 3 or later."));
    box->open();
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
