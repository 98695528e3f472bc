// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/selection_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>

#include "app/document/document.h"
#include "app/panels/dart_form.h"
#include "app/panels/garment_summary.h"
#include "app/panels/piece_forms.h"
#include "app/panels/segment_form.h"
#include "app/settings/length_display.h"
#include "app/widgets/setting_fields.h"

namespace toile::app {
namespace {

/// Lines up the fields of all forms.
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
QVBoxLayout* makeColumn(QWidget& page) {
    auto* column = new QVBoxLayout(&page);
    column->setContentsMargins(10, 6, 10, 6);
    column->setSpacing(5);
    return column;
}

}  // namespace

SelectionPanel::SelectionPanel(Document& document, const ActionRegistry& actions, QWidget* parent)
    : QWidget(parent),
      document_(document),
      summary_(new QLabel(this)),
      piece_(new PieceForm(document, actions, this)),
      position_(new PositionForm(document, this)),
      dart_(new DartForm(document, this)),
      segment_(new SegmentForm(document, this)),
      garmentPage_(makeGarmentPage()),
      piecePage_(makePiecePage()),
      edgePage_(makeEdgePage()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (QWidget* page : {garmentPage_, piecePage_, edgePage_}) {
        column->addWidget(page);
        // As wide as the widest page, so that the dock stays still.
        setMinimumWidth(std::max(minimumWidth(), page->minimumSizeHint().width()));
    }
    connect(&document_, &Document::changed, this, &SelectionPanel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &SelectionPanel::refresh);
    refresh();
}

QWidget& SelectionPanel::placeField() const {
    return position_->firstField();
}

QWidget* SelectionPanel::makeGarmentPage() {
    auto* page = new QWidget(this);
    summary_->setObjectName("selectionGarment");
    summary_->setWordWrap(true);
    auto* hint = makeNote("selectionHint", page);
    hint->setText(tr("Select a piece, a seam or an edge to change its properties."));
    hint->setWordWrap(true);
    QVBoxLayout* column = makeColumn(*page);
    column->addWidget(makeHeading(tr("Garment"), page));
    column->addWidget(summary_);
    column->addWidget(hint);
    column->addStretch(1);
    return page;
}

QWidget* SelectionPanel::makePiecePage() {
    auto* page = new QWidget(this);
    QVBoxLayout* column = makeColumn(*page);
    column->addWidget(piece_);
    column->addWidget(makeHeading(tr("Position"), page));
    column->addWidget(position_);
    column->addStretch(1);
    alignLabels({piece_, position_});
    return page;
}

QWidget* SelectionPanel::makeEdgePage() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(dart_);
    column->addWidget(segment_, 1);
    return page;
}

void SelectionPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (isStale_) {
        refresh();
    }
}

void SelectionPanel::onChanged(const DocumentChange& what) {
    if (what.touches(DocumentChange::Selection, &Derived::garment, &Derived::results,
                     &Derived::pattern, &DocumentState::lines, &DocumentState::labels)) {
        refresh();
    } else if (what.touchesContent()) {
        piece_->refresh();
        position_->refresh();
    }
}

void SelectionPanel::refresh() {
    const bool isEdge = document_.garment() && (document_.mark() || document_.seam());
    showPage(isEdge ? *edgePage_ : document_.selection().empty() ? *garmentPage_ : *piecePage_);
    piece_->refresh();
    position_->refresh();
    isStale_ = !isVisible();
    showEdge();
    if (!isStale_) {
        summary_->setText(garmentSummary(document_));
    }
}

void SelectionPanel::showPage(QWidget& shown) {
    for (QWidget* page : {garmentPage_, piecePage_, edgePage_}) {
        page->setVisible(page == &shown);
    }
}

void SelectionPanel::showEdge() {
    dart_->refresh();
    if (isStale_ || edgePage_->isHidden()) {
        segment_->clear();
        facts_ = {};
        return;
    }
    facts_ = lineFacts(*document_.garment(), document_.results(), document_.state().lines);
    segment_->show(facts_);
}

}  // namespace toile::app
