// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemDelegate>
#include <QAbstractItemModel>
#include <QAbstractItemView>

namespace toile {

/// Closes the open editors of a list, and drops what is being typed, before its rows are made anew.
/// Qt lets go of them only afterwards, when it cannot tell any more which column's delegate still
/// listens to them: that would speak of a row that has gone.
inline void closeEditorsBeforeReset(QAbstractItemView& view) {
    QObject::connect(view.model(), &QAbstractItemModel::modelAboutToBeReset, &view, [&view] {
        const auto editors =
            view.viewport()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
        for (QWidget* editor : editors) {
            if (!editor->isHidden()) {  // else it goes already
                emit view.itemDelegate()->closeEditor(editor, QAbstractItemDelegate::NoHint);
            }
        }
    });
}

}  // namespace toile
