// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

#include "app/widgets/cell_delegate.h"

namespace toile {

/// Edits a percentage in a table cell: empty at first where nothing is stated, with what the cell
/// shows as a hint behind it.
class EaseDelegate : public CellDelegate {
public:
    using CellDelegate::CellDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                          const QModelIndex& index) const override {
        auto* editor = new QLineEdit(parent);
        editor->setObjectName("easeEditor");
        editor->setFrame(false);
        editor->setAlignment(Qt::AlignRight);
        editor->setPlaceholderText(index.data(Qt::DisplayRole).toString());
        return editor;
    }

    /// What is being typed stays, whatever becomes of the figures meanwhile.
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        const auto* line = qobject_cast<const QLineEdit*>(editor);
        if (!line || !line->isModified()) {
            CellDelegate::setEditorData(editor, index);
        }
    }

    /// Left as it was found it says nothing: what is shown is rounded.
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override {
        const auto* line = qobject_cast<const QLineEdit*>(editor);
        if (line && line->isModified()) {
            CellDelegate::setModelData(editor, model, index);
        }
    }
};

}  // namespace toile
