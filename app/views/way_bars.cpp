// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/way_bars.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "app/document/document.h"
#include "app/document/shown_proof.h"
#include "app/render/scene.h"
#include "app/render/sewn_cloth.h"
#include "app/views/garment_view.h"
#include "app/views/sewn_run.h"

namespace toile::app {

namespace {

constexpr int kMorphMilliseconds = 2600, kSewnMilliseconds = 1400;
/// Right of the axis cross; the sewing bar is above the morph bar.
constexpr int kBarLeft = 92, kSewnFoot = 50;

}  // namespace

MorphBar::MorphBar(Document& document, GarmentView& view)
    : PlayBar(view, "morph", kMorphMilliseconds, {.left = kBarLeft}), document_(document) {
    slider().setAccessibleName(tr("From garment to pattern"));
    slider().setToolTip(tr("Go from the 3D garment (left) to the flat pattern (right)"));
    button().setToolTip(tr("Play from garment to pattern and back"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 10, 2);
    row->setSpacing(6);
    row->addWidget(&button());
    row->addWidget(makeLabel(tr("3D")));
    row->addWidget(&slider(), 1);
    row->addWidget(makeLabel(tr("Flat")));

    connect(this, &PlayBar::moved, &view, &GarmentView::setMorph);
    connect(&document_, &Document::opened, this, &MorphBar::rewind);
    connect(&document_, &Document::changed, this, &MorphBar::showOrHide);
    showOrHide();
}

void MorphBar::showOrHide() {
    const Scene* scene = document_.scene().get();
    const bool anyFlat =
        scene && std::ranges::any_of(scene->pieces,
                                     [](const PieceScene& piece) -> bool { return piece.flat; });
    if (!anyFlat) {
        rewind();
    }
    setVisible(anyFlat);
    place();
}

SewnBar::SewnBar(Document& document, GarmentView& view, MorphBar& morph)
    : PlayBar(view, "sewn", kSewnMilliseconds, {.left = kBarLeft, .foot = kSewnFoot}),
      document_(document),
      morph_(morph) {
    slider().setAccessibleName(tr("From design to sewn pattern"));
    slider().setToolTip(tr("Go from the design (left) to the sewn pattern (right)"));
    button().setToolTip(tr("Play from design to sewn pattern and back"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 10, 2);
    row->setSpacing(6);
    row->addWidget(&button());
    row->addWidget(makeLabel(tr("Design")));
    row->addWidget(&slider(), 1);
    row->addWidget(makeLabel(tr("Sewn")));
    connect(this, &PlayBar::moved, &view, [&view, &morph](double share) {
        if (share > 0 && morph.share() > 0) {
            morph.rewind();
        }
        view.setSewnWay(share);
    });
    connect(&morph, &PlayBar::moved, this, [this](double way) {
        if (way > 0 && share() > 0) {
            rewind();
        }
    });
    connect(&document_, &Document::changed, this, &SewnBar::showOrHide);
    setVisible(false);
}

void SewnBar::showOrHide() {
    const auto cloth = sewnOf(document_);
    const bool isThere = cloth && cloth->isMeasured;
    const bool isNew = isThere && document_.proof()->proof != seen_;
    if (isThere == isThere_ && !isNew) {
        return;
    }
    if (isThere_) {
        left_ = slider().value();
    }
    isThere_ = isThere;
    rewind();
    setVisible(isThere_);
    place();
    if (isThere_) {
        seen_ = document_.proof()->proof;
    }
    if (!isThere_ || morph_.share() > 0) {
        return;
    }
    slider().setValue(isNew ? slider().maximum() : left_);
    if (isNew) {  // from the sewn cloth back to the design
        play();
    }
}

}  // namespace toile::app
