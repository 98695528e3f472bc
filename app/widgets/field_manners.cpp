// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/field_manners.h"

#include <QDoubleSpinBox>
#include <QKeyEvent>

namespace toile {

namespace {

/// True where nothing has been typed that is still to be taken.
bool isSettled(const QDoubleSpinBox& field) {
    return field.text() == field.prefix() + field.textFromValue(field.value()) + field.suffix();
}

}  // namespace

void FieldManners::teach(QWidget& field) {
    field.installEventFilter(this);
}

bool FieldManners::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const auto* field = qobject_cast<QDoubleSpinBox*>(watched);
        if (field && isSettled(*field) &&
            (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
            event->ignore();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace toile
