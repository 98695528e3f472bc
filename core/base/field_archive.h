// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/base/id.h"
#include "core/base/json_fields.h"

namespace toile {

/// Describes the fields of a file once for reading and writing: a description, `[](auto& at, auto&
/// thing)`, names the fields of a thing, and `at` reads them from a document (FieldReader) or
/// writes them to one (FieldWriter; the thing is const then). Empty values are omitted.

/// Reads fields from a document. A missing field leaves its target unchanged.
class FieldReader {
public:
    static constexpr bool kReads = true;
    explicit FieldReader(JsonFields& fields) : fields_(fields) {}

    void need(std::string_view key) { fields_.need(key); }
    void fail(std::string_view key, std::string_view what) { fields_.fail(key, what); }
    JsonFields& fields() { return fields_; }
    /// Sets the value that a following field keeps if it is missing.
    template <class Value>
    void unlessStated(Value& value, const Value& usual) {
        value = usual;
    }

    /// @param limits  as of JsonFields::read
    template <class Value, class... Limits>
    void field(std::string_view key, Value& value, Limits... limits) {
        fields_.read(key, value, limits...);
    }
    void text(std::string_view key, std::string& value) { fields_.read(key, value); }
    void texts(std::string_view key, std::vector<std::string>& values) {
        fields_.readEach(key, [&](const JsonDocument& json, const std::string& place) {
            if (json.is_string()) {
                values.push_back(json.template get<std::string>());
            } else {
                fields_.failAt(place, "must be a string");
            }
        });
    }
    template <class Kind>
    void id(std::string_view key, Id<Kind>& id) {
        fields_.readWord(key, id.value, "16 hexadecimal digits", parseId);
    }
    template <class Value, std::size_t n>
    void word(std::string_view key, Value& value, const Word<Value> (&words)[n]) {
        fields_.readWord(key, value, words);
    }
    template <class Value, std::size_t n>
    void word(std::string_view key, std::optional<Value>& value, const Word<Value> (&words)[n]) {
        if (fields_.find(key)) {
            fields_.readWord(key, value.emplace(), words);
        }
    }
    /// @param words  for the message
    template <class Value, class Parse>
    void word(std::string_view key, Value& value, std::string_view words, const Parse& parse) {
        fields_.readWord(key, value, words, parse);
    }
    template <class Value, class Parse>
    void word(std::string_view key, std::optional<Value>& value, std::string_view words,
              const Parse& parse) {
        if (fields_.find(key)) {
            fields_.readWord(key, value.emplace(), words, parse);
        }
    }
    template <int n>
    void point(std::string_view key, Eigen::Matrix<double, n, 1>& point, double most = HUGE_VAL) {
        if (const auto numbers = fields_.numbers(key, n, most)) {
            point = Eigen::Map<const Eigen::Matrix<double, n, 1>>(numbers->data());
        }
    }
    template <int n>
    void point(std::string_view key, std::optional<Eigen::Matrix<double, n, 1>>& point) {
        if (fields_.find(key)) {
            this->point(key, point.emplace(Eigen::Matrix<double, n, 1>::Zero()));
        }
    }
    template <class Thing, class Describe>
    void object(std::string_view key, Thing& thing, const Describe& describe) {
        fields_.readObject(key, [&](JsonFields& inner) {
            FieldReader at(inner);
            describe(at, thing);
        });
    }
    template <class Thing, class Describe>
    void object(std::string_view key, std::optional<Thing>& thing, const Describe& describe) {
        fields_.readObject(key, [&](JsonFields& inner) {
            FieldReader at(inner);
            describe(at, thing.emplace());
        });
    }
    template <class Thing, class Describe>
    void list(std::string_view key, std::vector<Thing>& things, const Describe& describe) {
        fields_.readObjects(key, [&](JsonFields& inner) {
            FieldReader at(inner);
            describe(at, things.emplace_back());
        });
    }

private:
    JsonFields& fields_;
};

/// Writes fields to a document, in the order of the calls.
class FieldWriter {
public:
    static constexpr bool kReads = false;
    explicit FieldWriter(OrderedJson& json) : json_(json) { json_ = OrderedJson::object(); }

    void need(std::string_view) {}
    void fail(std::string_view, std::string_view) {}
    OrderedJson& json() { return json_; }
    template <class Value>
    void unlessStated(const Value&, const Value&) {}

    template <class Value, class... Limits>
    void field(const char* key, const Value& value, Limits...) {
        json_[key] = value;
    }
    template <class Value, class... Limits>
    void field(const char* key, const std::optional<Value>& value, Limits...) {
        if (value) {
            json_[key] = *value;
        }
    }
    void field(const char* key, const std::optional<FileUnit>& unit) {
        if (unit) {
            json_[key] = unitText(*unit);
        }
    }
    /// Omitted if empty.
    void text(const char* key, const std::string& value) {
        if (!value.empty()) {
            json_[key] = value;
        }
    }
    /// Omitted if empty.
    void texts(const char* key, const std::vector<std::string>& values) {
        if (!values.empty()) {
            json_[key] = values;
        }
    }
    template <class Kind>
    void id(const char* key, Id<Kind> id) {
        if (id) {
            json_[key] = idText(id);
        }
    }
    template <class Value, std::size_t n>
    void word(const char* key, const Value& value, const Word<Value> (&words)[n]) {
        json_[key] = wordOf(words, value);
    }
    template <class Value, std::size_t n>
    void word(const char* key, const std::optional<Value>& value, const Word<Value> (&words)[n]) {
        if (value) {
            json_[key] = wordOf(words, *value);
        }
    }
    template <class Value, class Parse>
    void word(const char* key, const Value& value, std::string_view, const Parse&) {
        json_[key] = name(value);
    }
    template <class Value, class Parse>
    void word(const char* key, const std::optional<Value>& value, std::string_view, const Parse&) {
        if (value) {
            json_[key] = name(*value);
        }
    }
    template <int n>
    void point(const char* key, const Eigen::Matrix<double, n, 1>& point, double = 0) {
        json_[key] = std::vector<double>(point.begin(), point.end());
    }
    template <int n>
    void point(const char* key, const std::optional<Eigen::Matrix<double, n, 1>>& point) {
        if (point) {
            this->point(key, *point);
        }
    }
    template <class Thing, class Describe>
    void object(const char* key, const Thing& thing, const Describe& describe) {
        FieldWriter at(json_[key]);
        describe(at, thing);
    }
    template <class Thing, class Describe>
    void object(const char* key, const std::optional<Thing>& thing, const Describe& describe) {
        if (thing) {
            object(key, *thing, describe);
        }
    }
    template <class Thing, class Describe>
    void list(const char* key, const std::vector<Thing>& things, const Describe& describe) {
        OrderedJson& list = json_[key] = OrderedJson::array();
        for (const Thing& thing : things) {
            FieldWriter at(list.emplace_back());
            describe(at, thing);
        }
    }

private:
    OrderedJson& json_;
};

}  // namespace toile
