// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace toile::app {

/// A field for a number that is shown rounded: what was not typed is not changed by that.
class NumberEdit : public QDoubleSpinBox {
    Q_OBJECT

public:
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& at) const override;

protected:
    explicit NumberEdit(QWidget* parent);

    /// What was typed, in the unit of `value`; none where it is not understood.
    virtual std::optional<double> parsed(const QString& text) const = 0;
};

/// An angle, in degrees with the sign: "45°", "90 - 12,5". Goes round at its ends.
class AngleEdit : public NumberEdit {
    Q_OBJECT

public:
    /// Range -180° to 180° until set otherwise.
    explicit AngleEdit(QWidget* parent = nullptr);

    QString textFromValue(double degrees) const override;

protected:
    std::optional<double> parsed(const QString& text) const override;
};

/// A length. Its value is in millimetres; it is shown in the person's unit, and any length is
/// understood that `parseLength` knows: "12 3/8 in", "2 * 31,4 cm".
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

/// Shows a length without saying that it was typed; bold where a person has stated it.
void showLength(LengthEdit& field, double millimetres, bool isStated);

/// A percentage with a sign: "+2.5 %", "−1 %". Its value is in percent. Typed with either decimal
/// mark, with or without the sign of percent.
class PercentEdit : public NumberEdit {
    Q_OBJECT

public:
    /// Range -100 % to 100 % until set otherwise.
    explicit PercentEdit(QWidget* parent = nullptr);

    QString textFromValue(double percent) const override;

protected:
    std::optional<double> parsed(const QString& text) const override;
};

/// What number fields and lists beside the work must not do: change because somebody scrolls past
/// them, and keep the keys of Undo and Redo once what was typed has been taken, as the step to take
/// back is the document's then.
class FieldGuard : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// From now on; the field is to go no later than this.
    void install(QWidget& field);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace toile::app
