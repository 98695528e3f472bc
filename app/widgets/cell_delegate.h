// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QInputMethod>
#include <QKeyEvent>
#include <QPointer>
#include <QShortcut>
#include <QStyledItemDelegate>
#include <QTreeView>

namespace toile::app {

/// Edits the cells of a list. Enter commits at once. Qt would commit from the event loop, when the
/// row may no longer exist.
class CellDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    bool eventFilter(QObject* object, QEvent* event) override {
        auto* editor = qobject_cast<QWidget*>(object);
        const bool isKey = editor && event->type() == QEvent::KeyPress;
        const int key = isKey ? static_cast<const QKeyEvent*>(event)->key() : 0;
        if (key != Qt::Key_Return && key != Qt::Key_Enter) {
            return QStyledItemDelegate::eventFilter(object, event);
        }
        QGuiApplication::inputMethod()->commit();
        if (auto* box = qobject_cast<QAbstractSpinBox*>(editor)) {
            box->interpretText();
        }
        const QPointer<QWidget> still(editor);
        emit commitData(editor);
        if (still && still->isVisible()) {  // the commit may have closed it
            emit closeEditor(editor, SubmitModelCache);
        }
        return true;
    }
};

/// Common look of the window's lists.
inline void dressList(QTreeView& list) {
    list.setUniformRowHeights(true);
    list.setAlternatingRowColors(true);
    list.setAllColumnsShowFocus(true);
    list.setFrameShape(QFrame::NoFrame);
    list.header()->setTextElideMode(Qt::ElideRight);  // else right-aligned heads lose their start
}

/// Calls `call` when the user presses Enter in the list.
template <class Call>
void onEnter(QTreeView& list, const Call& call) {
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
        QObject::connect(new QShortcut(key, &list, {}, {}, Qt::WidgetShortcut),
                         &QShortcut::activated, &list, call);
    }
}

/// Closes the open editors of a list without committing them before the model resets. Qt releases
/// them only after the reset, when it no longer knows the delegate of their column. That delegate
/// would then refer to a removed row.
inline void closeEditorsBeforeReset(QAbstractItemView& view) {
    QObject::connect(view.model(), &QAbstractItemModel::modelAboutToBeReset, &view, [&view] {
        const auto editors =
            view.viewport()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
        for (QWidget* editor : editors) {
            if (!editor->isHidden()) {  // hidden ones are being deleted already
                emit view.itemDelegate()->closeEditor(editor, QAbstractItemDelegate::NoHint);
            }
        }
    });
}

}  // namespace toile::app
