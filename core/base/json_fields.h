// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/base/wording.h"

namespace toile {

/// A document for reading: keys are looked up in log n, however many there are.
using JsonDocument = nlohmann::json;
/// A document for writing: its keys stay in order.
using OrderedJson = nlohmann::ordered_json;

/// Parses a text. Linear.
/// @param name, malformed  of the file and of the error to return
Result<JsonDocument> parseJson(std::string_view text, const std::string& name, ErrorCode malformed);

/// A document as text. Names come from files: bytes that are not UTF-8 become U+FFFD.
std::string jsonText(const OrderedJson& json);

/// The numbers of a list; nothing unless it holds exactly `count` finite numbers.
std::optional<std::vector<double>> numbersOf(const JsonDocument& json, std::size_t count);

/// Faults found in a document while it was read.
struct JsonFaults {
    std::string first;                 ///< the first fault and its place; empty: none
    std::vector<std::string> unknown;  ///< places of unknown fields

    /// The UnknownKey note of the file of this name, if there is one.
    Problems notes(const std::string& name) const;
};

/// Reads the fields of one JSON object, each with its type: the first fault is stored with its
/// place ("pieces.front.quantity"), and later fields are left unchanged. A missing field leaves its
/// target unchanged. Unknown fields are noted at the end.
class JsonFields {
public:
    /// `json` and `faults` must outlive this. Anything but an object is a fault.
    JsonFields(const JsonDocument& json, std::string place, JsonFaults& faults);
    ~JsonFields();
    JsonFields(const JsonFields&) = delete;
    JsonFields& operator=(const JsonFields&) = delete;

    bool failed() const { return !faults_.first.empty(); }
    const std::string& place() const { return place_; }
    std::string placeOf(std::string_view key) const;
    void fail(std::string_view key, std::string_view what) { failAt(placeOf(key), what); }
    void failAt(const std::string& place, std::string_view what);
    /// The field; null if it is missing or a fault was found before.
    const JsonDocument* find(std::string_view key);
    /// The same; a missing field is a fault.
    const JsonDocument* need(std::string_view key);
    /// Every field, whatever its name.
    const JsonDocument& all();

    void read(std::string_view key, bool& value);
    void read(std::string_view key, std::string& value);
    /// @param least, most  range of the number, both included
    void read(std::string_view key, double& value,
              double least = std::numeric_limits<double>::lowest(),
              double most = std::numeric_limits<double>::max());
    void read(std::string_view key, int& value, int least, int most);
    void read(std::string_view key, std::optional<double>& value, double least, double most);
    void read(std::string_view key, std::optional<int>& value, int least, int most);
    void read(std::string_view key, std::optional<FileUnit>& unit);
    /// `count` numbers.
    /// @param most  largest absolute value of each
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count,
                                               double most = std::numeric_limits<double>::max());

    /// Each entry of a list, with its place; read(entry, place).
    template <class Read>
    void readEach(std::string_view key, const Read& read) {
        const JsonDocument* list = find(key);
        if (list && !list->is_array()) {
            fail(key, "must be a list");
        }
        for (std::size_t i = 0; list && i < list->size() && !failed(); ++i) {
            read((*list)[i], placeOf(key) + "[" + std::to_string(i) + "]");
        }
    }

    /// Each entry of a list of objects; read(fields).
    template <class Read>
    void readObjects(std::string_view key, const Read& read) {
        readEach(key, [&](const JsonDocument& json, const std::string& place) {
            JsonFields fields(json, place, faults_);
            read(fields);
        });
    }

    /// Reads the object if it is present; read(fields).
    template <class Read>
    void readObject(std::string_view key, const Read& read) {
        if (const JsonDocument* json = find(key)) {
            JsonFields fields(*json, placeOf(key), faults_);
            read(fields);
        }
    }

    /// A word that `parse` knows.
    /// @param words  for the message: "\"mm\" or \"cm\""
    template <class Value, class Parse>
    void readWord(std::string_view key, Value& value, std::string_view words, const Parse& parse) {
        if (const JsonDocument* json = find(key)) {
            const auto known = json->is_string() ? parse(json->template get<std::string>())
                                                 : decltype(parse(std::string())){};
            if (known) {
                value = *known;
            } else {
                fail(key, "must be " + std::string(words));
            }
        }
    }

    template <class Value, std::size_t n>
    void readWord(std::string_view key, Value& value, const Word<Value> (&words)[n]) {
        readWord(key, value, wordList(words),
                 [&words](std::string_view text) { return parseWord(words, text); });
    }

private:
    const JsonDocument& json_;
    std::string place_;
    JsonFaults& faults_;
    std::set<std::string, std::less<>> known_;
    bool takesAll_ = false;
};

}  // namespace toile
