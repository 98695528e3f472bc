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

namespace toile {

using Json = nlohmann::ordered_json;

/// The numbers of a list; none where it is anything but so many finite numbers.
std::optional<std::vector<double>> numbersOf(const Json& json, std::size_t count);

/// What was found wrong in a document while it was read.
struct JsonFaults {
    std::string first;                 ///< what is wrong and where; empty: nothing
    std::vector<std::string> unknown;  ///< places that nobody asked for
};

/// Reads the fields of one JSON object, each with its type: the first thing that is wrong is kept
/// with its place ("pieces.front.quantity"), and what comes after is left as it is. A field that is
/// not there leaves its target as it is. Fields that nobody asked for are noted at the end.
class JsonFields {
public:
    /// `json` and `faults` must outlive this. Anything but an object is a fault.
    JsonFields(const Json& json, std::string place, JsonFaults& faults);
    ~JsonFields();
    JsonFields(const JsonFields&) = delete;
    JsonFields& operator=(const JsonFields&) = delete;

    bool failed() const { return !faults_.first.empty(); }
    const std::string& place() const { return place_; }
    std::string placeOf(std::string_view key) const;
    void fail(std::string_view key, std::string_view what);
    JsonFaults& faults() { return faults_; }

    /// The field; null where it is not there or something is wrong already.
    const Json* find(std::string_view key);
    /// The same; not to be there is a fault.
    const Json* need(std::string_view key);
    /// Every field, whatever its name.
    const Json& all();

    void read(std::string_view key, bool& value);
    void read(std::string_view key, std::string& value);
    /// @param least, most  what the number may be, both included
    void read(std::string_view key, double& value,
              double least = std::numeric_limits<double>::lowest(),
              double most = std::numeric_limits<double>::max());
    void read(std::string_view key, int& value, int least, int most);
    void read(std::string_view key, std::optional<double>& value, double least, double most);
    /// `count` numbers.
    /// @param most  of what size each may be, either sign
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count,
                                               double most = std::numeric_limits<double>::max());

    /// A word that `parse` knows.
    /// @param words  for the message: "\"mm\" or \"cm\""
    template <class Value, class Parse>
    void readWord(std::string_view key, Value& value, std::string_view words, const Parse& parse) {
        if (const Json* json = find(key)) {
            const auto known = json->is_string() ? parse(json->template get<std::string>())
                                                 : decltype(parse(std::string())){};
            if (known) {
                value = *known;
            } else {
                fail(key, "must be " + std::string(words));
            }
        }
    }

private:
    const Json& json_;
    std::string place_;
    JsonFaults& faults_;
    std::set<std::string, std::less<>> known_;
    bool takesAll_ = false;
};

}  // namespace toile
