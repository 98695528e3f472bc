// SPDX-License-Identifier: GPL-3.0-or-later
// What the window offers beside its own work: commands, the comparison of methods, help,
// preferences, its layout.
#include <QDockWidget>
#include <QMessageBox>

#include "app/actions/command_list.h"
#include "app/compare/compare_window.h"
#include "app/main_window.h"
#include "app/panels/help_page.h"
#include "app/panels/preferences_dialog.h"
#include "app/render/render_style.h"
#include "app/settings/length_display.h"
#include "app/settings/preferences.h"
#include "app/settings/theme.h"
#include "app/views/view_area.h"
#include "app/widgets/command_palette.h"
#include "core/base/version.h"

namespace toile {

void MainWindow::connectShell() {
    palette_ = new CommandPalette(this);
    actions_.on(ActionId::CommandPalette, this, &MainWindow::showCommands);
    actions_.on(ActionId::EditPreferences, this, &MainWindow::editPreferences);
    actions_.on(ActionId::Shortcuts, this, &MainWindow::showHelp);
    actions_.on(ActionId::ResetLayout, this, &MainWindow::resetLayout);
    actions_.on(ActionId::About, this, &MainWindow::showAbout);
    actions_.on(ActionId::CompareMethods, this, &MainWindow::compareMethods);
    actions_.on(ActionId::Quit, this, &QWidget::close);
    connect(&preferences_, &Preferences::lengthUnitChanged, this, &MainWindow::followLengthUnit);
    connect(&preferences_, &Preferences::themeChanged, this,
            [this] { applyTheme(preferences_.theme()); });
    connect(&preferences_, &Preferences::coloursChanged, this, &MainWindow::followColours);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, [this] {
        updateSummary();
        askAboutGarment();
        views_->repaintViews();  // the scale bar
    });
    connect(&preferences_, &Preferences::navigationChanged, this, [this] {
        views_->setNavigation(preferences_.navigation());
        updateHint();
    });
    connect(&preferences_, &Preferences::autoFlattenTrianglesChanged, this,
            &MainWindow::adaptToWeight);
    views_->setNavigation(preferences_.navigation());
    followLengthUnit();
    followColours();
}

void MainWindow::showCommands() {
    palette_->open(commandList(
        actions_, workspace_.document(),
        [this](int piece) {
            workspace_.document().setSelection({piece});
            views_->frameSelection();
        },
        [this](int seam) {
            workspace_.document().setSeam(seam);
            views_->frameSeam();
        }));
}

void MainWindow::compareMethods() {
    if (!compare_) {
        compare_ = new CompareWindow(workspace_.document(), workspace_.jobs(), this);
        connect(compare_, &CompareWindow::methodWanted, &workspace_, &Workspace::setMethod);
        // "Use this method" is taken back where it was done.
        compare_->addActions({&actions_[ActionId::Undo], &actions_[ActionId::Redo]});
    }
    compare_->show();
    compare_->raise();
    compare_->activateWindow();
}

void MainWindow::editPreferences() {
    auto* dialog = new PreferencesDialog(preferences_, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::showHelp() {
    auto* page = findChild<HelpPage*>();
    if (!page) {
        page = new HelpPage(helpGroups(actions_, QKeySequence::NativeText), this);
        page->setAttribute(Qt::WA_DeleteOnClose);
    }
    page->show();
    page->raise();
    page->activateWindow();
}

void MainWindow::resetLayout() {
    // Hidden while they move: docks that are seen leave an empty tab bar over the new one.
    for (QDockWidget* dock : docks()) {
        dock->setFloating(false);
        dock->hide();
    }
    arrangeDocks();
    if (workspace_.document().garment()) {
        showDocks();
    }
}

void MainWindow::followLengthUnit() {
    const Choices& choices = preferences_.choices();
    LengthDisplay::instance().choose(
        choices.lengthUnit, choices.lengthUnit == LengthUnit::Inch ? choices.inchDenominator : 0);
}

void MainWindow::followColours() {
    setMarkColours(preferences_.choices().selectionColour, preferences_.choices().seamColour);
    views_->repaintViews();
}

void MainWindow::showAbout() {
    auto* box = new QMessageBox(this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About Toile"));
    box->setIconPixmap(QIcon(":/icons/toile.svg").pixmap(64, 64));
    box->setText(QString("<h3>Toile %1</h3>").arg(QString::fromUtf8(version())));
    box->setInformativeText(
        tr("Sewing patterns from 3D garments, every seam line at its true length: the "
           "length-preserved natural boundary of Wang (2005).\n\nFree software under the GNU "
           "General Public License, version 3 or later."));
    box->open();
}

}  // namespace toile
