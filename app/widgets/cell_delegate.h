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

/// Edits the cells of a list. Enter takes what was typed at once; Qt would do so with the next
/// round of events, when the row may have gone already.
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
        if (still && still->isVisible()) {  // else what came of it has closed it
            emit closeEditor(editor, SubmitModelCache);
        }
        return true;
    }
};

/// How the lists of the window look.
inline void dressList(QTreeView& list) {
    list.setUniformRowHeights(true);
    list.setAlternatingRowColors(true);
    list.setAllColumnsShowFocus(true);
    list.setFrameShape(QFrame::NoFrame);
    list.header()->setTextElideMode(
        Qt::ElideRight);  // else right-aligned heads lose their beginning
}

/// Calls it when Enter is pressed on the list.
template <class Call>
void onEnter(QTreeView& list, const Call& call) {
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
        QObject::connect(new QShortcut(key, &list, {}, {}, Qt::WidgetShortcut),
                         &QShortcut::activated, &list, call);
    }
}

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

}  // namespace toile::app
