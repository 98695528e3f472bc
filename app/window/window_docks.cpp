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

#include "app/actions/action_registry.h"
#include "app/actions/pattern_proof.h"
#include "app/actions/workspace.h"
#include "app/document/shown_proof.h"
#include "app/panels/fabric_panel.h"
#include "app/panels/lines_panel.h"
#include "app/panels/piece_panel.h"
#include "app/panels/pieces_panel.h"
#include "app/panels/problems_panel.h"
#include "app/panels/proof_form.h"
#include "app/panels/proof_panel.h"
#include "app/panels/seams_panel.h"
#include "app/panels/symmetry_panel.h"
#include "app/render/piece_values.h"
#include "app/render/scene.h"
#include "app/settings/preferences.h"
#include "app/views/pattern_view.h"
#include "app/views/view_area.h"
#include "app/widgets/columns_model.h"
#include "app/widgets/scrolled.h"

namespace toile::app {

namespace {

/// Logical pixels.
constexpr int kListsHeight = 215, kPropertiesWidth = 280, kPieceHeight = 400, kFabricHeight = 280;

/// The overlay that shows what was found; none where no overlay does.
std::optional<Overlay> overlayFor(FindingKind kind) {
    switch (kind) {
        case FindingKind::StrainWarp:
            return Overlay::Warp;
        case FindingKind::StrainWeft:
            return Overlay::Weft;
        case FindingKind::StrainBias:
            return Overlay::Bias;
        case FindingKind::StrainBeyondCloth:
            return Overlay::Strain;
        case FindingKind::FlippedTriangles:
            return Overlay::Area;  // what is flipped has lost more than all of its area
        case FindingKind::SewnGap:
            return Overlay::Gap;
        default:
            return std::nullopt;
    }
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
      piece_(new PiecePanel(document_, actions)),
      fabric_(new FabricPanel(document_)) {
    history_->setObjectName("historyList");
    history_->setEmptyLabel(tr("As opened"));
    add(tr("Pieces"), "piecesDock", pieces_, pieces_->table(), actions[ActionId::GoToPieces]);
    add(tr("Seams"), "seamsDock", seams_, seams_->table(), actions[ActionId::GoToSeams]);
    add(tr("Problems"), "problemsDock", problems_, problems_->table(),
        actions[ActionId::GoToProblems]);
    add(tr("History"), "historyDock", history_, *history_, actions[ActionId::GoToHistory]);
    add(tr("Lines"), "linesDock", scrolledRow(*lines_, &window_), lines_->firstField(),
        actions[ActionId::GoToLines]);
    add(tr("Symmetry"), "symmetryDock", symmetry_, symmetry_->firstField(),
        actions[ActionId::GoToSymmetry]);
    add(tr("Proof"), "proofDock", proof_, proof_->firstField(), actions[ActionId::GoToProof]);
    add(tr("Piece"), "pieceDock", scrolledColumn(*piece_, &window_), piece_->placeField(),
        actions[ActionId::GoToPosition]);
    add(tr("Fabric"), "fabricDock", fabric_, fabric_->firstField(), actions[ActionId::GoToFabric]);
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
    connect(seams_, &SeamsPanel::easeWanted, &workspace, &Workspace::setEase);
    connect(seams_, &SeamsPanel::cutRemovalWanted, &workspace, &Workspace::removeCut);
    connect(seams_, &SeamsPanel::joinRemovalWanted, &workspace, &Workspace::removeJoin);
    connect(fabric_, &FabricPanel::pieceActivated, &views_, &ViewArea::frameSelection);
    connect(problems_, &ProblemsPanel::countChanged, this, [this](int count) {
        docks_[Problems]->setWindowTitle(count == 0 ? tr("Problems")
                                                    : tr("Problems (%1)").arg(count));
    });
    connect(problems_, &ProblemsPanel::wanted, this, [this](const QList<int>& findings) {
        const QScopedValueRollback guard(goesToFinding_, true);
        showFindings(findings);
    });
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        if (!goesToFinding_ && (what & (DocumentChange::Selection | DocumentChange::SeamSelection |
                                        DocumentChange::Mark))) {
            problems_->selectNothing();  // one thing is selected at a time
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
    // What has just been found is to be seen.
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
    qDeleteAll(docks_);  // the panels look at the document to their end
}

void WindowDocks::add(const QString& title, const char* name, QWidget* panel, QWidget& field,
                      const QAction& goThere) {
    auto* dock = new QDockWidget(title, &window_);
    dock->setObjectName(name);
    dock->setWidget(panel);
    keys_.watch(*dock);
    docks_ << dock;
    fields_ << &field;
    connect(&goThere, &QAction::triggered, dock, [this, at = docks_.size() - 1] { goTo(at); });
}

void WindowDocks::goTo(qsizetype at) {
    docks_[at]->show();
    docks_[at]->raise();
    fields_[at]->setFocus(at < PieceDock ? Qt::OtherFocusReason : Qt::ShortcutFocusReason);
}

void WindowDocks::goTo(Panel panel) {
    goTo(static_cast<qsizetype>(panel));
}

QAbstractItemView& WindowDocks::list(Panel panel) const {
    return panel == Panel::Seams ? seams_->table() : pieces_->table();
}

void WindowDocks::arrange() {
    for (qsizetype k = 0; k < PieceDock; ++k) {
        window_.addDockWidget(Qt::BottomDockWidgetArea, docks_[k]);
    }
    for (qsizetype k = 1; k < PieceDock; ++k) {
        window_.tabifyDockWidget(docks_[k - 1], docks_[k]);
    }
    docks_[Pieces]->raise();
    // Beside the views, so that the lists have the window's whole width.
    window_.addDockWidget(Qt::RightDockWidgetArea, docks_[PieceDock]);
    window_.addDockWidget(Qt::RightDockWidgetArea, docks_[FabricDock]);
    window_.splitDockWidget(docks_[PieceDock], docks_[FabricDock], Qt::Vertical);
}

void WindowDocks::show() {
    for (QDockWidget* dock : docks_) {
        dock->show();
    }
    window_.resizeDocks({docks_[Pieces]}, {kListsHeight}, Qt::Vertical);
    window_.resizeDocks({docks_[PieceDock]}, {kPropertiesWidth}, Qt::Horizontal);
    window_.resizeDocks({docks_[PieceDock], docks_[FabricDock]}, {kPieceHeight, kFabricHeight},
                        Qt::Vertical);
}

bool WindowDocks::setAvailable(bool available) {
    const bool first = available && !docks_.front()->toggleViewAction()->isEnabled();
    for (QDockWidget* dock : docks_) {
        dock->toggleViewAction()->setEnabled(available);
        if (!available) {
            dock->hide();
        }
    }
    if (first) {
        show();
    }
    return first;
}

void WindowDocks::reset() {
    // Hidden while they move: docks that are seen leave an empty tab bar over the new one.
    for (QDockWidget* dock : docks_) {
        dock->setFloating(false);
        dock->hide();
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
        document_.setSelection({});  // two that are laid out alone may meet the others
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
        return;  // they are about a garment that is no more; others follow
    }
    const Finding& first = findings[static_cast<std::size_t>(indices.front())];
    if (const auto overlay = overlayFor(first.kind)) {
        document_.setOverlay(*overlay);
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
