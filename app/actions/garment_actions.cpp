// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/garment_actions.h"

#include <QAction>
#include <QFileInfo>
#include <QWidget>
#include <utility>

#include "app/actions/layout_actions.h"
#include "app/actions/project_actions.h"
#include "app/actions/reading_actions.h"
#include "app/actions/workspace.h"
#include "app/base/path_text.h"
#include "app/render/scene.h"
#include "app/settings/preferences.h"
#include "app/text/error_text.h"
#include "core/project/project_file.h"

namespace toile {

namespace {

constexpr std::pair<ActionId, Overlay> kOverlays[] = {
    {ActionId::OverlayNone, Overlay::None},
    {ActionId::OverlayChecker, Overlay::Checker},
    {ActionId::OverlayArea, Overlay::Area},
    {ActionId::OverlayAngle, Overlay::Angle},
    {ActionId::OverlayStrain, Overlay::Strain},
    {ActionId::OverlayWarp, Overlay::Warp},
    {ActionId::OverlayWeft, Overlay::Weft},
    {ActionId::OverlayBias, Overlay::Bias},
    {ActionId::OverlayPrincipal, Overlay::Principal},
    {ActionId::OverlayDirichlet, Overlay::Dirichlet},
};

constexpr std::pair<ActionId, bool ViewState::*> kSwitches[] = {
    {ActionId::Wireframe, &ViewState::wireframe},
    {ActionId::DesignerOutline, &ViewState::designerOutline},
    {ActionId::ValuesPerTriangle, &ViewState::valuesPerTriangle},
    {ActionId::WorstSpots, &ViewState::worstSpots},
    {ActionId::ShowSeams, &ViewState::seams},
    {ActionId::Xray, &ViewState::xray},
    {ActionId::Shaded, &ViewState::shaded},
    {ActionId::PieceColours, &ViewState::pieceColours},
    {ActionId::Rulers, &ViewState::rulers},
    {ActionId::Grid, &ViewState::grid},
    {ActionId::Snapping, &ViewState::snapping},
};

constexpr std::pair<ActionId, Quality> kQualities[] = {
    {ActionId::QualityDraft, Quality::Draft},
    {ActionId::QualityStandard, Quality::Standard},
    {ActionId::QualityFine, Quality::Fine},
};

}  // namespace

GarmentActions::GarmentActions(ActionRegistry& actions, Workspace& workspace,
                               Preferences& preferences, QWidget& window)
    : actions_(actions),
      workspace_(workspace),
      preferences_(preferences),
      window_(window),
      project_(new ProjectActions(actions, workspace, preferences, dialogs_, window, this)) {
    connect(project_, &ProjectActions::failed, this, &GarmentActions::failed);
    connect(&project_->recent(), &RecentFiles::wanted, this, &GarmentActions::openFiles);
    connectFiles();
    connectHistory();
    connectSelection();
    connectView();
    connectFlattening();
    connectSeams();
    connectReading(actions, workspace);
    connect(new LayoutActions(actions, workspace, this), &LayoutActions::failed, this,
            &GarmentActions::failed);
    connect(&workspace_.document(), &Document::changed, this, &GarmentActions::onChanged);
    for (const JobRunner* jobs : {&workspace_.jobs(), &workspace_.writing()}) {
        connect(jobs, &JobRunner::started, this, &GarmentActions::updateEnabled);
        connect(jobs, &JobRunner::idle, this, &GarmentActions::updateEnabled);
    }
    onChanged(DocumentChange::View | DocumentChange::Options | DocumentChange::Garment);
}

void GarmentActions::connectFiles() {
    actions_.on(ActionId::Open, this, &GarmentActions::askAndOpen);
    actions_.on(ActionId::ExportSvg, this,
                [this] { askAndExport("svg", tr("SVG drawing (*.svg)")); });
    actions_.on(ActionId::ExportDxf, this,
                [this] { askAndExport("dxf", tr("DXF drawing (*.dxf)")); });
    actions_.on(ActionId::ExportObj, this, [this] { askAndExport("obj", tr("OBJ mesh (*.obj)")); });
    actions_.on(ActionId::ExportReport, this,
                [this] { askAndExport("json", tr("JSON report (*.json)")); });
}

void GarmentActions::connectHistory() {
    QUndoStack& history = workspace_.document().history();
    actions_.on(ActionId::Undo, &history, &QUndoStack::undo);
    actions_.on(ActionId::Redo, &history, &QUndoStack::redo);
    connect(&history, &QUndoStack::indexChanged, this, &GarmentActions::updateHistory);
    updateHistory();
}

void GarmentActions::updateHistory() {
    const QUndoStack& history = workspace_.document().history();
    QAction& undo = actions_[ActionId::Undo];
    QAction& redo = actions_[ActionId::Redo];
    undo.setEnabled(history.canUndo());
    redo.setEnabled(history.canRedo());
    undo.setText(history.canUndo() ? tr("&Undo: %1").arg(history.undoText()) : tr("&Undo"));
    redo.setText(history.canRedo() ? tr("&Redo: %1").arg(history.redoText()) : tr("&Redo"));
}

void GarmentActions::connectSelection() {
    actions_.on(ActionId::SelectAll, this,
                [this] { workspace_.document().setSelection(workspace_.document().everyPiece()); });
    actions_.on(ActionId::SelectNone, this, [this] {
        workspace_.document().setSelection({});
        workspace_.document().setSeam({});
        workspace_.document().setMark({});
    });
}

void GarmentActions::connectView() {
    for (const auto& [id, overlay] : kOverlays) {
        actions_.on(id, this,
                    [this, overlay = overlay] { workspace_.document().setOverlay(overlay); });
    }
    for (const auto& [id, field] : kSwitches) {
        connect(&actions_[id], &QAction::toggled, this,
                [this, field = field](bool on) { workspace_.document().setView(field, on); });
    }
}

void GarmentActions::connectFlattening() {
    for (const MethodTraits& known : allMethods()) {
        actions_.on(actionOf(known.method), this,
                    [this, method = known.method] { workspace_.setMethod(method); });
    }
    for (const auto& [id, quality] : kQualities) {
        actions_.on(id, this, [this, quality = quality] { workspace_.setQuality(quality); });
    }
    actions_.on(ActionId::SolverNewton, this,
                [this] { workspace_.setBoundarySolver(BoundarySolver::Newton); });
    actions_.on(ActionId::SolverSlcp, this,
                [this] { workspace_.setBoundarySolver(BoundarySolver::Slcp); });
    actions_.on(ActionId::FlattenAgain, this, [this] { workspace_.flattenAgain(); });
    actions_.on(ActionId::AutoFlatten, &workspace_, &Workspace::setAutoFlatten);
    actions_[ActionId::AutoFlatten].setChecked(workspace_.autoFlatten());
    actions_.on(ActionId::Cancel, &workspace_, &Workspace::cancel);
}

void GarmentActions::connectSeams() {
    actions_.on(ActionId::SeamsFromFile, this, &GarmentActions::askAndReadSeams);
    actions_.on(ActionId::SeamsToFile, this, &GarmentActions::askAndWriteSeams);
    actions_.on(ActionId::ForgetEase, this, [this] {
        if (const auto seam = workspace_.document().seam()) {
            workspace_.setEase(*seam, std::nullopt);
        }
    });
}

void GarmentActions::askAndOpen() {
    openFiles(dialogs_.open(&window_, preferences_.openFolder()));
}

void GarmentActions::openFiles(const QStringList& files) {
    if (files.isEmpty()) {
        return;
    }
    project_->leaveThen([this, files] { openNow(files); });
}

void GarmentActions::openNow(const QStringList& files) {
    preferences_.setOpenFolder(QFileInfo(files.front()).absolutePath());
    Workspace::Paths paths;
    bool anyProject = false;
    for (const QString& file : files) {
        paths.emplace_back(pathOf(file));
        anyProject = anyProject || isProjectFile(paths.back());
    }
    if (!anyProject) {
        workspace_.open(std::move(paths));
    } else if (files.size() == 1) {
        project_->open(files.front());
    } else {
        emit failed(
            tr("A project is opened by itself: choose one project, or the meshes of one "
               "garment."));
    }
}

void GarmentActions::askAndReadSeams() {
    const QString path = dialogs_.openSeams(&window_, preferences_.openFolder());
    if (path.isEmpty()) {
        return;
    }
    const auto read = workspace_.readSeams(pathOf(path));
    for (const Error& said : read ? *read : Problems{read.error()}) {
        emit failed(errorText(said));
    }
}

void GarmentActions::askAndWriteSeams() {
    const auto& source = workspace_.document().garment()->files.front()->path;
    const QFileInfo first(textOf(source));
    const QString path = dialogs_.save(
        &window_, QString("%1/%2.seams.json").arg(first.absolutePath(), first.completeBaseName()),
        tr("Seams files (*.json)"));
    if (path.isEmpty()) {
        return;
    }
    const auto written = workspace_.writeSeams(pathOf(path));
    if (!written) {
        emit failed(errorText(written.error()));
    }
}

void GarmentActions::askAndExport(const QString& suffix, const QString& filter) {
    if (!workspace_.canExport()) {
        return;
    }
    const auto& source = workspace_.document().garment()->files.front()->path;
    const QFileInfo first(textOf(source));
    const QString remembered = preferences_.exportFolder();
    const QString folder = remembered.isEmpty() ? first.absolutePath() : remembered;
    // "-pattern" keeps an OBJ export from proposing to replace the garment itself.
    const QString name = tr("%1-pattern").arg(first.completeBaseName());
    QString path = dialogs_.save(&window_, QString("%1/%2.%3").arg(folder, name, suffix), filter);
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().compare(suffix, Qt::CaseInsensitive) != 0) {
        path += '.' + suffix;
    }
    preferences_.setExportFolder(QFileInfo(path).absolutePath());
    workspace_.exportTo(pathOf(path));
}

