// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QFormLayout>

#include "app/widgets/setting_fields.h"
#include "core/formats/formats.h"

namespace toile::app {

/// The options of one format, a row each, made from the table of formats.
class OptionForm : public QWidget {
    Q_OBJECT

public:
    explicit OptionForm(QWidget* parent = nullptr);

    /// Shows the options of this format. @param options  of all formats
    void show(FormatId format, const ExportOptions& options);
    const ExportOptions& options() const { return options_; }

signals:
    void optionsChanged();

private:
    QFormLayout* form_;
    ExportOptions options_;
    std::optional<SettingFields> fields_;
};

/// All pieces or the selected ones, for a dialog of export or printing.
class PieceChoice : public QComboBox {
    Q_OBJECT

public:
    /// Hidden until pieces are offered.
    explicit PieceChoice(QWidget* parent);

    /// Hides the choice if no piece is selected. @param chosen  whether to choose the selected ones
    void offer(int selected, bool chosen);
    bool isSelectedOnly() const { return currentIndex() == 1; }

signals:
    void chosen();
};

}  // namespace toile::app
