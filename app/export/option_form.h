// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QFormLayout>

#include "app/widgets/setting_fields.h"
#include "core/formats/formats.h"

namespace toile::app {

/// The options of one format, one row each, generated from the table of formats.
class OptionForm : public QWidget {
    Q_OBJECT

public:
    explicit OptionForm(QWidget* parent = nullptr);

    /// @param options  of all formats
    void show(FormatId format, const ExportOptions& options);
    const ExportOptions& options() const { return options_; }

signals:
    void optionsChanged();

private:
    QFormLayout* form_;
    ExportOptions options_;
    std::optional<SettingFields> fields_;
};

/// Chooses all or selected pieces in export and print dialogs.
class PieceChoice : public QComboBox {
    Q_OBJECT

public:
    /// Hidden until `offer` is called.
    explicit PieceChoice(QWidget* parent);

    /// Hides the choice if no piece is selected. @param chosen  initially the selected ones
    void offer(int selected, bool chosen);
    bool isSelectedOnly() const { return currentIndex() == 1; }

signals:
    void chosen();
};

}  // namespace toile::app
