// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_docks.h"

#include <QCursor>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QTreeView>
#include <QUndoView>
#include <algorithm>
#include <iterator>

#include "app/actions/action_registry.h"
#include "app/document/shown_proof.h"
#include "app/panels/fabric_panel.h"
#include "app/panels/lines_panel.h"
#include "app/panels/pieces_panel.h"
#include "app/panels/problems_panel.h"
#include "app/panels/proof_form.h"
#include "app/panels/proof_panel.h"
#include "app/panels/seams_panel.h"
#include "app/panels/selection_panel.h"
#include "app/panels/symmetry_panel.h"
#include "app/render/piece_values.h"
#include "app/render/scene.h"
#include "app/session/pattern_proof.h"
#include "app/session/workspace.h"
#include "app/settings/preferences.h"
#include "app/views/pattern_view.h"
#include "app/views/view_area.h"
#include "app/widgets/columns_model.h"
#include "app/widgets/scrolled.h"

namespace toile::app {

namespace {

/// Logical pixels.
constexpr int kListsHeight = 215, kPropertiesWidth = 280, kPropertiesHeight = 400,
              kFabricHeight = 280;

/// True for docks beside the views, false for those below them.
bool isBeside(Panel panel) {
    return panel == Panel::Properties || panel == Panel::Fabric;
}

}  // namespace

WindowDocks::WindowDocks(QMainWindow& window, Workspace& workspace, const ActionRegistry& actions,
                         ViewArea& views, Preferences& preferences)
    : window_(window),
      document_(workspace.document()),
      actions_(actions),
      views_(views),
      checker_(document_),
      keys_([this] { views_.takeKeyboard(); }, this),
      pieces_(new PiecesPanel(document_)),
      seams_(new SeamsPanel(document_, actions)),
      problems_(new ProblemsPanel(checker_)),
      history_(new QUndoView(&document_.history())),
      lines_(new LinesPanel(document_)),
      symmetry_(new SymmetryPanel(document_)),
      proof_(new ProofPanel(document_, workspace.proof(), actions[ActionId::ProveBySewing],
                            actions[ActionId::SaveProof])),
      properties_(new SelectionPanel(document_, actions)),
      fabric_(new FabricPanel(document_)) {
    history_->setObjectName("historyList");
    history_->setEmptyLabel(tr("Opened"));
    add(Panel::Pieces, tr("Pieces"), "piecesDock", pieces_, pieces_->table(), ActionId::GoToPieces);
    add(Panel::Seams, tr("Seams"), "seamsDock", seams_, seams_->table(), ActionId::GoToSeams);
    add(Panel::ProblemList, tr("Problems"), "problemsDock", problems_, problems_->table(),
        ActionId::GoToProblems);
    add(Panel::History, tr("History"), "historyDock", history_, *history_, ActionId::GoToHistory);
    add(Panel::Lines, tr("Lines"), "linesDock", scrolledRow(*lines_, &window_),
        lines_->firstField(), ActionId::GoToLines);
    add(Panel::Symmetry, tr("Symmetry"), "symmetryDock", symmetry_, symmetry_->firstField(),
        ActionId::GoToSymmetry);
    add(Panel::Proof, tr("Proof"), "proofDock", proof_, proof_->firstField(), ActionId::GoToProof);
    add(Panel::Properties, tr("Properties"), "propertiesDock",
        scrolledColumn(*properties_, &window_), properties_->placeField(), ActionId::GoToPosition);
    add(Panel::Fabric, tr("Fabric"), "fabricDock", fabric_, fabric_->firstField(),
        ActionId::GoToFabric);
    arrange();
    constexpr auto kPieces = "pieces";
    if (const auto hidden = preferences.hiddenColumns(kPieces)) {
        pieces_->columns().setHidden(*hidden);
    }
    connect(&pieces_->columns(), &ColumnChooser::chosen, this,
            [&preferences](const QStringList& hidden) {
                preferences.setHiddenColumns(kPieces, hidden);
            });
    connect(pieces_, &PiecesPanel::activated, &views_, &ViewArea::frameSelection);
    connect(seams_, &SeamsPanel::activated, &views_, &ViewArea::frameSeam);
    connect(seams_, &SeamsPanel::easeWanted, this,
            [this](int seam, std::optional<double> ease) { document_.setSeamEase(seam, ease); });
    connect(seams_, &SeamsPanel::cutRemovalWanted, &workspace.cuts(), &CutEditor::remove);
    connect(seams_, &SeamsPanel::joinRemovalWanted, &workspace.cuts(), &CutEditor::removeJoin);
    connect(fabric_, &FabricPanel::pieceActivated, &views_, &ViewArea::frameSelection);
    connect(problems_, &ProblemsPanel::countChanged, this, [this](int count) {
        dock(Panel::ProblemList)
            ->setWindowTitle(count == 0 ? tr("Problems") : tr("Problems (%1)").arg(count));
    });
    connect(problems_, &ProblemsPanel::wanted, this, [this](const QList<int>& findings) {
        const QScopedValueRollback guard(goesToFinding_, true);
        showFindings(findings);
    });
    connect(&document_, &Document::changed, this, [this](const DocumentChange& what) {
        if (!goesToFinding_ && what.touches(DocumentChange::Selection)) {
            problems_->selectNothing();  // only one object is selected at a time
        }
    });
    connect(problems_, &ProblemsPanel::remedyWanted, this, &WindowDocks::help);
    if (PatternView* pattern = views_.patternView()) {
        connect(&checker_, &ReadyChecker::changed, this, &WindowDocks::showHelp);
        connect(pattern, &PatternView::helpWanted, this, [this](int piece) {
            const std::map<int, Remedy> helps = helpOfPieces();
            if (const auto found = helps.find(piece); found != helps.end()) {
                document_.setSelection({piece});
                help(found->second);
            }
        });
    }
    connectProof(workspace);
    actions.on(ActionId::ReadyToCut, this, [this] { goTo(Panel::ProblemList); });
    actions.on(ActionId::RenamePiece, this, [this] {
        goTo(Panel::Pieces);
        pieces_->editName();
    });
    actions.on(ActionId::SetQuantity, this, [this] {
        goTo(Panel::Pieces);
        pieces_->editQuantity();
    });
    actions.on(ActionId::StateEase, this, [this] {
        goTo(Panel::Seams);
        seams_->editEase();
    });
    actions.on(ActionId::ResetLayout, this, &WindowDocks::reset);
}

void WindowDocks::connectProof(Workspace& workspace) {
    connect(&workspace.proof(), &PatternProof::wanted, this, [this] { goTo(Panel::Proof); });
    connect(&proof_->form(), &ProofForm::bodyWanted, this, &WindowDocks::bodyWanted);
    connect(proof_, &ProofPanel::pieceWanted, this, &WindowDocks::showLargestGap);
    connect(proof_, &ProofPanel::placeWanted, this, [this](const QList<int>& pieces, int seam) {
        if (seam >= 0) {
            document_.setSeam(seam);
            views_.frameSeam();
        } else if (!pieces.isEmpty()) {
            document_.setSelection({pieces.begin(), pieces.end()});
            views_.frameSelection();
        }
    });
    // Show the result of the proof.
    connect(&workspace.proof(), &PatternProof::proved, this, [this] {
        if (document_.isProofCurrent() && !isOfProof(document_.view().overlay)) {
            document_.setOverlay(Overlay::Gap);
        }
    });
}

void WindowDocks::showLargestGap(int piece) {
    const auto& shown = document_.proof();
    const Scene* scene = document_.scene().get();
    const auto at = static_cast<std::size_t>(piece);
    if (!shown || !scene || at >= shown->proof->pieces.size() || piece >= document_.pieceCount()) {
        return;
    }
    document_.setSelection({piece});
    const int vertex = shown->proof->pieces[at].gapFigures.place;
    const PieceResult* result = document_.result(piece);
    const Piece& cloth = *document_.garment()->pieces[at];
    if (!result || !result->flat || vertex < 0 || vertex >= result->flat->Q.rows()) {
        views_.frameSelection();
        return;
    }
    WorstSpot spot;
    spot.piece = piece;
    spot.flat = result->flat->Q.row(vertex).transpose();
    spot.position = cloth.mesh.V.row(vertex).transpose() - scene->origin;
    spot.normal = vertexNormals(cloth.mesh).row(vertex).transpose();
    spot.sewn = shown->proof->pieces[at].sewn.row(vertex).transpose() - scene->origin;
    views_.showSpot(spot);
}

WindowDocks::~WindowDocks() {
    qDeleteAll(all());  // the panels use the document until their end
}

void WindowDocks::add(Panel panel, const QString& title, const char* name, QWidget* content,
                      QWidget& field, ActionId goThere) {
    auto* added = new QDockWidget(title, &window_);
    added->setObjectName(name);
    added->setWidget(content);
    keys_.watch(*added);
    places_[panel] = {added, &field};
    actions_.on(goThere, added, [this, panel] { goTo(panel); });
}

QList<QDockWidget*> WindowDocks::all() const {
    QList<QDockWidget*> docks;
    for (const auto& [panel, place] : places_) {
        docks << place.dock;
    }
    return docks;
}

void WindowDocks::goTo(Panel panel) {
    const Place& place = places_.at(panel);
    place.dock->show();
    place.dock->raise();
    // Hidden if its form is that of another selection.
    QWidget* field = place.field->isVisible() ? place.field : place.dock->widget();
    field->setFocus(isBeside(panel) ? Qt::ShortcutFocusReason : Qt::OtherFocusReason);
}

QAbstractItemView& WindowDocks::list(Panel panel) const {
    return panel == Panel::Seams ? seams_->table() : pieces_->table();
}

void WindowDocks::arrange() {
    QDockWidget* left = nullptr;
    for (const auto& [panel, place] : places_) {
        if (isBeside(panel)) {
            continue;
        }
        window_.addDockWidget(Qt::BottomDockWidgetArea, place.dock);
        if (left) {
            window_.tabifyDockWidget(left, place.dock);
        }
        left = place.dock;
    }
    dock(Panel::Pieces)->raise();
    // Docks beside the views leave the full width of the window to the lists below.
    window_.addDockWidget(Qt::RightDockWidgetArea, dock(Panel::Properties));
    window_.addDockWidget(Qt::RightDockWidgetArea, dock(Panel::Fabric));
    window_.splitDockWidget(dock(Panel::Properties), dock(Panel::Fabric), Qt::Vertical);
}

void WindowDocks::show() {
    for (QDockWidget* each : all()) {
        each->show();
    }
    window_.resizeDocks({dock(Panel::Pieces)}, {kListsHeight}, Qt::Vertical);
    window_.resizeDocks({dock(Panel::Properties)}, {kPropertiesWidth}, Qt::Horizontal);
    window_.resizeDocks({dock(Panel::Properties), dock(Panel::Fabric)},
                        {kPropertiesHeight, kFabricHeight}, Qt::Vertical);
}

bool WindowDocks::setAvailable(bool available) {
    const bool first = available && !dock(Panel::Pieces)->toggleViewAction()->isEnabled();
    for (QDockWidget* each : all()) {
        each->toggleViewAction()->setEnabled(available);
        if (!available) {
            each->hide();
        }
    }
    if (first) {
        show();
    }
    return first;
}

void WindowDocks::reset() {
    // Hide docks while moving them: visible ones leave an empty tab bar behind.
    for (QDockWidget* each : all()) {
        each->setFloating(false);
        each->hide();
    }
    arrange();
    if (document_.garment()) {
        show();
    }
}

std::map<int, Remedy> WindowDocks::helpOfPieces() const {
    std::map<int, Remedy> found;
    for (const Finding& finding : checker_.readiness().findings) {
        if (finding.kind == FindingKind::NotFlat &&
            checker_.plan().garment == document_.garment()) {
            const auto remedies = remediesFor(finding, checker_.plan());
            if (!remedies.empty()) {
                found.emplace(finding.pieces.front(), remedies.front());
            }
        }
    }
    return found;
}

void WindowDocks::showHelp() {
    std::map<int, QString> buttons;
    for (const auto& [piece, remedy] : helpOfPieces()) {
        buttons.emplace(piece, remedyText(remedy));
    }
    views_.patternView()->setHelp(std::move(buttons));
}

void WindowDocks::help(Remedy remedy) {
    if (remedy == Remedy::SetUnit) {
        emit unitWanted();
        return;
    }
    const std::vector<ActionId> ids = actionsOf(remedy);
    if (remedy == Remedy::LayOutAgain) {
        document_.setSelection({});  // pieces laid out alone may overlap others
    }
    if (ids.size() == 1) {
        QAction& action = actions_[ids.front()];
        if (remedy == Remedy::TurnOver || !action.isCheckable() || !action.isChecked()) {
            action.trigger();
        }
        const auto spot = views_.shownSpot();
        if (remedy == Remedy::PutDart && spot) {
            emit dartWanted(spot->piece, spot->flat);
        }
        return;
    }
    auto* menu = new QMenu(&window_);
    menu->setObjectName("remedyMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const ActionId id : ids) {
        menu->addAction(&actions_[id]);
    }
    menu->popup(QCursor::pos());
}

void WindowDocks::showFindings(const QList<int>& indices) {
    const auto& findings = checker_.readiness().findings;
    if (indices.isEmpty() || checker_.plan().garment != document_.garment() ||
        indices.back() >= static_cast<int>(findings.size())) {
        return;  // the findings belong to a previous garment
    }
    const Finding& first = findings[static_cast<std::size_t>(indices.front())];
    const auto* shows =
        std::ranges::find(kOverlays, std::optional(first.kind), &OverlayTraits::finding);
    if (shows != std::end(kOverlays)) {
        document_.setOverlay(shows->overlay);
        document_.setView(
            &ViewState::valuesPerTriangle,
            document_.view().valuesPerTriangle || first.kind == FindingKind::FlippedTriangles);
    }
    if (indices.size() == 1 && first.seam >= 0) {
        document_.setSeam(first.seam);
        views_.frameSeam();
        return;
    }
    Document::Selection pieces;
    for (const int index : indices) {
        const auto& of = findings[static_cast<std::size_t>(index)].pieces;
        pieces.insert(of.begin(), of.end());
    }
    document_.selectNothing();
    document_.setSelection(std::move(pieces));
    if (indices.size() == 1 && first.place && document_.scene()) {
        const FindingPlace& place = *first.place;
        views_.showSpot({first.pieces.front(), place.flat,
                         place.position - document_.scene()->origin, place.normal, 0});
    } else {
        views_.frameSelection();
    }
}

}  // namespace toile::app
