// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/widgets/number_edits.h"

namespace toile::app {

/// A field for an optional number with a unit. If the user empties it, the number is unset and the
/// field shows the default: "As the fabric: 34 N/m". Set numbers are bold.
class StatedEdit : public NumberEdit {
    Q_OBJECT

public:
    /// @param unstated  "As the fabric"
    StatedEdit(double least, double most, const QString& unit, const QString& unstated,
               QWidget* parent = nullptr);

    /// `value()` within the limits; none if no number is set.
    std::optional<double> stated() const;
    /// Emits no signals. @param usual  the default; none if it varies
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
