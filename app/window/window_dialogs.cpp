// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_dialogs.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QSysInfo>

#include "app/actions/action_registry.h"
#include "app/actions/help_table.h"
#include "app/actions/own_folders.h"
#include "app/compare/compare_window.h"
#include "app/marker/marker_window.h"
#include "app/panels/help_pages.h"
#include "app/panels/leave_out_dialog.h"
#include "app/panels/preferences_dialog.h"
#include "app/panels/proposals_form.h"
#include "app/panels/scan_form.h"
#include "app/render/gl_support.h"
#include "app/session/cut_proposals.h"
#include "app/session/workspace.h"
#include "app/views/view_area.h"
#include "core/base/version.h"

namespace toile::app {

WindowDialogs::WindowDialogs(QWidget& window, Workspace& workspace, const ActionRegistry& actions,
                             ViewArea& views, Preferences& preferences, FileDialogs& files)
    : window_(window),
      workspace_(workspace),
      actions_(actions),
      views_(views),
      preferences_(preferences),
      files_(files),
      palette_(&window) {
    actions_.on(ActionId::CommandPalette, this, &WindowDialogs::showCommands);
    actions_.on(ActionId::EditPreferences, this, &WindowDialogs::editPreferences);
    actions_.on(ActionId::Shortcuts, this, &WindowDialogs::showHelp);
    actions_.on(ActionId::FirstSteps, this, [this] { showPage("first-steps.md"); });
    actions_.on(ActionId::Documentation, this, [this] { showPage("README.md"); });
    actions_.on(ActionId::ReportProblem, this, &WindowDialogs::reportProblem);
    actions_.on(ActionId::About, this, &WindowDialogs::showAbout);
    actions_.on(ActionId::LeaveOutSmall, this, &WindowDialogs::askWhatIsSmall);
    actions_.on(ActionId::ReadScan, this, &WindowDialogs::prepareScan);
    connect(&workspace_.proposals(), &CutProposals::opened, this, &WindowDialogs::showProposals);
    actions_.on(ActionId::CompareMethods, this, &WindowDialogs::compareMethods);
    actions_.on(ActionId::LayOnCloth, this, &WindowDialogs::layOnCloth);
}

WindowDialogs::~WindowDialogs() {
    delete marker_;  // they use the document until their end
    delete compare_;
    delete window_.findChild<ScanForm*>();
    qDeleteAll(window_.findChildren<ProposalsForm*>());
}

void WindowDialogs::showCommands() {
    palette_.open(commandList(
        actions_, workspace_.document(),
        [this](int piece) {
            workspace_.document().setSelection({piece});
            views_.frameSelection();
        },
        [this](int seam) {
            workspace_.document().setSeam(seam);
            views_.frameSeam();
        }));
}

void WindowDialogs::compareMethods() {
    if (!compare_) {
        compare_ = new CompareWindow(workspace_.document(), workspace_.jobs(), &window_);
        connect(compare_, &CompareWindow::methodWanted, &workspace_, &Workspace::setMethod);
        // Undo of "Use this method" must work in this window, too.
        compare_->addActions({&actions_[ActionId::Undo], &actions_[ActionId::Redo]});
    }
    compare_->show();
    compare_->raise();
    compare_->activateWindow();
}

void WindowDialogs::layOnCloth() {
    if (!marker_) {
        marker_ = new MarkerWindow(workspace_, preferences_, files_, &window_);
        // Undo must work in this window, too.
        marker_->addActions({&actions_[ActionId::Undo], &actions_[ActionId::Redo]});
    }
    marker_->show();
    marker_->raise();
    marker_->activateWindow();
}

void WindowDialogs::editPreferences() {
    auto* dialog = new PreferencesDialog(preferences_, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void WindowDialogs::askWhatIsSmall() {
    auto* dialog = new LeaveOutDialog(workspace_.document(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void WindowDialogs::prepareScan() {
    auto* form = window_.findChild<ScanForm*>();
    if (!form || !form->isVisible()) {  // a closed one is being deleted
        form = new ScanForm(workspace_, &window_);
        form->setAttribute(Qt::WA_DeleteOnClose);
        form->adjustSize();
        placeBeside(*form);
    }
    form->show();
    form->raise();
    form->activateWindow();
}

void WindowDialogs::showProposals() {
    auto* form = window_.findChild<ProposalsForm*>();
    if (!form || !form->isVisible()) {
        form = new ProposalsForm(workspace_.proposals(), &window_);
        form->setAttribute(Qt::WA_DeleteOnClose);
        // Undo of moved handles and new cuts must work in this form, too.
        form->addActions({&actions_[ActionId::Undo], &actions_[ActionId::Redo]});
        placeBeside(*form);
    }
    form->show();
    form->raise();
    form->activateWindow();
}

void WindowDialogs::placeBeside(QWidget& form) const {
    constexpr int kAir = 24, kBelowBar = 88;
    form.move(views_.mapToGlobal(QPoint(views_.width() - form.width() - kAir, kBelowBar)));
}

void WindowDialogs::showHelp() {
    auto* page = window_.findChild<HelpPage*>();
    if (!page) {
        page = new HelpPage(helpGroups(actions_, QKeySequence::NativeText), &window_);
        page->setAttribute(Qt::WA_DeleteOnClose);
    }
    page->show();
    page->raise();
    page->activateWindow();
}

void WindowDialogs::showPage(const QString& name) {
    const QString path = documentationPage(name);
    if (path.isEmpty()) {
        auto* box = new QMessageBox(
            QMessageBox::Information, tr("Documentation"),
            tr("The documentation is not installed with the program. See Help > Keyboard and "
               "mouse, or hold the pointer over a control for its tool tip."),
            QMessageBox::Ok, &window_);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
        return;
    }
    auto* page = window_.findChild<DocumentPage*>();
    if (!page) {
        page = new DocumentPage(&window_);
        page->setAttribute(Qt::WA_DeleteOnClose);
    }
    page->read(path);
    page->show();
    page->raise();
    page->activateWindow();
}

void WindowDialogs::reportProblem() {
    // Not translated, because developers read it.
    const QString facts =
        QString("Toile %1\nQt %2 (%3)\nOpenGL %4\n%5, %6")
            .arg(QString::fromUtf8(version()), QString::fromUtf8(qVersion()),
                 QGuiApplication::platformName(), glDescription(), QSysInfo::prettyProductName(),
                 QSysInfo::currentCpuArchitecture());
    auto* box = new QMessageBox(&window_);
    box->setObjectName("reportProblem");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("Report a problem"));
    box->setText(
        tr("Describe what you did, what you expected and what happened instead. Add these lines "
           "and, if you can, the garment's file."));
    box->setInformativeText(facts);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* copy = box->addButton(tr("&Copy"), QMessageBox::AcceptRole);
    box->addButton(QMessageBox::Close);
    connect(copy, &QPushButton::clicked, box,
            [facts] { QGuiApplication::clipboard()->setText(facts); });
    box->open();
}

void WindowDialogs::showAbout() {
    auto* box = new QMessageBox(&window_);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About Toile"));
    box->setIconPixmap(QIcon(":/icons/toile.svg").pixmap(64, 64));
    box->setText(QString("<h3>Toile %1</h3>").arg(QString::fromUtf8(version())));
    box->setInformativeText(
        tr("Sewing patterns from 3D garments, with every seam line at its true length. Method: "
           "length-preserved natural boundary, Wang (2005).\n\nFree software under the GNU General "
           "Public License, version 3 or later."));
    box->open();
}

}  // namespace toile::app
