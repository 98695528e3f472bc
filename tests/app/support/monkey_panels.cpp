// SPDX-License-Identifier: GPL-3.0-or-later
// What the monkey does outside of the views: lists, numbers, dialogs, the window itself.
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoView>
#include <algorithm>

#include "app/panels/mirrored_pieces_list.h"
#include "app/panels/preferences_dialog.h"
#include "app/window/main_window.h"
#include "tests/app/support/monkey.h"

namespace toile::test {

using namespace app;

QWidget* Monkey::someVisible(const std::function<bool(QWidget*)>& isMeant) {
    std::vector<QWidget*> found;
    for (QWidget* widget : window_.findChildren<QWidget*>()) {
        if (widget->isVisible() && widget->isEnabled() && isMeant(widget)) {
            found.push_back(widget);
        }
    }
    return found.empty() ? nullptr
                         : found[std::size_t(random_.whole(0, static_cast<int>(found.size()) - 1))];
}

void Monkey::typeNumber() {
    auto* field = someVisible<QAbstractSpinBox>();
    if (!field) {
        return;
    }
    constexpr const char* kTexts[] = {"0", "12.5", "-90", "1e9", "", "abc", "179.99", "-0.01", "3"};
    const char* text = kTexts[random_.whole(0, static_cast<int>(std::size(kTexts)) - 1)];
    note(QString("type \"%1\" in %2").arg(text, field->objectName()));
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QPointer<QAbstractSpinBox> still(field);
    if (random_.chance(0.2)) {
        interrupt();
    }
    if (still) {
        QTest::keyClick(still, random_.chance(0.9) ? Qt::Key_Return : Qt::Key_Escape);
    }
}

void Monkey::clickInPanel() {
    auto* dock = someVisible<QDockWidget>();
    if (!dock) {
        return;
    }
    std::vector<QWidget*> buttons;
    for (QAbstractButton* button : dock->findChildren<QAbstractButton*>()) {
        if (button->isVisible() && button->isEnabled()) {
            buttons.push_back(button);
        }
    }
    if (buttons.empty()) {
        return;
    }
    QWidget* button = buttons[std::size_t(random_.whole(0, static_cast<int>(buttons.size()) - 1))];
    note(QString("button %1 in %2").arg(button->objectName(), dock->objectName()));
    QTest::mouseClick(button, Qt::LeftButton);
}

void Monkey::clickInTable() {
    auto* table = someVisible<QAbstractItemView>();
    if (!table || table->objectName() == "commandList") {
        return;
    }
    QWidget& inside = *table->viewport();
    const QPoint at = placeIn(inside);
    note(QString("click %1 %2,%3").arg(table->objectName()).arg(at.x()).arg(at.y()));
    QTest::mouseClick(&inside, Qt::LeftButton, someModifiers(), at);
    if (random_.chance(0.2)) {
        QTest::mouseDClick(&inside, Qt::LeftButton, {}, at);
    }
}

void Monkey::editInTable() {
    auto* table = someVisible<QAbstractItemView>();
    if (!table || !table->model() || table->model()->rowCount() == 0 ||
        qobject_cast<QUndoView*>(table)) {
        return;
    }
    const QModelIndex index =
        table->model()->index(random_.whole(0, table->model()->rowCount() - 1),
                              random_.whole(0, table->model()->columnCount() - 1));
    note(QString("edit %1 row %2 column %3")
             .arg(table->objectName())
             .arg(index.row())
             .arg(index.column()));
    table->setCurrentIndex(index);
    if (!(table->model()->flags(index) & Qt::ItemIsEditable)) {
        return;
    }
    table->edit(index);
    auto* editor = table->findChild<QLineEdit*>();
    if (!editor) {
        return;
    }
    QPointer<QLineEdit> still(editor);
    QTest::keyClicks(editor, random_.chance(0.7) ? "2" : "-x");
    if (random_.chance(0.2)) {
        interrupt();
    }
    if (still && still->isVisible()) {  // else the table has closed it
        QTest::keyClick(still, random_.chance(0.8) ? Qt::Key_Return : Qt::Key_Escape);
    }
}

void Monkey::clickInHistory() {
    QUndoStack& history = window_.workspace().document().history();
    auto* list = window_.findChild<QUndoView*>("historyList");
    if (!list || history.count() == 0 || !list->model()) {
        return;
    }
    // A few steps from here: all the way back is for the end.
    const int row =
        std::clamp(history.index() + random_.whole(-6, 6), 0, list->model()->rowCount() - 1);
    note(QString("history row %1 of %2").arg(row).arg(history.count()));
    list->setCurrentIndex(list->model()->index(row, 0));
}

void Monkey::searchCommand() {
    note("palette");
    window_.actions()[ActionId::CommandPalette].trigger();
    QPointer<QLineEdit> line = window_.findChild<QLineEdit*>("commandLine");
    constexpr const char* kTyped[] = {"over", "grain", "seam", "piece", "zzz", "lay", "turn"};
    if (line) {
        QTest::keyClicks(line, kTyped[random_.whole(0, 6)]);
    }
    for (int downs = random_.whole(0, 5); line && downs > 0; --downs) {
        QTest::keyClick(line, Qt::Key_Down);
    }
    if (line) {
        QTest::keyClick(line, random_.chance(0.6) ? Qt::Key_Return : Qt::Key_Escape);
    }
}

void Monkey::slideMorph() {
    auto* slider = window_.findChild<QSlider*>("morphSlider");
    if (slider && slider->isVisible()) {
        const int value = random_.chance(0.4) ? 0 : random_.whole(0, slider->maximum());
        note(QString("morph %1").arg(value));
        slider->setValue(value);
    }
}

void Monkey::choosePreference() {
    note("preferences");
    window_.actions()[ActionId::EditPreferences].trigger();
    QPointer<PreferencesDialog> dialog = window_.findChild<PreferencesDialog*>();
    if (!dialog) {
        return;
    }
    const auto combos = dialog->findChildren<QComboBox*>();
    if (!combos.isEmpty()) {
        QComboBox* combo = combos[random_.whole(0, static_cast<int>(combos.size()) - 1)];
        combo->setCurrentIndex(random_.whole(0, combo->count() - 1));
    }
    if (dialog) {
        random_.chance(0.6) ? dialog->accept() : dialog->reject();
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

void Monkey::decideOnLines() {
    window_.actions()[ActionId::GoToLines].trigger();
    Document& document = window_.workspace().document();
    if (document.seamCount() > 0 && random_.chance(0.7)) {
        document.setSeam(random_.whole(0, document.seamCount() - 1));
    }
    constexpr const char* kButtons[] = {"fairing",
                                        "trueBelowOn",
                                        "segmentStraight",
                                        "allowance",
                                        "notches",
                                        "segmentBothSides",
                                        "segmentNotchAdd",
                                        "segmentNotchRemove",
                                        "segmentAllowanceReset"};
    constexpr const char* kFields[] = {"segmentAllowance", "segmentExtension", "segmentFacing",
                                       "segmentEase",      "allowanceSeam",    "dartIntake"};
    const int choice = random_.whole(0, 9);
    if (choice < 4) {
        const char* name = kButtons[random_.whole(0, static_cast<int>(std::size(kButtons)) - 1)];
        auto* button = window_.findChild<QAbstractButton*>(name);
        if (button && button->isVisible() && button->isEnabled()) {
            note(QString("lines: ") + name);
            button->click();
        }
    } else if (choice < 6) {
        auto* length = window_.findChild<QDoubleSpinBox*>("segmentLength");
        if (length && length->isVisible() && length->isEnabled()) {
            note("lines: a segment's length");
            length->setFocus();
            length->setValue(length->value() * random_.between(0.98, 1.02));
        }
    } else if (choice < 9) {
        const char* name = kFields[random_.whole(0, static_cast<int>(std::size(kFields)) - 1)];
        auto* field = window_.findChild<QDoubleSpinBox*>(name);
        if (field && field->isVisible() && field->isEnabled()) {
            note(QString("lines: ") + name);
            field->setFocus();
            field->setValue(random_.chance(0.3) ? 0 : random_.between(0, 30));
        }
    } else {
        auto* corner = window_.findChild<QComboBox*>("segmentCorner");
        if (corner && corner->isVisible() && corner->isEnabled()) {
            note("lines: a corner");
            QTest::keyClick(corner, random_.chance(0.5) ? Qt::Key_Down : Qt::Key_Up);
        }
    }
}

void Monkey::decideOnSymmetry() {
    window_.actions()[ActionId::GoToSymmetry].trigger();
    const int choice = random_.whole(0, 3);
    const bool isBack = random_.chance(0.3);
    if (choice == 0) {
        auto* mirror = window_.findChild<QComboBox*>("mirrorChoice");
        if (mirror->isVisible() && mirror->isEnabled()) {
            note("symmetry: other choice");
            QTest::keyClick(mirror, isBack ? Qt::Key_Up : Qt::Key_Down);
        }
    } else if (choice == 1) {
        auto* edits = window_.findChild<QAbstractButton*>("mirrorEdits");
        if (edits->isVisible() && edits->isEnabled()) {
            note("symmetry: mirror edits or not");
            edits->click();
        }
    } else {
        auto* list = window_.findChild<QTreeWidget*>("mirroredPieceList");
        const int rows = list->topLevelItemCount();
        auto* row = rows > 0 ? list->topLevelItem(random_.whole(0, rows - 1)) : nullptr;
        constexpr int kHalf = MirroredPiecesList::Half;
        if (row && row->data(kHalf, Qt::CheckStateRole).isValid()) {
            note("symmetry: half of " + row->text(0));
            row->setCheckState(kHalf, isBack ? Qt::Unchecked : Qt::Checked);
        }
    }
}

void Monkey::touchFrame() {
    if (random_.chance(0.3)) {
        note("resize");
        window_.resize(random_.whole(700, 950), random_.whole(520, 650));
        return;
    }
    const auto docks = window_.findChildren<QDockWidget*>();
    QDockWidget* dock = docks[random_.whole(0, static_cast<int>(docks.size()) - 1)];
    note("dock " + dock->objectName());
    if (random_.chance(0.5)) {
        dock->toggleViewAction()->trigger();
    } else {
        dock->show();
        dock->raise();
    }
}

}  // namespace toile::test
