// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace toile {

/// Paints a line of the command palette: the text with the letters that were matched in bold, where
/// else it is found in fainter letters behind, its keys at the right end.
class CommandDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    enum Role { PlaceRole = Qt::UserRole, KeysRole, LettersRole };

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace toile
