// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pieces_view.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSpinBox>

#include "app/panels/pieces_model.h"
#include "app/widgets/cell_delegate.h"
#include "core/project/piece_settings.h"

namespace toile::app {

namespace {

/// Edits how many of a piece are cut, in a table cell.
class QuantityDelegate : public CellDelegate {
public:
    using CellDelegate::CellDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                          const QModelIndex&) const override {
        auto* editor = new QSpinBox(parent);
        editor->setObjectName("quantityEditor");
        editor->setFrame(false);
        editor->setAlignment(Qt::AlignRight);
        editor->setRange(1, kMaxCopies);
        return editor;
    }

    /// Left as it was found it says nothing, of other pieces that are selected neither.
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override {
        const auto* box = qobject_cast<const QSpinBox*>(editor);
        const auto* line = box ? box->findChild<const QLineEdit*>() : nullptr;
        if ((line && line->isModified()) ||
            (box && box->value() != index.data(Qt::EditRole).toInt())) {
            CellDelegate::setModelData(editor, model, index);
        }
    }
};

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
    setItemDelegate(new CellDelegate(this));
    setItemDelegateForColumn(PiecesModel::Quantity, new QuantityDelegate(this));
    setItemDelegateForColumn(PiecesModel::Pair, new PairDelegate(this));
}

void PiecesView::openEditor(const QModelIndex& cell) {
    setFocus();  // an open editor takes what was typed
    edit(cell, AllEditTriggers, nullptr);
}

bool PiecesView::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    const bool isKey = event && event->type() == QEvent::KeyPress;
    if (trigger == EditKeyPressed) {
        return QTreeView::edit(index.siblingAtColumn(PiecesModel::Name), trigger, event);
    }
    if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        return QTreeView::edit(index.siblingAtColumn(PiecesModel::Pair), trigger, event);
    }
    return QTreeView::edit(index, trigger, event);
}

QItemSelectionModel::SelectionFlags PiecesView::selectionCommand(const QModelIndex& index,
                                                                 const QEvent* event) const {
    const bool changes = index.column() != PiecesModel::Name &&  // two pieces have no name together
                         index.flags() & (Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
    if (changes && event && selectionModel()->isSelected(index) &&
        (event->type() == QEvent::MouseButtonPress ||
         event->type() == QEvent::MouseButtonRelease) &&
        static_cast<const QMouseEvent*>(event)->modifiers() == Qt::NoModifier) {
        return QItemSelectionModel::NoUpdate;
    }
    return QTreeView::selectionCommand(index, event);
}

}  // namespace toile::app
