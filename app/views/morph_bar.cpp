// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/morph_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/views/garment_view.h"

namespace toile::app {

namespace {

constexpr int kMilliseconds = 2600;
/// To the right of the axis cross.
constexpr int kLeft = 92;

}  // namespace

MorphBar::MorphBar(Document& document, GarmentView& view)
    : PlayBar(view, "morph", kMilliseconds, {.left = kLeft}), document_(document) {
    slider().setAccessibleName(tr("From the garment to the pattern"));
    slider().setToolTip(
        tr("Shows what flattening does: the garment on the left, flat on the right"));
    button().setToolTip(tr("Play the way from the garment to the pattern and back"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 10, 2);
    row->setSpacing(6);
    row->addWidget(&button());
    row->addWidget(makeLabel(tr("Worn")));
    row->addWidget(&slider(), 1);
    row->addWidget(makeLabel(tr("Flat")));

    connect(this, &PlayBar::moved, &view, &GarmentView::setMorph);
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        if (what.testFlag(DocumentChange::Opened)) {
            rewind();
        }
        if (what & (DocumentChange::Results | DocumentChange::Garment)) {
            showOrHide();
        }
    });
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

}  // namespace toile::app
