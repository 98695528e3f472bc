// SPDX-License-Identifier: GPL-3.0-or-later
// The window's menus, its toolbar and the box that says what Toile is.
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>
#include <QToolButton>

#include "app/main_window.h"
#include "app/widgets/icon.h"
#include "core/base/version.h"

namespace toile {

namespace {

void fill(const ActionRegistry& actions, QMenu& menu, std::initializer_list<ActionId> ids) {
    for (const ActionId id : ids) {
        menu.addAction(&actions[id]);
    }
}

}  // namespace

void MainWindow::makeMenus() {
    QMenu& file = *menuBar()->addMenu(tr("&File"));
    fill(actions_, file, {ActionId::Open});
    file.addSeparator();
    QMenu& exports = *file.addMenu(tr("&Export pattern"));
    exports.setObjectName("exportMenu");
    fill(actions_, exports,
         {ActionId::ExportSvg, ActionId::ExportDxf, ActionId::ExportObj, ActionId::ExportReport});
    file.addSeparator();
    fill(actions_, file, {ActionId::Quit});

    QMenu& edit = *menuBar()->addMenu(tr("&Edit"));
    fill(actions_, edit, {ActionId::SelectAll, ActionId::SelectNone});
    edit.addSeparator();
    fill(actions_, edit, {ActionId::StateEase, ActionId::ForgetEase});

    makeViewMenu();
    makeGarmentMenu();

    makeFlattenMenu();

    QMenu& help = *menuBar()->addMenu(tr("&Help"));
    fill(actions_, help, {ActionId::About});
    connect(&actions_[ActionId::About], &QAction::triggered, this, &MainWindow::showAbout);
    connect(&actions_[ActionId::Quit], &QAction::triggered, this, &QWidget::close);
}

void MainWindow::makeFlattenMenu() {
    QMenu& flatten = *menuBar()->addMenu(tr("F&latten"));
    flatten.setObjectName("flattenMenu");
    flatten.setContentsMargins(0, 4, 0, 0);  // a heading at the very top would touch the frame
    for (const bool keepsLengths : {true, false}) {
        flatten.addSection(keepsLengths ? tr("Seam lines keep their length")
                                        : tr("Seam lines may change"));
        for (const MethodTraits& method : allMethods()) {
            if (method.keepsLengths == keepsLengths) {
                flatten.addAction(&actions_[actionOf(method.method)]);
            }
        }
    }
    flatten.addSeparator();
    QMenu& quality = *flatten.addMenu(tr("&Quality"));
    quality.setObjectName("qualityMenu");
    fill(actions_, quality,
         {ActionId::QualityDraft, ActionId::QualityStandard, ActionId::QualityFine});
    const QAction& standard = actions_[ActionId::QualityStandard];
    connect(&standard, &QAction::enabledChanged, quality.menuAction(), &QAction::setEnabled);
    quality.menuAction()->setEnabled(standard.isEnabled());
    flatten.addSeparator();
    fill(actions_, flatten, {ActionId::SolverNewton, ActionId::SolverSlcp});
    flatten.addSeparator();
    fill(actions_, flatten, {ActionId::FlattenAgain, ActionId::Cancel});
}

void MainWindow::makeViewMenu() {
    QMenu& view = *menuBar()->addMenu(tr("&View"));
    fill(actions_, view,
         {ActionId::OverlayNone, ActionId::OverlayChecker, ActionId::OverlayArea,
          ActionId::OverlayAngle, ActionId::OverlayStrain});
    view.addSeparator();
    fill(actions_, view, {ActionId::Wireframe, ActionId::DesignerOutline, ActionId::Frame});
    view.addSeparator();
    fill(actions_, view, {ActionId::GoToPieces, ActionId::GoToSeams, ActionId::GoToMessages});
    QMenu& lists = *view.addMenu(tr("Sh&ow"));
    for (QDockWidget* dock : {piecesDock_, seamsDock_, messagesDock_}) {
        lists.addAction(dock->toggleViewAction());
    }
}

void MainWindow::makeGarmentMenu() {
    QMenu& garment = *menuBar()->addMenu(tr("&Garment"));
    fill(actions_, garment, {ActionId::Reload});
    garment.addSeparator();
    fill(actions_, *garment.addMenu(tr("&Unit")),
         {ActionId::UnitAuto, ActionId::UnitMillimetre, ActionId::UnitCentimetre,
          ActionId::UnitMetre, ActionId::UnitInch});
    fill(actions_, *garment.addMenu(tr("Up &axis")),
         {ActionId::UpAuto, ActionId::UpY, ActionId::UpZ});
    fill(
        actions_, *garment.addMenu(tr("&Divide by")),
        {ActionId::SplitAuto, ActionId::SplitComponents, ActionId::SplitObjects,
         ActionId::SplitGroups, ActionId::SplitMaterials, ActionId::SplitUv, ActionId::SplitSeams});
    garment.addSeparator();
    fill(actions_, garment, {ActionId::AutoCut, ActionId::Weld});
    garment.addSeparator();
    fill(actions_, garment, {ActionId::SeamsFromFile, ActionId::SeamsToFile});
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

}  // namespace toile
