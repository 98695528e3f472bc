// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/cuts_panel.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/document/document.h"
#include "app/panels/figures.h"

namespace toile {

namespace {

enum Column { Name, Author, PieceName, Length, ColumnCount };

}  // namespace

CutsPanel::CutsPanel(const Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      count_(new QLabel(this)),
      table_(new QTreeWidget(this)) {
    QFont strong = count_->font();
    strong.setWeight(QFont::DemiBold);
    count_->setFont(strong);
    count_->setContentsMargins(4, 3, 8, 3);
    table_->setObjectName("cutTable");
    table_->setAccessibleName(tr("Cuts"));
    table_->setRootIsDecorated(false);
    table_->setUniformRowHeights(true);
    table_->setAlternatingRowColors(true);
    table_->setAllColumnsShowFocus(true);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setHeaderLabels({tr("Cut"), tr("Made by"), tr("Piece"), tr("Length mm")});
    table_->headerItem()->setTextAlignment(Length, Qt::AlignRight | Qt::AlignVCenter);
    table_->header()->setStretchLastSection(false);
    table_->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(count_);
    layout->addWidget(table_, 1);
    table_->installEventFilter(this);
    connect(&document_, &Document::changed, this, &CutsPanel::onChanged);
    hide();
}

void CutsPanel::onChanged(DocumentChanges what) {
    if (what.testFlag(DocumentChange::Garment)) {
        rebuild();
    }
}

void CutsPanel::rebuild() {
    table_->clear();
    if (document_.garment()) {
        for (const MadeCut& cut : document_.garment()->cuts) {
            auto* row = new QTreeWidgetItem(table_);
            row->setText(Name, QString::fromStdString(cut.name));
            const bool own = cut.author == CutAuthor::User;
            row->setToolTip(
                Name, own ? tr("%1: Delete takes it back").arg(row->text(Name)) : row->text(Name));
            row->setData(Name, Qt::UserRole, own);
            row->setText(Author, own ? tr("you") : tr("Toile"));
            row->setText(PieceName, QString::fromStdString(cut.piece));
            row->setText(Length, millimetres(cut.length));
            row->setTextAlignment(Length, Qt::AlignRight | Qt::AlignVCenter);
        }
    }
    for (int column = Author; column < ColumnCount; ++column) {
        table_->resizeColumnToContents(column);
    }
    const int count = table_->topLevelItemCount();
    count_->setText(count == 1 ? tr("1 cut") : tr("%1 cuts").arg(count));
    setVisible(count > 0);
}

bool CutsPanel::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey =
        event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!isKey || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Delete)) {
        return QWidget::eventFilter(watched, event);
    }
    // While this table has the keyboard, Delete is its own and not the window's.
    event->accept();
    if (event->type() == QEvent::KeyPress) {
        removeCurrent();
    }
    return true;
}

void CutsPanel::removeCurrent() {
    const QTreeWidgetItem* row = table_->currentItem();
    if (row != nullptr && row->data(Name, Qt::UserRole).toBool()) {
        emit removeWanted(row->text(Name).toStdString());
    }
}

}  // namespace toile
