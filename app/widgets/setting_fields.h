// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/widgets/number_edits.h"
#include "core/base/setting.h"
#include "core/base/wording.h"

class QFormLayout;
class QGridLayout;
class QLabel;
class QToolButton;

namespace toile::app {

/// The value of a setting in a form: a number, the row of a choice, 0 or 1 of a switch, or a text.
struct FieldValue {
    std::optional<double> number{};  ///< none: not set
    std::string text{};

    bool operator==(const FieldValue&) const = default;
};

/// A field of a description that has a `Setting`.
struct SettingField {
    enum class Kind { Number, Switch, Choice, Text, Group };

    Setting setting;
    std::string path;   ///< "allowance.seam"
    std::string group;  ///< "allowance"; empty at the top
    Kind kind = Kind::Number;
    double least = 0, most = 0;
    bool isOptional = false;
    bool isInForce = true;  ///< false: its group is switched off
};

/// Visits the fields of a thing that have a `Setting`. `use` sees each value and may change it.
class FieldVisitor {
public:
    using Use = std::function<void(const SettingField& field, FieldValue& value)>;
    static constexpr bool kReads = true;
    /// A key without a Setting.
    struct FileKey {
        const char* text;
        FileKey(const char* key) : text(key) {}
    };

    explicit FieldVisitor(const Use& use, std::string group = {}, bool isInForce = true)
        : use_(use), group_(std::move(group)), isInForce_(isInForce) {}

    template <class Number>
    void field(const Setting& setting, Number& value, double least = 0, double most = 1) {
        if (setting.unset) {  // 0 means not set
            std::optional<double> set = value > 0 ? std::optional<double>(value) : std::nullopt;
            field(setting, set, least, most);
            value = static_cast<Number>(set.value_or(0));
            return;
        }
        const auto kind =
            std::is_same_v<Number, bool> ? SettingField::Kind::Switch : SettingField::Kind::Number;
        FieldValue shown{static_cast<double>(value)};
        if (visit(setting, shown, kind, false, least, most)) {
            value = static_cast<Number>(shown.number.value_or(0));
        }
    }
    template <class Number>
    void field(const Setting& setting, std::optional<Number>& value, double least, double most) {
        FieldValue shown{value};
        if (visit(setting, shown, SettingField::Kind::Number, true, least, most)) {
            value = shown.number;
        }
    }
    template <class Value, std::size_t n>
    void word(const Setting& setting, Value& value, const Word<Value> (&words)[n]) {
        FieldValue shown{double(std::ranges::find(words, value, &Word<Value>::first) - words)};
        if (visit(setting, shown, SettingField::Kind::Choice, false)) {
            value = words[static_cast<std::size_t>(shown.number.value_or(0))].first;
        }
    }
    template <class Value, std::size_t n>
    void word(const Setting& setting, std::optional<Value>& value, const Word<Value> (&words)[n]) {
        FieldValue shown;
        if (value) {
            shown.number = double(std::ranges::find(words, *value, &Word<Value>::first) - words);
        }
        if (visit(setting, shown, SettingField::Kind::Choice, true)) {
            value.reset();
            if (shown.number) {
                value = words[static_cast<std::size_t>(*shown.number)].first;
            }
        }
    }
    void text(const Setting& setting, std::string& value) {
        FieldValue shown{{}, value};
        if (visit(setting, shown, SettingField::Kind::Text, false)) {
            value = shown.text;
        }
    }
    template <class Thing, class Describe>
    void object(FileKey key, Thing& thing, const Describe& describe) {
        FieldVisitor inner(use_, pathOf(key.text), isInForce_);
        describe(inner, thing);
    }
    /// A group of fields that a switch turns on.
    template <class Thing, class Describe>
    void object(const Setting& setting, std::optional<Thing>& thing, const Describe& describe) {
        const bool wasThere = thing.has_value();
        FieldValue isThere{wasThere ? 1.0 : 0.0};
        visit(setting, isThere, SettingField::Kind::Group, false);
        Thing inside = thing.value_or(Thing{});
        FieldVisitor inner(use_, pathOf(setting.key), wasThere);
        describe(inner, inside);
        thing = isThere.number == 1 ? std::optional(std::move(inside)) : std::nullopt;
    }
    template <class Thing, class Describe>
    void object(FileKey, std::optional<Thing>&, const Describe&) {}

    /// Visits a value in form representation. @return  whether it was changed
    bool visit(const Setting& setting, FieldValue& value, SettingField::Kind kind, bool isOptional,
               double least = 0, double most = 0);

