// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pieces_view.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include "app/panels/pieces_model.h"
#include "app/panels/quantity_delegate.h"

namespace toile {

namespace {

/// The box of a mirrored pair: with an outline that can be seen on dark rows, too.
class PairDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        // Styles make the outline of the window's colour, which is near the rows'.
        option->palette.setColor(QPalette::Window,
                                 option->palette.color(QPalette::PlaceholderText));
    }
};

}  // namespace

PiecesView::PiecesView(QWidget* parent) : QTreeView(parent) {
    setEditTriggers(DoubleClicked | EditKeyPressed);
    setItemDelegateForColumn(PiecesModel::Quantity, new QuantityDelegate(this));
    setItemDelegateForColumn(PiecesModel::Pair, new PairDelegate(this));
}

bool PiecesView::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    const bool isKey = event && event->type() == QEvent::KeyPress;
    if (trigger == EditKeyPressed) {
        return QTreeView::edit(index.siblingAtColumn(PiecesModel::Quantity), trigger, event);
    }
    if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        return QTreeView::edit(index.siblingAtColumn(PiecesModel::Pair), trigger, event);
    }
    return QTreeView::edit(index, trigger, event);
}

QItemSelectionModel::SelectionFlags PiecesView::selectionCommand(const QModelIndex& index,
                                                                 const QEvent* event) const {
    const bool changes = index.flags() & (Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
    if (changes && event && selectionModel()->isSelected(index) &&
        (event->type() == QEvent::MouseButtonPress ||
         event->type() == QEvent::MouseButtonRelease) &&
        static_cast<const QMouseEvent*>(event)->modifiers() == Qt::NoModifier) {
        return QItemSelectionModel::NoUpdate;
    }
    return QTreeView::selectionCommand(index, event);
}

}  // namespace toile
