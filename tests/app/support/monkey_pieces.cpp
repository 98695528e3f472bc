// SPDX-License-Identifier: GPL-3.0-or-later
// What a monkey does with pieces as wholes, and with the menus and buttons that stand beside them.
#include <QApplication>
#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QInputMethodEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QTest>
#include <QTreeView>

#include "app/panels/leave_out_dialog.h"
#include "app/panels/problems_model.h"
#include "app/views/scene_view.h"
#include "app/window/main_window.h"
#include "tests/app/support/monkey.h"

namespace toile::test {

using namespace app;

namespace {

void askForMenu(QWidget& widget, QContextMenuEvent::Reason reason, const QPoint& at) {
    QContextMenuEvent asked(reason, at, widget.mapToGlobal(at));
    QApplication::sendEvent(&widget, &asked);
}

}  // namespace

void Monkey::openMenu() {
    const int where = random_.whole(0, 3);
    if (where < 2) {
        SceneView& view = someView();
        const QPoint at = placeIn(view);
        note(QString("menu in %1 %2,%3").arg(view.objectName()).arg(at.x()).arg(at.y()));
        if (where == 0) {
            QTest::mouseClick(&view, Qt::RightButton, {}, at);
        } else if (random_.chance(0.5)) {
            QTest::keyClick(&view, Qt::Key_F10, Qt::ShiftModifier);
        } else {
            askForMenu(view, QContextMenuEvent::Keyboard, view.rect().center());
        }
    } else if (auto* list = someVisible<QAbstractItemView>()) {
        const QPoint at = placeIn(*list->viewport());
        note(QString("menu in %1 %2,%3").arg(list->objectName()).arg(at.x()).arg(at.y()));
        if (where == 2) {
            QTest::mouseClick(list->viewport(), Qt::RightButton, {}, at);
            askForMenu(*list->viewport(), QContextMenuEvent::Mouse, at);
        } else {
            QTest::keyClick(list, Qt::Key_F10, Qt::ShiftModifier);
        }
    }
    chooseInMenu();
}

void Monkey::chooseInMenu() {
    if (random_.chance(0.1)) {
        interrupt();
    }
    const auto open = [] { return qobject_cast<QMenu*>(QApplication::activePopupWidget()); };
    for (int most = 3; open() && most > 0; --most) {  // a menu and those below it
        QMenu& menu = *open();
        if (random_.chance(0.15)) {
            QTest::keyClick(&menu, Qt::Key_Escape);
            continue;
        }
        QList<QAction*> actions = menu.actions();
        actions.removeIf([this](QAction* action) {
            return action->isSeparator() || !action->isEnabled() || isLeftAlone(*action);
        });
        if (actions.isEmpty()) {
            menu.close();
            return;
        }
        QAction* action = actions[random_.whole(0, static_cast<int>(actions.size()) - 1)];
        note("choose " + action->text());
        if (random_.chance(0.5)) {
            QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
        } else {
            menu.setActiveAction(action);
            QTest::keyClick(&menu, Qt::Key_Return);
        }
    }
}

void Monkey::typeNameOfPiece() {
    Document& document = window_.workspace().document();
    if (document.pieceCount() == 0) {
        return;
    }
    if (random_.chance(0.7)) {
        document.setSelection({random_.whole(0, document.pieceCount() - 1)});
    }
    static const QString kNames[] = {
        "front",
        "",
        "   ",
        "Vorderteil, gefüttert",
        "a/b\\c:\"<d>&amp;%1 %n",
        QString::fromUtf8("\xe8\xa2\x96 \xf0\x9f\xa7\xb5 e\xcc\x81 \xd7\xa9\xd7\xa8\xd7\x95\xd7\x95"
                          "\xd7\x9c"),
        QString("line\nbreak\ttab") + QChar(0x2028) + QChar(0) + QChar(0xFFFD),
        QString(3000, 'w')};
    const QString& name = kNames[random_.whole(0, static_cast<int>(std::size(kNames)) - 1)];
    note("rename to \"" + name.left(30) + '"');
    QTest::keyClick(&someView(), Qt::Key_F2);
    auto* list = window_.findChild<QTreeView*>("pieceTable");
    QPointer<QLineEdit> editor = list ? list->viewport()->findChild<QLineEdit*>() : nullptr;
    if (!editor) {
        return;
    }
    editor->selectAll();
    QInputMethodEvent typed;
    typed.setCommitString(name);
    QApplication::sendEvent(editor, &typed);
    if (random_.chance(0.2)) {
        interrupt();
    }
    if (editor && editor->isVisible()) {
        QTest::keyClick(editor, random_.chance(0.8) ? Qt::Key_Return : Qt::Key_Escape);
    }
}

void Monkey::hideOrLeaveOut() {
    constexpr ActionId kActions[] = {ActionId::HidePieces, ActionId::ShowOnlyThese,
                                     ActionId::ShowAllPieces, ActionId::LeaveOut, ActionId::TakeIn};
    if (random_.chance(0.15)) {
        leaveOutSmall();
        return;
    }
    if (random_.chance(0.5)) {
        select();
    }
    QAction& action = window_.actions()[kActions[random_.whole(0, 4)]];
    note(action.objectName() + (action.isEnabled() ? "" : " (off)"));
    action.trigger();
}

void Monkey::leaveOutSmall() {
    note("leave out small pieces");
    window_.actions()[ActionId::LeaveOutSmall].trigger();
    QPointer<LeaveOutDialog> dialog = window_.findChild<LeaveOutDialog*>();
    if (!dialog) {
        return;
    }
    dialog->findChild<QDoubleSpinBox*>("leaveOutArea")->setValue(random_.between(0.1, 1500));
    if (random_.chance(0.2)) {
        interrupt();
    }
    if (dialog && random_.chance(0.7)) {
        QTest::mouseClick(dialog->findChild<QPushButton*>("leaveOutNow"), Qt::LeftButton);
    } else if (dialog) {
        dialog->reject();
    }
}

void Monkey::pressRemedy() {
    note("findings");
    window_.actions()[ActionId::GoToProblems].trigger();
    auto* table = window_.findChild<QTreeView*>("problemTable");
    if (!table || !table->isVisible()) {
        return;
    }
    QModelIndexList buttons;
    for (int row = 0; row < table->model()->rowCount(); ++row) {
        const QModelIndex index = table->model()->index(row, ProblemsModel::Help);
        if (index.data(ProblemsModel::RemedyRole).isValid()) {
            buttons << index;
        }
    }
    if (buttons.isEmpty()) {
        return;
    }
    const QModelIndex& button = buttons[random_.whole(0, static_cast<int>(buttons.size()) - 1)];
    note("press " + button.data().toString());
    table->scrollTo(button);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(button).center());
    chooseInMenu();
}

}  // namespace toile::test
