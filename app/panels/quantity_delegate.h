// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QSpinBox>

#include "app/widgets/cell_delegate.h"
#include "core/project/piece_settings.h"

namespace toile {

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
        editor->setRange(1, kMostCopies);
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

}  // namespace toile
