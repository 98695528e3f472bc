// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/shared_values.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QLineEdit>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "core/base/units.h"
#include "core/layout/arrange.h"

namespace toile::app {

QString variousText() {
    return tr("various");
}

std::optional<double> sharedAngle(const std::vector<double>& angles) {
    constexpr double kSameAngle = 1e-6;  // radians
    const bool isOne = std::ranges::all_of(angles, [&angles](double angle) {
        return std::abs(wrappedAngle(angle - angles.front())) <= kSameAngle;
    });
    return angles.empty() || !isOne ? std::nullopt : std::optional(angles.front());
}

void dressAngle(AngleEdit& field) {
    field.setRange(kVariousAngle, -kVariousAngle);
    field.setSpecialValueText(variousText());
    field.setWrapping(false);
}

void showAngle(AngleEdit& field, std::optional<double> radians, bool any) {
    const QSignalBlocker quiet(field);
    field.setSpecialValueText(any ? variousText() : QStringLiteral(" "));
    field.setValue(radians ? wrappedAngle(*radians) / kDegree : kVariousAngle);
}

void showChecked(QCheckBox& box, std::optional<bool> checked, bool any) {
    const bool mixed = any && !checked;
    box.setTristate(mixed);
    box.setCheckState(mixed                     ? Qt::PartiallyChecked
                      : checked.value_or(false) ? Qt::Checked
                                                : Qt::Unchecked);
}

bool isTypedIn(const QLineEdit& field) {
    return field.hasFocus() && field.isModified();
}

bool isTypedIn(const QAbstractSpinBox& field) {
    const auto* line = field.findChild<const QLineEdit*>();
    return field.hasFocus() && line && line->isModified();
}

}  // namespace toile::app
