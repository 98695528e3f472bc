// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace toile {

/// A field for an angle, in degrees with the sign: "45°", "90 - 12,5". Goes round at its ends.
class AngleEdit : public QDoubleSpinBox {
    Q_OBJECT

public:
    /// Range -180° to 180° until set otherwise.
    explicit AngleEdit(QWidget* parent = nullptr);

    double radians() const;
    void setRadians(double angle);

    QString textFromValue(double degrees) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& at) const override;
};

}  // namespace toile
