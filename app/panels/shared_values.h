// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/widgets/number_edits.h"

class QAbstractSpinBox;
class QCheckBox;
class QLineEdit;

namespace toile::app {

/// How a field shows one value for several pieces: the common value, or that they differ.

/// Value of an angle field if the angles differ, degrees.
inline constexpr double kVariousAngle = -360;

/// Text of a field if the pieces differ.
QString variousText();

/// The common value; empty if the pieces differ or there are none.
template <class ValueOf>
auto sharedValue(const std::vector<int>& pieces, const ValueOf& valueOf)
    -> std::optional<decltype(valueOf(0))> {
    if (pieces.empty()) {
        return std::nullopt;
    }
    const auto first = valueOf(pieces.front());
    for (const int piece : pieces) {
        if (!(valueOf(piece) == first)) {
            return std::nullopt;
        }
    }
    return first;
}

/// The common angle, radians; empty if the angles differ by more than rounding.
std::optional<double> sharedAngle(const std::vector<double>& angles);

/// Sets up a field for angles from -180° to 180°, or for angles that differ.
void dressAngle(AngleEdit& field);
/// @param any  false if there are no pieces; the field is then blank
void showAngle(AngleEdit& field, std::optional<double> radians, bool any);
/// @param any  false if there are no pieces; the box is then empty
void showChecked(QCheckBox& box, std::optional<bool> checked, bool any);

/// True if the user is typing in the field, so that it must not be overwritten.
bool isTypedIn(const QLineEdit& field);
bool isTypedIn(const QAbstractSpinBox& field);

/// Makes a field for the side panels: wide enough for numbers, and with an object name.
template <class Field>
Field* makeField(FieldGuard& guard, const char* name, const QString& label, QWidget* parent) {
    auto* field = new Field(parent);
    field->setObjectName(name);
    field->setAccessibleName(label);
    field->setFocusPolicy(Qt::StrongFocus);
    field->setMinimumWidth(96);
    guard.install(*field);
    return field;
}

}  // namespace toile::app
