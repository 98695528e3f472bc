// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/field_keys.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSpinBox>
#include <QTimer>
#include <algorithm>
#include <utility>

namespace toile::app {

namespace {

enum class FieldKey { None, Take, TakeBack };

FieldKey meaningOf(const QKeyEvent& event) {
    if (event.modifiers() & ~Qt::KeypadModifier) {
        return FieldKey::None;
    }
    switch (event.key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return FieldKey::Take;
        case Qt::Key_Escape:
            return FieldKey::TakeBack;
        default:
            return FieldKey::None;
    }
}

/// A field for a number, a text or a choice; not the editor of a list cell.
QWidget* fieldOf(QObject* object) {
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget || (widget->parentWidget() &&
                    qobject_cast<QAbstractItemView*>(widget->parentWidget()->parentWidget()))) {
        return nullptr;
    }
    const bool isField = qobject_cast<QAbstractSpinBox*>(widget) ||
                         qobject_cast<QComboBox*>(widget) || qobject_cast<QLineEdit*>(widget);
    return isField ? widget : nullptr;
}

/// Restores the current value. A spin box rewrites its text only if the value changes.
void forgetTyping(QWidget& field) {
    if (auto* number = qobject_cast<QDoubleSpinBox*>(&field)) {
        if (auto* line = number->findChild<QLineEdit*>()) {
            line->setText(number->textFromValue(number->value()));
        }
    } else if (auto* count = qobject_cast<QSpinBox*>(&field)) {
        const bool isSpecial =
            count->value() == count->minimum() && !count->specialValueText().isEmpty();
        count->findChild<QLineEdit*>()->setText(
            isSpecial ? count->specialValueText() : count->locale().toString(count->value()));
    } else if (auto* line = qobject_cast<QLineEdit*>(&field)) {
        while (line->isUndoAvailable()) {
            line->undo();
        }
    }
}

}  // namespace

FieldKeys::FieldKeys(std::function<void()> giveBack, QObject* parent)
    : QObject(parent), giveBack_(std::move(giveBack)) {
    // A filter on the application also covers fields that are added later.
    qApp->installEventFilter(this);
}

void FieldKeys::watch(QWidget& panel) {
    panels_ << &panel;
}

bool FieldKeys::isOurs(const QWidget& field) const {
    return std::ranges::any_of(panels_, [&field](const QPointer<QWidget>& panel) {
        return panel && panel->isAncestorOf(&field);
    });
}

bool FieldKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) {
        return false;
    }
    const FieldKey meaning = meaningOf(*static_cast<QKeyEvent*>(event));
    QWidget* field = meaning == FieldKey::None ? nullptr : fieldOf(watched);
    if (!field || field != QApplication::focusWidget() || !isOurs(*field)) {
        return false;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();  // Escape is a shortcut, too
        return meaning == FieldKey::TakeBack;
    }
    if (meaning == FieldKey::TakeBack) {
        forgetTyping(*field);
        giveBack_();
        return true;
    }
    // Wait until the field and its listeners have handled the key.
    QTimer::singleShot(0, field, [this, field] {
        if (QApplication::focusWidget() == field) {
            giveBack_();
        }
    });
    return false;
}

}  // namespace toile::app
