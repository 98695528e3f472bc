// SPDX-License-Identifier: GPL-3.0-or-later
// "Ready to cut?": what the window does with the findings.
#include <QDockWidget>
#include <QStatusBar>
#include <QTreeView>

#include "app/jobs/ready_checker.h"
#include "app/main_window.h"
#include "app/panels/problem_text.h"
#include "app/panels/problems_panel.h"
#include "app/render/scene.h"
#include "app/views/view_area.h"
#include "app/widgets/garment_card.h"

namespace toile {

namespace {

/// As long as a sentence with a number takes to read.
constexpr int kWrittenMilliseconds = 10000;

/// The overlay that shows what was found; none where no overlay does.
std::optional<Overlay> overlayFor(FindingKind kind) {
    switch (kind) {
        case FindingKind::StrainWarp:
            return Overlay::Warp;
        case FindingKind::StrainWeft:
            return Overlay::Weft;
        case FindingKind::StrainBias:
            return Overlay::Bias;
        case FindingKind::FlippedTriangles:
            return Overlay::Area;  // what is turned over has lost more than all of its area
        default:
            return std::nullopt;
    }
}

}  // namespace

void MainWindow::makeProblems() {
    checker_ = new ReadyChecker(workspace_.document(), this);
    problems_ = new ProblemsPanel(*checker_);
    problemsDock_ = makeDock(tr("Problems"), "problemsDock", problems_);
}

void MainWindow::connectChecks() {
    connect(problems_, &ProblemsPanel::countChanged, this, [this](int count) {
        problemsDock_->setWindowTitle(count == 0 ? tr("Problems") : tr("Problems (%1)").arg(count));
    });
    connect(problems_, &ProblemsPanel::wanted, this, &MainWindow::showFindings);
    for (const ActionId id : {ActionId::GoToProblems, ActionId::ReadyToCut}) {
        actions_.on(id, this, [this] { goTo(Panel::ProblemList); });
    }
    // After the window's own connections, which keep the answer.
    connect(card_, &GarmentCard::kept, this, [this] { checker_->setGuessesKept(true); });
    connect(&workspace_.document(), &Document::changed, this, [this](DocumentChanges what) {
        if (what.testFlag(DocumentChange::Garment)) {
            checker_->setGuessesKept(keptGuesses_ == workspace_.openPaths());
        }
    });
    connect(&workspace_, &Workspace::exported, this, [this](const QString& path) {
        const int faults = checker_->readiness().count(Severity::Fault);
        statusBar()->showMessage(faults == 0
                                     ? tr("Written: %1").arg(path)
                                     : tr("Written: %1 (%2 left, see Problems)")
                                           .arg(path, severityCount(Severity::Fault, faults)),
                                 kWrittenMilliseconds);
    });
}

void MainWindow::showFindings(const QList<int>& indices) {
    Document& document = workspace_.document();
    const auto& findings = checker_->readiness().findings;
    if (indices.isEmpty() || checker_->plan().garment != document.garment() ||
        indices.back() >= static_cast<int>(findings.size())) {
        return;  // they are about a garment that is no more; others follow
    }
    const Finding& first = findings[static_cast<std::size_t>(indices.front())];
    if (const auto overlay = overlayFor(first.kind)) {
        document.setOverlay(*overlay);
        document.setView(
            &ViewState::valuesPerTriangle,
            document.view().valuesPerTriangle || first.kind == FindingKind::FlippedTriangles);
    }
    if (indices.size() == 1 && first.seam >= 0) {
        document.setSelection({});
        document.setSeam(first.seam);
        views_->frameSeam();
        return;
    }
    Document::Selection pieces;
    for (const int index : indices) {
        const auto& of = findings[static_cast<std::size_t>(index)].pieces;
        pieces.insert(of.begin(), of.end());
    }
    document.setSeam({});
    document.setSelection(std::move(pieces));
    if (indices.size() == 1 && first.place && document.scene()) {
        const FindingPlace& place = *first.place;
        views_->showSpot({first.pieces.front(), place.flat,
                          place.position - document.scene()->origin, place.normal, 0});
    } else {
        views_->frameSelection();
    }
}

}  // namespace toile
