// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_area.h"

#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/document/document.h"
#include "app/render/gl_support.h"
#include "app/render/scene.h"
#include "app/views/garment_view.h"
#include "app/views/pattern_view.h"
#include "app/widgets/colour_bar.h"

namespace toile {

ViewArea::ViewArea(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      splitter_(new QSplitter(Qt::Horizontal, this)),
      legend_(new ColourBar(this)) {
    makeViews();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(splitter_, 1);
    layout->addWidget(legend_);
    connect(&document_, &Document::changed, this, &ViewArea::updateLegend);
    updateLegend();
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
    garmentView_ = new GarmentView(document_);
    patternView_ = new PatternView(document_);
    splitter_->addWidget(garmentView_);
    splitter_->addWidget(patternView_);
    splitter_->setChildrenCollapsible(false);
    splitter_->setHandleWidth(5);
    splitter_->setStretchFactor(0, 1);
    splitter_->setStretchFactor(1, 1);
    splitter_->setSizes({1000, 1000});  // halves, whatever the width
}

void ViewArea::frameSelection() {
    if (garmentView_) {
        garmentView_->frameSelection();
    }
    if (patternView_) {
        patternView_->frameSelection();
    }
}

void ViewArea::frameSeam() {
    if (garmentView_) {
        garmentView_->frameSeam();
    }
    if (patternView_) {
        patternView_->frameSeam();
    }
}

bool ViewArea::isUpToDate() const {
    return (!garmentView_ || garmentView_->isUpToDate()) &&
           (!patternView_ || patternView_->isUpToDate());
}

void ViewArea::updateLegend() {
    const Overlay overlay = document_.view().overlay;
    legend_->show(overlay, document_.scene() ? document_.scene()->scale(overlay) : OverlayScale{});
}

}  // namespace toile
