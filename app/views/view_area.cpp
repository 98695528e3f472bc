// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_area.h"

#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "app/document/document.h"
#include "app/render/gl_support.h"
#include "app/render/scene.h"
#include "app/views/colour_bar.h"
#include "app/views/feature_text.h"
#include "app/views/garment_view.h"
#include "app/views/overlay_watcher.h"
#include "app/views/pattern_view.h"
#include "app/views/walk_bar.h"
#include "app/views/way_bars.h"

namespace toile::app {

ViewArea::ViewArea(Document& document, ToolChoice& tools, QWidget* parent)
    : QWidget(parent),
      document_(document),
      tools_(tools),
      splitter_(new QSplitter(Qt::Horizontal, this)),
      figures_(new OverlayWatcher(document, this)) {
    makeViews();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(splitter_, 1);
    connect(figures_, &OverlayWatcher::changed, this, &ViewArea::showFigures);
    connect(figures_, &OverlayWatcher::failed, this, &ViewArea::failed);
    // Updates the pointed value at once, even if the figures take longer.
    connect(&document_, &Document::changed, this, &ViewArea::showPointedValue);
    showFigures();
}

void ViewArea::makeViews() {
    const QString problem = glProblem();
    if (!problem.isEmpty()) {
        auto* sentence = new QLabel(problem);
        sentence->setObjectName("glProblem");
        sentence->setWordWrap(true);
        sentence->setAlignment(Qt::AlignCenter);
        sentence->setContentsMargins(40, 40, 40, 40);
        splitter_->addWidget(sentence);
        return;
    }
    garmentView_ = new GarmentView(document_, tools_);
    patternView_ = new PatternView(document_, tools_);
    views_ = {garmentView_, patternView_};
    for (SceneView* view : views_) {
        splitter_->addWidget(view);
        connect(view, &SceneView::entered, this, [this, view] {
            viewInUse_ = view->kind();
            emit entered();
        });
        connect(view, &SceneView::pointed, this, &ViewArea::showValueAt);
    }
    legend_ = ColourBar::inCorner(*patternView_);
    morphBar_ = new MorphBar(document_, *garmentView_);
    sewnBar_ = new SewnBar(document_, *garmentView_, *morphBar_);
    walkBar_ = new WalkBar(document_, *patternView_, *garmentView_);
    splitter_->setChildrenCollapsible(false);
    splitter_->setHandleWidth(5);
    splitter_->setStretchFactor(0, 1);
    splitter_->setStretchFactor(1, 1);
    splitter_->setSizes({1000, 1000});  // equal halves at any width
}

void ViewArea::takeKeyboard(ViewKind view) {
    const auto found = std::ranges::find(views_, view, &SceneView::kind);
    if (found != views_.end()) {
        (*found)->setFocus();
    }
}

void ViewArea::frameSelection() {
    for (SceneView* view : views_) {
        view->frameSelection();
    }
}

void ViewArea::frameSeam() {
    for (SceneView* view : views_) {
        view->frameSeam();
    }
}

void ViewArea::showSpot(const WorstSpot& spot) {
    for (SceneView* view : views_) {
        view->showSpot(spot);
    }
}

std::optional<WorstSpot> ViewArea::shownSpot() const {
    return patternView_ ? patternView_->shownSpot() : std::nullopt;
}

void ViewArea::repaintViews() {
    for (SceneView* view : views_) {
        view->update();
    }
}

bool ViewArea::isUpToDate() const {
    return std::ranges::all_of(views_, &SceneView::isUpToDate) && figures_->isUpToDate();
}

void ViewArea::showFigures() {
    const OverlayFigures& figures = figures_->figures();
    if (legend_) {
        legend_->show(legendOf(figures));
    }
    for (SceneView* view : views_) {
        view->setWorstSpots({figures.spots, figures.overlay});
    }
    showPointedValue();
}

void ViewArea::showValueAt(const std::optional<SurfaceHit>& place) {
    pointed_ = place;
    showPointedValue();
}

void ViewArea::showPointedValue() {
    if (legend_) {
        legend_->showValue(pointed_ ? shownValueAt(document_, *pointed_) : std::nullopt);
    }
}

}  // namespace toile::app
