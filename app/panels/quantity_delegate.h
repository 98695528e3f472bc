// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSpinBox>

#include "app/document/piece_edits.h"
#include "app/widgets/cell_delegate.h"

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
};

}  // namespace toile
