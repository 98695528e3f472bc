// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/widgets/number_edits.h"

namespace toile::app {

/// A field for a number that a person may state, in a unit of its own; emptied, it is stated no
/// more and says what holds instead: "As the fabric: 34 N/m". Stated numbers are bold.
class StatedEdit : public NumberEdit {
    Q_OBJECT

public:
    /// @param unstated  "As the fabric"
    StatedEdit(double least, double most, const QString& unit, const QString& unstated,
               QWidget* parent = nullptr);

    /// Of `value()`, within the limits; none where nothing is stated.
    std::optional<double> stated() const;
    /// Says nothing of a change. @param usual  what holds where nothing is stated; none: that
    /// differs from place to place
    void showStated(std::optional<double> stated, std::optional<double> usual);

    QString textFromValue(double number) const override;
    void stepBy(int steps) override;

protected:
    std::optional<double> parsed(const QString& text) const override;

private:
    double least_;
    QString unit_, unstated_;
    std::optional<double> usual_;
};

}  // namespace toile::app
