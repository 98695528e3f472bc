// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/prove/fabric_stiffness.h"

namespace toile::app {

class FieldGuard;
class StatedEdit;

/// How a cloth resists and what it weighs, as far as somebody has measured it.
class StiffnessForm : public QWidget {
    Q_OBJECT

public:
    /// @param guard  must outlive the form
    explicit StiffnessForm(FieldGuard& guard, QWidget* parent = nullptr);

    /// @param usual  of the fabric, which holds where nothing is stated; none: of several
    void showStated(const StatedStiffness& stated, const std::optional<sew::ClothStiffness>& usual);

signals:
    /// Somebody wants it to be so.
    /// @param isFirst  whether the field has been entered since the last
    void wanted(const toile::StatedStiffness& stated, bool isFirst);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// One of them, and its field.
    struct Row {
        std::optional<double> StatedStiffness::*stated;
        double sew::ClothStiffness::*usual;
        double unit;  ///< of the field
        StatedEdit* field;
    };

    void add(const QString& name, const char* objectName, const QString& toolTip, Row row);
    void state(const Row& row);

    FieldGuard& guard_;
    std::vector<Row> rows_;
    StatedStiffness stated_;  ///< as it is shown
    bool isFirst_ = true;
};

}  // namespace toile::app
