// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/setting_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>

#include "app/base/text.h"
#include "app/widgets/stated_edit.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

using FieldKind = SettingField::Kind;

constexpr int kMinChoiceWidth = 110, kMinNumberWidth = 86, kMaxNumberWidth = 160;  // logical pixels
constexpr int kGroupIndent = 18;

/// Stored value of 1 unit in the field.
double scaleOf(const Setting& setting) {
    switch (setting.quantity) {
        case Quantity::Angle:
            return kDegree;
        case Quantity::Percent:
            return 0.01;
        case Quantity::Other:
            return setting.unitSize;
        default:
            return 1;
    }
}

std::optional<double> scaled(std::optional<double> number, double factor) {
    return number ? std::optional(*number * factor) : std::nullopt;
}

bool isSwitch(FieldKind kind) {
    return kind == FieldKind::Switch || kind == FieldKind::Group;
}

}  // namespace

QLabel* makeHeading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont strong = label->font();
    strong.setWeight(QFont::DemiBold);
    label->setFont(strong);
    return label;
}

QLabel* makeNote(const char* objectName, QWidget* parent) {
    auto* note = new QLabel(parent);
    note->setObjectName(objectName);
    note->setForegroundRole(QPalette::PlaceholderText);
    return note;
}

QToolButton* makeButton(const char* objectName, const QString& text, const QString& tip,
                        QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(objectName);
    button->setText(text);
    button->setToolTip(tip);
    return button;
}

bool FieldVisitor::visit(const Setting& setting, FieldValue& value, SettingField::Kind kind,
                         bool isOptional, double least, double most) {
    const FieldValue before = value;
    use_({setting, pathOf(setting.key), group_, kind, least, most, isOptional, isInForce_}, value);
    return !(value == before);
}

SettingFields::SettingFields(QWidget& form, std::function<int()> newGesture,
                             std::function<void(const SettingChange&)> taken)
    : form_(form), newGesture_(std::move(newGesture)), taken_(std::move(taken)) {}

void SettingFields::dress(QWidget& field, const QString& objectName, const QString& name,
                          const QString& help) {
    field.setObjectName(objectName);
    field.setAccessibleName(name);
    field.setToolTip(help);
    field.setFocusPolicy(Qt::StrongFocus);
    if (qobject_cast<QDoubleSpinBox*>(&field)) {
        field.setMinimumWidth(kMinNumberWidth);
        field.setMaximumWidth(kMaxNumberWidth);
    }
    guard_.install(field);
    field.installEventFilter(this);
}

bool SettingFields::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        startGesture();
    }
    return QObject::eventFilter(watched, event);
}

QDoubleSpinBox* SettingFields::makeNumber(const SettingField& of) {
    const Setting& setting = of.setting;
    const double scale = scaleOf(setting), least = of.least / scale, most = of.most / scale;
    if (setting.unit && of.isOptional) {
        return new StatedEdit(least, most, app::tr(setting.unit), app::tr(setting.unset), &form_);
    }
    QDoubleSpinBox* field = nullptr;
    if (setting.quantity == Quantity::Length) {
        field = new LengthEdit(&form_);
    } else if (setting.quantity == Quantity::Angle) {
        field = new AngleEdit(&form_);
        field->setWrapping(false);
    } else if (setting.quantity == Quantity::Percent) {
        field = new PercentEdit(&form_);
    } else {
        field = new QDoubleSpinBox(&form_);
        field->setKeyboardTracking(false);
        field->setDecimals(setting.quantity == Quantity::Count ? 0 : 1);
        field->setSuffix(setting.unit ? ' ' + app::tr(setting.unit) : QString());
    }
    field->setRange(setting.none ? std::min(0.0, least) : least, most);
    field->setSpecialValueText(setting.none ? app::tr(setting.none) : QString());
    return field;
}

