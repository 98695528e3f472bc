// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_fields.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/text.h"

namespace toile {
namespace {

// Deeper than any file of ours. The JSON library copies values by recursion, so a text of brackets
// alone would overflow the stack.
constexpr int kMaxDepth = 64;
constexpr std::size_t kUnknownNamed = 3;
constexpr auto kUnits = R"("mm", "cm", "dm", "m", "in" or a length such as "12.5 mm")";

/// Nesting depth of lists and objects; any number if the text is not JSON.
int depthOf(std::string_view text) {
    int depth = 0, deepest = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            i += c == '\\' ? 1 : 0;  // an escaped character does not end the string
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            deepest = std::max(deepest, ++depth);
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return deepest;
}

const JsonDocument& emptyObject() {
    static const JsonDocument kEmpty = JsonDocument::object();
    return kEmpty;
}

bool isFiniteNumber(const JsonDocument& json) {
    return json.is_number() && std::isfinite(json.get<double>());
}

}  // namespace

Result<JsonDocument> parseJson(std::string_view text, const std::string& name,
                               ErrorCode malformed) {
    if (depthOf(text) > kMaxDepth) {
        return Error{malformed, Subject::file(name), "its lists are nested too deeply"};
    }
    try {
        return JsonDocument::parse(text);
    } catch (const JsonDocument::parse_error& error) {
        return Error{malformed, Subject::file(name),
                     "invalid JSON at byte " + std::to_string(error.byte)};
    } catch (const JsonDocument::exception&) {  // a number that no double can represent
        return Error{malformed, Subject::file(name), "a number is out of range"};
    }
}

std::string jsonText(const OrderedJson& json) {
    constexpr int kIndent = 2;
    return json.dump(kIndent, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

Problems JsonFaults::notes(const std::string& name) const {
    if (unknown.empty()) {
        return {};
    }
    return {{ErrorCode::UnknownKey, Subject::file(name), quotedList(unknown, kUnknownNamed)}};
}

std::optional<std::vector<double>> numbersOf(const JsonDocument& json, std::size_t count) {
    if (!json.is_array() || json.size() != count || !std::ranges::all_of(json, isFiniteNumber)) {
        return std::nullopt;
    }
    return json.get<std::vector<double>>();
}

JsonFields::JsonFields(const JsonDocument& json, std::string place, JsonFaults& faults)
    : json_(json.is_object() ? json : emptyObject()), place_(std::move(place)), faults_(faults) {
    if (!json.is_object() && !failed()) {
        faults_.first = (place_.empty() ? "the file" : '"' + place_ + '"') + " must be an object";
    }
}

JsonFields::~JsonFields() {
    if (failed() || takesAll_) {
        return;
    }
    try {
        for (const auto& item : json_.items()) {
            if (!known_.contains(item.key())) {
                faults_.unknown.push_back(placeOf(item.key()));
            }
        }
    } catch (const std::exception&) {  // out of memory: omit a note instead of ending the program
        takesAll_ = true;
    }
}

std::string JsonFields::placeOf(std::string_view key) const {
    return place_.empty() ? std::string(key) : place_ + "." + std::string(key);
}

void JsonFields::failAt(const std::string& place, std::string_view what) {
    if (!failed()) {
        faults_.first = '"' + place + "\" " + std::string(what);
    }
}

const JsonDocument* JsonFields::find(std::string_view key) {
    known_.emplace(key);
    if (failed()) {
        return nullptr;
    }
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
}

const JsonDocument* JsonFields::need(std::string_view key) {
    const JsonDocument* found = find(key);
    if (!found) {
        fail(key, "is missing");
    }
    return found;
}

const JsonDocument& JsonFields::all() {
    takesAll_ = true;
    return failed() ? emptyObject() : json_;
}

void JsonFields::read(std::string_view key, bool& value) {
    if (const JsonDocument* json = find(key)) {
        if (json->is_boolean()) {
            value = json->get<bool>();
        } else {
            fail(key, "must be true or false");
        }
    }
}

void JsonFields::read(std::string_view key, std::string& value) {
    if (const JsonDocument* json = find(key)) {
        if (json->is_string()) {
            value = json->get<std::string>();
        } else {
            fail(key, "must be a string");
        }
    }
}

void JsonFields::read(std::string_view key, double& value, double least, double most) {
    const JsonDocument* json = find(key);
    if (!json) {
        return;
    }
    if (!isFiniteNumber(*json)) {
        fail(key, "must be a number");
    } else if (const double number = json->get<double>(); number < least || number > most) {
        fail(key, "must be a number from " + shortest(least) + " to " + shortest(most));
    } else {
        value = number;
    }
}

void JsonFields::read(std::string_view key, int& value, int least, int most) {
    const JsonDocument* json = find(key);
    if (!json) {
        return;
    }
    const bool whole = json->is_number_integer() &&
                       !(json->is_number_unsigned() &&
                         json->get<std::uint64_t>() > static_cast<std::uint64_t>(most));
    const auto number = whole ? json->get<std::int64_t>() : std::int64_t{0};
    if (!whole || number < least || number > most) {
        fail(key, "must be a whole number from " + std::to_string(least) + " to " +
                      std::to_string(most));
    } else {
        value = static_cast<int>(number);
    }
}

void JsonFields::read(std::string_view key, std::optional<double>& value, double least,
                      double most) {
    if (find(key)) {
        double number = 0;
        read(key, number, least, most);
        value = number;
    }
}

void JsonFields::read(std::string_view key, std::optional<int>& value, int least, int most) {
    if (find(key)) {
        int number = 0;
        read(key, number, least, most);
        value = number;
    }
}

void JsonFields::read(std::string_view key, std::optional<FileUnit>& unit) {
    if (find(key)) {
        FileUnit stated = LengthUnit::Millimetre;
        readWord(key, stated, kUnits, parseFileUnit);
        unit = stated;
    }
}

std::optional<std::vector<double>> JsonFields::numbers(std::string_view key, std::size_t count,
                                                       double most) {
    const JsonDocument* json = find(key);
    if (!json) {
        return std::nullopt;
    }
    auto numbers = numbersOf(*json, count);
    if (!numbers) {
        fail(key, "must be a list of " + counted(static_cast<long long>(count), "number"));
        return std::nullopt;
    }
    if (std::ranges::any_of(*numbers, [most](double number) { return std::abs(number) > most; })) {
        fail(key, "must be numbers from " + shortest(-most) + " to " + shortest(most));
        return std::nullopt;
    }
    return numbers;
}

}  // namespace toile