    // Members that only files have.
    void need(FileKey) {}
    template <class... Any>
    void fail(FileKey, Any&&...) {}
    template <class... Any>
    void id(FileKey, Any&&...) {}
    template <class... Any>
    void list(FileKey, Any&&...) {}
    template <class... Any>
    void point(FileKey, Any&&...) {}
    template <class... Any>
    void field(FileKey, Any&&...) {}
    template <class... Any>
    void word(FileKey, Any&&...) {}
    template <class... Any>
    void text(FileKey, Any&&...) {}
    template <class... Any>
    void texts(FileKey, Any&&...) {}

private:
    std::string pathOf(const char* key) const { return group_.empty() ? key : group_ + '.' + key; }
    const Use& use_;
    std::string group_;
    bool isInForce_;
};

/// Parts of a form that its settings do not describe: a title in bold, a note in a faint colour,
/// and a button with text.
QLabel* makeHeading(const QString& text, QWidget* parent);
QLabel* makeNote(const char* objectName, QWidget* parent);
QToolButton* makeButton(const char* objectName, const QString& text, const QString& tip,
                        QWidget* parent);

/// The user's change of a setting.
struct SettingChange {
    std::string path;
    FieldValue value;
    QString text;  ///< name of the undo step
    int gesture;   ///< as for Document::edit
};

/// The fields of a form, built from descriptions of settings. Each has an object name (prefix and
/// path: "segmentLength"), a tool tip and an accessible name. Values set by the user are bold and
/// have a button that removes them. Typing in a field is one gesture until the field is entered
/// again.
class SettingFields : public QObject {
    Q_OBJECT

public:
    /// @param newGesture  as Document::newGesture
    SettingFields(QWidget& form, std::function<int()> newGesture,
                  std::function<void(const SettingChange&)> taken);

    /// Creates the fields of a thing, without a layout.
    template <class Thing, class Describe>
    void make(const Describe& describe, const QString& prefix, Thing thing = {}) {
        const FieldVisitor::Use use = [&](const SettingField& field, FieldValue& value) {
            add(field, prefix);
            show(rows_.at(field.path).of, value, {});
        };
        FieldVisitor at(use);
        describe(at, thing);
    }
    /// @param usual  values of optional fields that are not set
    template <class Thing, class Describe>
    void show(const Describe& describe, Thing thing, Thing usual = {}) {
        std::map<std::string, FieldValue> values;
        const FieldVisitor::Use keep = [&](const SettingField& field, const FieldValue& value) {
            values[field.path] = value;
        };
        FieldVisitor kept(keep);
        describe(kept, usual);
        const FieldVisitor::Use use = [&](const SettingField& field, const FieldValue& value) {
            show(field, value, values[field.path]);
        };
        FieldVisitor at(use);
        describe(at, thing);
    }
    /// Applies a change to the thing. A group that is switched on takes the values of its fields.
    template <class Thing, class Describe>
    Thing changed(const Describe& describe, Thing thing, const SettingChange& change) const {
        const FieldVisitor::Use use = [&](const SettingField& field, FieldValue& value) {
            apply(change, field, value);
        };
        FieldVisitor at(use);
        describe(at, thing);
        return thing;
    }

    /// Starts another undo step.
    void startGesture() { gesture_ = newGesture_(); }
    int gesture() const { return gesture_; }
    /// The field of a path: "allowance.seam". Precondition: it exists, and is a Field.
    template <class Field = QWidget>
    Field& at(const std::string& path) const {
        return *static_cast<Field*>(rows_.at(path).field);
    }
    /// Limits a number field to less than its setting allows, in its own unit.
    void setRange(const std::string& path, double least, double most);
    /// Label, field and reset button, if there is one, in three columns.
    void addRow(QGridLayout& grid, const std::string& path, int row, int column = 0);
    void addRow(QFormLayout& form, const std::string& path);
    /// Rows of the fields that have none yet, in the order of their description, so that a new
    /// setting appears without an edit of the form.  @return the next row
    int addRemainingRows(QGridLayout& grid, int row);
    /// Makes another field of the form behave like these.
    void dress(QWidget& field, const QString& objectName, const QString& name, const QString& help);
    void setShown(const std::string& path, bool shown);
    void setEnabled(const std::string& path, bool enabled);
    void setEnabled(bool enabled);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Row {
        SettingField of;
        QWidget* field;
        QWidget* label = nullptr;  ///< a check box, if the setting has a switch
        QToolButton* reset = nullptr;
        bool isSet = false, hasRow = false;

        FieldValue value() const;
    };

    void add(const SettingField& of, const QString& prefix);
    QWidget* makeField(const SettingField& of);
    QDoubleSpinBox* makeNumber(const SettingField& of);
    /// Creates the label if there is none yet; null for a switch.
    QWidget* labelOf(Row& row);
    void show(const SettingField& of, const FieldValue& value, const FieldValue& usual);
    void apply(const SettingChange& change, const SettingField& of, FieldValue& value) const;
    void take(const Row& row, const FieldValue& value, bool isTyped);

    QWidget& form_;
    FieldGuard guard_;
    std::function<int()> newGesture_;
    std::function<void(const SettingChange&)> taken_;
    std::map<std::string, Row> rows_;  ///< by path
    std::vector<std::string> order_;   ///< paths as described
    int gesture_ = -1;
};

}  // namespace toile::app