QWidget* SettingFields::makeField(const SettingField& of) {
    const std::string& path = of.path;
    const auto takeValue = [this, path](bool isTyped) {
        const Row& row = rows_.at(path);
        take(row, row.value(), isTyped);
    };
    if (of.kind == FieldKind::Number) {
        QDoubleSpinBox* field = makeNumber(of);
        connect(field, &QDoubleSpinBox::valueChanged, this, [takeValue] { takeValue(true); });
        return field;
    }
    if (isSwitch(of.kind)) {
        auto* box = new QCheckBox(app::tr(of.setting.title), &form_);
        connect(box, &QCheckBox::clicked, this, [takeValue] { takeValue(false); });
        return box;
    }
    if (of.kind == FieldKind::Choice) {
        auto* list = new QComboBox(&form_);
        if (of.isOptional) {
            list->addItem(app::tr(of.setting.unset));
        }
        for (const char* name : of.setting.names) {
            list->addItem(app::tr(name));
        }
        // Long choices may be cut off in a narrow form.
        list->setMinimumWidth(std::min(kMinChoiceWidth, list->minimumSizeHint().width()));
        connect(list, &QComboBox::activated, this, [takeValue] { takeValue(false); });
        return list;
    }
    auto* line = new QLineEdit(&form_);
    line->setMaximumWidth(kMaxNumberWidth);
    connect(line, &QLineEdit::editingFinished, this, [takeValue, line] {
        line->setModified(false);
        takeValue(false);
    });
    return line;
}

void SettingFields::add(const SettingField& of, const QString& prefix) {
    const Setting& setting = of.setting;
    order_.push_back(of.path);
    Row& row = rows_[of.path];
    row.of = of;
    row.of.isInForce = true;
    row.field = makeField(of);
    QString objectName = prefix;
    for (const QString& key : QString::fromStdString(of.path).split('.')) {
        objectName += objectName.isEmpty() ? key : key.left(1).toUpper() + key.mid(1);
    }
    QString help = app::tr(setting.help) + '.';
    if (of.isOptional && of.kind == FieldKind::Number) {
        help += ' ' + (setting.unit ? tr("Clear the field to remove your value.")
                                    : tr("Bold: set by you."));
    }
    dress(*row.field, objectName, app::tr(setting.name), help);
    if (of.kind == FieldKind::Number && of.isOptional && !setting.unit && !setting.none &&
        *setting.unset) {
        row.reset = makeButton(qPrintable(objectName + "Reset"), app::tr(setting.unset),
                               tr("Remove your value"), &form_);
        connect(row.reset, &QToolButton::clicked, this, [this, &row] {
            startGesture();
            take(row, {}, true);
        });
    }
    if (setting.hasSwitch) {
        auto* box = new QCheckBox(app::tr(setting.title), &form_);
        box->setObjectName(objectName + "On");
        box->setToolTip(help);
        connect(box, &QCheckBox::clicked, this,
                [this, &row](bool on) { take(row, on ? row.value() : FieldValue{0.0}, false); });
        row.label = box;
    }
}

QWidget* SettingFields::labelOf(Row& row) {
    if (!row.label && !isSwitch(row.of.kind)) {
        auto* label = new QLabel(app::tr(row.of.setting.title), &form_);
        label->setBuddy(row.field);
        label->setIndent(rows_.contains(row.of.group) ? kGroupIndent : -1);
        row.label = label;
    }
    return row.label;
}

void SettingFields::addRow(QGridLayout& grid, const std::string& path, int row, int column) {
    Row& at = rows_.at(path);
    at.hasRow = true;
    QWidget* label = labelOf(at);
    if (!label) {
        grid.addWidget(at.field, row, column, 1, 2);
        return;
    }
    grid.addWidget(label, row, column);
    const bool isWide =
        qobject_cast<QComboBox*>(at.field) &&
        std::ranges::any_of(rows_, [](const auto& one) -> bool { return one.second.reset; });
    grid.addWidget(at.field, row, column + 1, 1, isWide ? 2 : 1);
    if (at.reset) {
        grid.addWidget(at.reset, row, column + 2);
    }
}

void SettingFields::addRow(QFormLayout& form, const std::string& path) {
    Row& at = rows_.at(path);
    form.addRow(labelOf(at), at.field);
}

int SettingFields::addRemainingRows(QGridLayout& grid, int row) {
    for (const std::string& path : order_) {
        if (!rows_.at(path).hasRow) {
            addRow(grid, path, row++);
        }
    }
    return row;
}

void SettingFields::setRange(const std::string& path, double least, double most) {
    auto& field = at<QDoubleSpinBox>(path);
    const QSignalBlocker quiet(field);
    field.setRange(least, most);
}

void SettingFields::setShown(const std::string& path, bool shown) {
    const Row& at = rows_.at(path);
    for (QWidget* widget : std::initializer_list<QWidget*>{at.label, at.field, at.reset}) {
        if (widget) {
            widget->setVisible(shown);
        }
    }
}

