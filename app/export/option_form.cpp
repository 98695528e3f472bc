// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/option_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <algorithm>

#include "app/base/text.h"

namespace toile::app {

OptionForm::OptionForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void OptionForm::show(FormatId format, const ExportOptions& options) {
    options_ = options;
    fields_.clear();
    while (form_->rowCount() > 0) {
        form_->removeRow(0);
    }
    for (const FormatOption& row : formatOptions()) {
        if (std::ranges::find(row.formats, format) == row.formats.end()) {
            continue;
        }
        QWidget* field = makeField(row);
        field->setObjectName(row.name);
        field->setToolTip(tr(row.help) + '.');
        const QString title = app::tr(row.title);
        field->setAccessibleName(title);
        if (row.isSwitch) {
            form_->addRow(QString(), field);
        } else {
            form_->addRow(title + ':', field);
        }
        fields_.emplace_back(&row, field);
    }
    showValues();
}

QWidget* OptionForm::makeField(const FormatOption& row) {
    if (row.isSwitch) {
        auto* box = new QCheckBox(app::tr(row.title), this);
        connect(box, &QCheckBox::toggled, this,
                [this, &row](bool on) { take(row, on ? "on" : "off"); });
        return box;
    }
    if (row.words.empty()) {
        auto* number = new QDoubleSpinBox(this);
        number->setRange(row.least, row.most);
        number->setDecimals(0);
        number->setKeyboardTracking(false);
        connect(number, &QDoubleSpinBox::valueChanged, this, [this, &row](double value) {
            take(row, QString::number(value, 'g', 10).toStdString());
        });
        return number;
    }
    auto* combo = new QComboBox(this);
    for (const char* name : row.names) {
        combo->addItem(app::tr(name));
    }
    connect(combo, &QComboBox::activated, this,
            [this, &row](int index) { take(row, row.words[static_cast<std::size_t>(index)]); });
    return combo;
}

void OptionForm::take(const FormatOption& row, const std::string& value) {
    if (isShowing_ || !row.set(options_, value)) {
        return;
    }
    showValues();
    emit optionsChanged();
}

void OptionForm::showValues() {
    const QScopedValueRollback guard(isShowing_, true);
    for (const auto& [row, field] : fields_) {
        const std::string value = row->get(options_);
        if (auto* box = qobject_cast<QCheckBox*>(field)) {
            box->setChecked(value == "on");
        } else if (auto* number = qobject_cast<QDoubleSpinBox*>(field)) {
            number->setValue(QString::fromStdString(value).toDouble());
        } else if (auto* combo = qobject_cast<QComboBox*>(field)) {
            const auto at = std::ranges::find(row->words, value);
            combo->setCurrentIndex(
                at == row->words.end() ? -1 : static_cast<int>(at - row->words.begin()));
        }
    }
}

}  // namespace toile::app
