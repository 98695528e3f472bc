// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/piece_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>

#include "app/document/document.h"
#include "app/panels/piece_form.h"
#include "app/panels/position_form.h"
#include "app/settings/length_display.h"

namespace toile::app {

namespace {

/// Fields of all forms begin at the same place.
void alignLabels(std::initializer_list<QWidget*> forms) {
    int widest = 0;
    for (const QWidget* form : forms) {
        const auto* grid = qobject_cast<QGridLayout*>(form->layout());
        for (int row = 0; row < grid->rowCount(); ++row) {
            if (const QLayoutItem* label = grid->itemAtPosition(row, 0)) {
                widest = std::max(widest, label->sizeHint().width());
            }
        }
    }
    for (const QWidget* form : forms) {
        qobject_cast<QGridLayout*>(form->layout())->setColumnMinimumWidth(0, widest);
    }
}

}  // namespace

PiecePanel::PiecePanel(Document& document, const ActionRegistry& actions, QWidget* parent)
    : QWidget(parent),
      piece_(new PieceForm(document, actions, this)),
      position_(new PositionForm(document, this)) {
    auto* heading = new QLabel(tr("Position"), this);
    QFont strong = heading->font();
    strong.setWeight(QFont::DemiBold);
    heading->setFont(strong);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 6, 10, 6);
    layout->setSpacing(5);
    layout->addWidget(piece_);
    layout->addWidget(heading);
    layout->addWidget(position_);
    layout->addStretch(1);
    alignLabels({piece_, position_});
    connect(&document, &Document::changed, this, &PiecePanel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, piece_, &PieceForm::refresh);
}

QWidget& PiecePanel::placeField() const {
    return position_->firstField();
}

void PiecePanel::onChanged(DocumentChanges what) {
    if (what & (DocumentChange::Garment | DocumentChange::Results | DocumentChange::Selection |
                DocumentChange::Settings | DocumentChange::Fabric)) {
        piece_->refresh();
        position_->refresh();
    }
}

}  // namespace toile::app