void SettingFields::setEnabled(const std::string& path, bool enabled) {
    const Row& at = rows_.at(path);
    at.field->setEnabled(enabled);
    if (at.of.setting.hasSwitch) {
        at.label->setEnabled(enabled);
    }
    if (at.reset) {
        at.reset->setEnabled(enabled && at.isSet);
    }
}

void SettingFields::setEnabled(bool enabled) {
    for (const auto& [path, row] : rows_) {
        setEnabled(path, enabled);
    }
}

void SettingFields::show(const SettingField& of, const FieldValue& value, const FieldValue& usual) {
    if (!of.isInForce) {
        return;  // keep the value for when the group is switched on
    }
    Row& row = rows_.at(of.path);
    row.isSet = of.isOptional && value.number;
    const double scale = scaleOf(of.setting);
    std::optional<double> number = value.number ? value.number : usual.number;
    const QSignalBlocker quiet(row.field);
    if (auto* box = qobject_cast<QCheckBox*>(row.field)) {
        box->setChecked(value.number == 1);
    } else if (auto* list = qobject_cast<QComboBox*>(row.field)) {
        list->setCurrentIndex(static_cast<int>(value.number.value_or(-1)) +
                              (of.isOptional ? 1 : 0));
    } else if (auto* line = qobject_cast<QLineEdit*>(row.field)) {
        if (!line->hasFocus() || !line->isModified()) {  // else the user is typing
            line->setText(QString::fromStdString(value.text));
        }
    } else if (auto* stated = qobject_cast<StatedEdit*>(row.field)) {
        stated->showStated(scaled(value.number, 1 / scale), scaled(usual.number, 1 / scale));
    } else {
        if (of.setting.hasSwitch) {
            static_cast<QCheckBox*>(row.label)->setChecked(number > 0);
            number = number > 0 ? number : usual.number;
        }
        if (number || of.setting.none) {
            static_cast<QDoubleSpinBox*>(row.field)->setValue(number.value_or(0) / scale);
        }
        QFont font = form_.font();
        font.setBold(row.isSet);
        row.field->setFont(font);
    }
    if (row.reset) {
        row.reset->setEnabled(row.isSet && row.field->isEnabledTo(&form_));
    }
}

FieldValue SettingFields::Row::value() const {
    if (const auto* box = qobject_cast<const QCheckBox*>(field)) {
        return {box->isChecked() ? 1.0 : 0.0};
    }
    if (const auto* list = qobject_cast<const QComboBox*>(field)) {
        const int index = list->currentIndex() - (of.isOptional ? 1 : 0);
        return {index < 0 ? std::nullopt : std::optional<double>(index)};
    }
    if (const auto* line = qobject_cast<const QLineEdit*>(field)) {
        return {{}, line->text().simplified().toStdString()};
    }
    const double scale = scaleOf(of.setting);
    if (const auto* stated = qobject_cast<const StatedEdit*>(field)) {
        return {scaled(stated->stated(), scale)};
    }
    const double number = scale * static_cast<const QDoubleSpinBox*>(field)->value();
    if (of.setting.none && number <= 0 && of.least >= 0) {
        return {of.isOptional ? std::nullopt : std::optional(0.0)};
    }
    return {of.setting.none ? std::max(number, of.least) : number};
}

void SettingFields::take(const Row& row, const FieldValue& value, bool isTyped) {
    const bool isOff = (isSwitch(row.of.kind) || row.of.setting.hasSwitch) && value.number == 0.0;
    const QString name = app::tr(row.of.setting.name);
    taken_({row.of.path, value, isOff ? tr("%1: off").arg(name) : name, isTyped ? gesture_ : -1});
}

void SettingFields::apply(const SettingChange& change, const SettingField& of,
                          FieldValue& value) const {
    const std::string& group = rows_.at(change.path).of.group;
    if (of.path == change.path) {
        value = change.value;
    } else if (of.path == group && of.kind == FieldKind::Group) {
        value.number = 1;  // a value of a group that is off switches it on
    } else if (!of.isInForce && (of.group == change.path || of.group == group)) {
        const Row& row = rows_.at(of.path);
        value = of.isOptional && !row.isSet ? FieldValue{} : row.value();
    }
}

}  // namespace toile::app
