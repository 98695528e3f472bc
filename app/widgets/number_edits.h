// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace toile::app {

/// A field for a number that is shown rounded. Rounding does not change a value that was not typed.
class NumberEdit : public QDoubleSpinBox {
    Q_OBJECT

public:
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& at) const override;

protected:
    explicit NumberEdit(QWidget* parent);

    /// The typed number, in the unit of `value`; none if it cannot be parsed.
    virtual std::optional<double> parsed(const QString& text) const = 0;
};

/// An angle in degrees, with the degree sign: "45°", "90 - 12,5". Wraps around at its limits.
class AngleEdit : public NumberEdit {
    Q_OBJECT

public:
    /// Range -180° to 180° until set otherwise.
    explicit AngleEdit(QWidget* parent = nullptr);

    QString textFromValue(double degrees) const override;

protected:
    std::optional<double> parsed(const QString& text) const override;
};

/// A length. Its value is in millimetres and is shown in the display unit. It accepts whatever
/// `parseLength` does: "12 3/8 in", "2 * 31,4 cm".
class LengthEdit : public NumberEdit {
    Q_OBJECT

public:
    /// Range 0 mm to 10 m until set otherwise.
    explicit LengthEdit(QWidget* parent = nullptr);

    QString textFromValue(double millimetres) const override;

protected:
    std::optional<double> parsed(const QString& text) const override;

private:
    void updateUnit();
};

/// Shows a length without emitting signals; bold if the user has set it.
void showLength(LengthEdit& field, double millimetres, bool isStated);

/// A percentage with a sign: "+2.5 %", "−1 %". Its value is in percent. Accepts both decimal marks;
/// the percent sign is optional.
class PercentEdit : public NumberEdit {
    Q_OBJECT

public:
    /// Range -100 % to 100 % until set otherwise.
    explicit PercentEdit(QWidget* parent = nullptr);

    QString textFromValue(double percent) const override;

protected:
    std::optional<double> parsed(const QString& text) const override;
};

/// Keeps number fields and lists from changing when the user scrolls past them. Once a typed value
/// is committed, also leaves Undo and Redo to the document, which has that step.
class FieldGuard : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Takes effect now. The field must not outlive this object.
    void install(QWidget& field);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace toile::app
