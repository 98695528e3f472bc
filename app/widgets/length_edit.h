// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace toile {

/// A field for a length. Its value is in millimetres; it is shown in the person's unit, and any
/// length is understood that `parseLength` knows: "12 3/8 in", "2 * 31,4 cm".
class LengthEdit : public QDoubleSpinBox {
    Q_OBJECT

public:
    /// Range 0 mm to 10 m until set otherwise.
    explicit LengthEdit(QWidget* parent = nullptr);

    double millimetres() const { return value(); }
    void setMillimetres(double length) { setValue(length); }

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& at) const override;

private:
    void updateUnit();
};

}  // namespace toile