void GarmentActions::onChanged(DocumentChanges what) {
    const Document& document = workspace_.document();
    if (what.testFlag(DocumentChange::View)) {
        for (const auto& [id, overlay] : kOverlays) {
            actions_[id].setChecked(document.view().overlay == overlay);
        }
        for (const auto& [id, field] : kSwitches) {
            actions_[id].setChecked(document.view().*field);
        }
    }
    if (what.testFlag(DocumentChange::Options)) {
        const FlattenOptions& options = document.options();
        for (const MethodTraits& known : allMethods()) {
            actions_[actionOf(known.method)].setChecked(options.method == known.method);
        }
        for (const auto& [id, quality] : kQualities) {
            actions_[id].setChecked(options.quality == quality);
        }
        actions_[ActionId::SolverNewton].setChecked(options.boundarySolver ==
                                                    BoundarySolver::Newton);
        actions_[ActionId::SolverSlcp].setChecked(options.boundarySolver == BoundarySolver::Slcp);
    }
    updateEnabled();
}

void GarmentActions::updateEnabled() {
    const Document& document = workspace_.document();
    const bool open = document.garment() != nullptr;
    const bool constrained = traits(document.options().method).solvesBoundary;
    for (const ActionId id :
         {ActionId::SelectAll,    ActionId::SelectNone,     ActionId::Frame,
          ActionId::ToolSelect,   ActionId::ToolCut,        ActionId::ToolLoop,
          ActionId::ToolDart,     ActionId::ToolJoin,       ActionId::ToolMeasure,
          ActionId::FlattenAgain, ActionId::Wireframe,      ActionId::GoToPieces,
          ActionId::GoToSeams,    ActionId::GoToProblems,   ActionId::ReadyToCut,
          ActionId::GoToHistory,  ActionId::CompareMethods, ActionId::ShowSeams,
          ActionId::Xray,         ActionId::Shaded,         ActionId::PieceColours,
          ActionId::LookFront,    ActionId::LookBack,       ActionId::LookRight,
          ActionId::LookLeft,     ActionId::LookTop,        ActionId::LookBottom,
          ActionId::Orthographic, ActionId::PlayMorph}) {
        actions_[id].setEnabled(open);
    }
    for (const auto& [id, overlay] : kOverlays) {
        actions_[id].setEnabled(open);
    }
    const bool measured = open && isMeasured(document.view().overlay);
    actions_[ActionId::ValuesPerTriangle].setEnabled(measured);
    actions_[ActionId::WorstSpots].setEnabled(measured);
    for (const ActionId id :
         {ActionId::ExportSvg, ActionId::ExportDxf, ActionId::ExportObj, ActionId::ExportReport}) {
        actions_[id].setEnabled(workspace_.canExport());
    }
    const bool hasDesigner =
        document.scene() && !document.scene()->patternLines.runs.designer.empty();
    actions_[ActionId::DesignerOutline].setEnabled(hasDesigner);
    const Seam* seam =
        document.seam() ? &document.garment()->seams.seams[std::size_t(*document.seam())] : nullptr;
    actions_[ActionId::StateEase].setEnabled(seam && seam->kind != SeamKind::Free);
    actions_[ActionId::ForgetEase].setEnabled(seam && seam->ease);
    for (const auto& [id, quality] : kQualities) {
        actions_[id].setEnabled(document.options().method == Method::Isometric);
    }
    // A free outline has no boundary problem to solve.
    actions_[ActionId::SolverNewton].setEnabled(constrained);
    actions_[ActionId::SolverSlcp].setEnabled(constrained);
    actions_[ActionId::Cancel].setEnabled(workspace_.jobs().isBusy() ||
                                          workspace_.writing().isBusy());
}

}  // namespace toile
