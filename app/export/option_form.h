// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/formats/formats.h"

class QFormLayout;

namespace toile::app {

/// The choices of one format, a row each, as the table of formats has them.
class OptionForm : public QWidget {
    Q_OBJECT

public:
    explicit OptionForm(QWidget* parent = nullptr);

    /// Shows the choices of this format. @param options  of all formats
    void show(FormatId format, const ExportOptions& options);
    const ExportOptions& options() const { return options_; }

signals:
    void optionsChanged();

private:
    QWidget* makeField(const FormatOption& row);
    void take(const FormatOption& row, const std::string& value);
    /// A choice may change what others are.
    void showValues();

    QFormLayout* form_;
    ExportOptions options_;
    std::vector<std::pair<const FormatOption*, QWidget*>> fields_;
    bool isShowing_ = false;
};

}  // namespace toile::app
