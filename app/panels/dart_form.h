// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/widgets/setting_fields.h"
#include "core/pattern/dart_places.h"

namespace toile::app {

class Document;

/// Settings of the selected dart: its intake as a length or as the angle at its tip, and the side
/// that it is folded to. Hidden if no dart is selected.
class DartForm : public QWidget {
    Q_OBJECT

public:
    explicit DartForm(Document& document, QWidget* parent = nullptr);

    /// Shows the selection.
    void refresh();

private:
    void makeLayout();
    /// Width of the dart on the flat piece, mm.
    std::optional<double> drawnIntake() const;
    /// The dart with the lengths that its legs have in the pattern.
    DartPlace asDrawn() const;
    void showSettings();
    void take(const SettingChange& change);
    void setIntake(std::optional<double> intake);
    /// Returns why these legs cannot form a dart of this intake; empty if they can.
    QString refusalOf(double intake) const;

    Document& document_;
    SettingFields fields_;
    QLabel *title_, *legs_, *refusal_;
    AngleEdit* angle_;
    int dart_ = -1;      ///< index into Garment::seams
    DartPlace place_{};  ///< in 3D
    DartPlace drawn_{};  ///< the same in the pattern
};

}  // namespace toile::app
