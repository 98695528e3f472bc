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

/// How a field shows one value for several pieces: what all have, or that they differ.

/// Stands for angles that differ, degrees.
inline constexpr double kVariousAngle = -360;

/// What fields say where the pieces differ.
QString variousText();

/// What all have; nothing where they differ or there are none.
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

/// The one of these angles, radians; nothing where they differ by more than rounding.
std::optional<double> sharedAngle(const std::vector<double>& angles);

/// A field for angles from -180° to 180° that may differ.
void dressAngle(AngleEdit& field);
/// @param any  there are pieces; else the field is blank
void showAngle(AngleEdit& field, std::optional<double> radians, bool any);
/// @param any  there are pieces; else the box is empty
void showChecked(QCheckBox& box, std::optional<bool> checked, bool any);

/// Whether a person is typing there, so that it must not be written over.
bool isTypedIn(const QLineEdit& field);
bool isTypedIn(const QAbstractSpinBox& field);

/// A field as the panels beside the views have them: as wide as numbers take, found by its name.
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
