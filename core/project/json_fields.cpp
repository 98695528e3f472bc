// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/json_fields.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"

namespace toile {
namespace {

const Json& emptyObject() {
    static const Json kEmpty = Json::object();
    return kEmpty;
}

bool isFiniteNumber(const Json& json) {
    return json.is_number() && std::isfinite(json.get<double>());
}

}  // namespace

std::optional<std::vector<double>> numbersOf(const Json& json, std::size_t count) {
    if (!json.is_array() || json.size() != count || !std::ranges::all_of(json, isFiniteNumber)) {
        return std::nullopt;
    }
    return json.get<std::vector<double>>();
}

JsonFields::JsonFields(const Json& json, std::string place, JsonFaults& faults)
    : json_(json.is_object() ? json : emptyObject()), place_(std::move(place)), faults_(faults) {
    if (!json.is_object() && !failed()) {
        faults_.first = (place_.empty() ? "the file" : '"' + place_ + '"') + " must be an object";
    }
}

JsonFields::~JsonFields() {
    if (failed() || takesAll_) {
        return;
    }
    for (const auto& item : json_.items()) {
        if (!known_.contains(item.key())) {
            faults_.unknown.push_back(placeOf(item.key()));
        }
    }
}

std::string JsonFields::placeOf(std::string_view key) const {
    return place_.empty() ? std::string(key) : place_ + "." + std::string(key);
}

void JsonFields::fail(std::string_view key, std::string_view what) {
    if (!failed()) {
        faults_.first = '"' + placeOf(key) + "\" " + std::string(what);
    }
}

const Json* JsonFields::find(std::string_view key) {
    known_.emplace(key);
    if (failed()) {
        return nullptr;
    }
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
}

const Json* JsonFields::need(std::string_view key) {
    const Json* found = find(key);
    if (!found) {
        fail(key, "is missing");
    }
    return found;
}

const Json& JsonFields::all() {
    takesAll_ = true;
    return failed() ? emptyObject() : json_;
}

void JsonFields::read(std::string_view key, bool& value) {
    if (const Json* json = find(key)) {
        if (json->is_boolean()) {
            value = json->get<bool>();
        } else {
            fail(key, "must be true or false");
        }
    }
}

void JsonFields::read(std::string_view key, std::string& value) {
    if (const Json* json = find(key)) {
        if (json->is_string()) {
            value = json->get<std::string>();
        } else {
            fail(key, "must be a text");
        }
    }
}

void JsonFields::read(std::string_view key, double& value, double least, double most) {
    const Json* json = find(key);
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
    const Json* json = find(key);
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

std::optional<std::vector<double>> JsonFields::numbers(std::string_view key, std::size_t count,
                                                       double most) {
    const Json* json = find(key);
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
