// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/option_form.h"

#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>

namespace toile::app {

namespace {

FieldValue valueOf(const FormatOption& row, const ExportOptions& options) {
    const std::string text = row.get(options);
    if (row.isSwitch) {
        return {text == "on" ? 1.0 : 0.0};
    }
    if (row.words.empty()) {
        return {QString::fromStdString(text).toDouble()};
    }
    const auto word = std::ranges::find(row.words, text);
    return {word == row.words.end() ? std::nullopt
                                    : std::optional<double>(word - row.words.begin())};
}

std::string textOf(const FormatOption& row, const FieldValue& value) {
    const double number = value.number.value_or(0);
    return row.isSwitch        ? (number > 0 ? "on" : "off")
           : row.words.empty() ? QString::number(number, 'g', 10).toStdString()
                               : row.words[static_cast<std::size_t>(number)];
}

/// Describes the options of a format as settings.
auto fieldsOf(FormatId format) {
    return [format](FieldVisitor& at, ExportOptions& options) {
        for (const FormatOption& row : formatOptions()) {
            if (std::ranges::find(row.formats, format) != row.formats.end()) {
                using Kind = SettingField::Kind;
                FieldValue value = valueOf(row, options);
                const Setting setting{row.name, row.title, row.title,      row.help,
                                      nullptr,  row.names, Quantity::Count};
                const Kind kind = row.isSwitch        ? Kind::Switch
                                  : row.words.empty() ? Kind::Number
                                                      : Kind::Choice;
                if (at.visit(setting, value, kind, false, row.least, row.most)) {
                    row.set(options, textOf(row, value));
                }
            }
        }
    };
}

}  // namespace

OptionForm::OptionForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void OptionForm::show(FormatId format, const ExportOptions& options) {
    options_ = options;
    const auto describe = fieldsOf(format);
    fields_.emplace(
        *this, [] { return -1; },
        [this, describe](const SettingChange& change) {
            options_ = fields_->changed(describe, options_, change);
            fields_->show(describe, options_);  // one option may affect others
            emit optionsChanged();
        });
    while (form_->rowCount() > 0) {
        form_->removeRow(0);
    }
    fields_->make(describe, {}, options_);
    for (const FormatOption& row : formatOptions()) {
        if (std::ranges::find(row.formats, format) != row.formats.end()) {
            fields_->addRow(*form_, row.name);
            if (auto* label = qobject_cast<QLabel*>(form_->labelForField(&fields_->at(row.name)))) {
                label->setText(label->text() + ':');
            }
        }
    }
}

PieceChoice::PieceChoice(QWidget* parent) : QComboBox(parent) {
    setAccessibleName(tr("Pieces"));
    setToolTip(tr("Pieces to include"));
    hide();
    connect(this, &QComboBox::currentIndexChanged, this, &PieceChoice::chosen);
}

void PieceChoice::offer(int selected, bool chosen) {
    const QSignalBlocker quiet(this);
    clear();
    addItems({tr("All pieces"), tr("Selected pieces (%1)").arg(selected)});
    setCurrentIndex(chosen && selected > 0 ? 1 : 0);
    setVisible(selected > 0);
}

}  // namespace toile::app
