// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace toile {

/// A field for a percentage with a sign: "+2.5 %", "−1 %". Its value is in percent. Typed with
/// either decimal mark, with or without the sign of percent.
class PercentEdit : public QDoubleSpinBox {
    Q_OBJECT

public:
    /// Range -100 % to 100 % until set otherwise.
    explicit PercentEdit(QWidget* parent = nullptr);

    QString textFromValue(double percent) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& at) const override;
};

}  // namespace toile
