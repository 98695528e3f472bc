// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/serve_request.h"

#include <algorithm>

namespace toile::app {
namespace {

constexpr auto kWrongRequest = "wrong-request";
constexpr auto kLineName = "request";

std::string lineOf(const std::string& id, const char* key, const OrderedJson& json) {
    return R"({"id":)" + id + ",\"" + key +
           "\":" + json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "}\n";
}

/// An id may come back in any answer: a whole number or a short text.
bool isId(const JsonDocument& json) {
    return json.is_number_integer() ||
           (json.is_string() && json.get_ref<const std::string&>().size() <= kMaxServeId);
}

void readId(JsonFields& fields, const char* key, std::string& id) {
    if (const JsonDocument* json = fields.need(key)) {
        if (isId(*json)) {
            id = json->dump(-1, ' ', false, JsonDocument::error_handler_t::replace);
        } else {
            fields.fail(key, "must be a whole number or a string of at most 100 bytes");
        }
    }
}

void readTexts(JsonFields& fields, const char* key, std::vector<std::string>& texts) {
    fields.readEach(key, [&](const JsonDocument& json, const std::string& place) {
        const auto* text = json.get_ptr<const std::string*>();
        if (!text || text->find('\0') != std::string::npos) {
            fields.failAt(place, "must be a string");
            return;
        }
        texts.push_back(*text);
    });
}

/// What goes with what is asked for.
void readOthers(JsonFields& fields, ServeRequest& request) {
    const std::string& what = request.what;
    if (what == "load" || what == "edit" || what == "export" || what == "prove") {
        request.hasArgs = fields.find("args") != nullptr;
        readTexts(fields, "args", request.args);
    }
    if (what == "load" || what == "edit") {
        if (const JsonDocument* seams = fields.find("seams")) {
            request.seams = seams->dump(-1, ' ', false, JsonDocument::error_handler_t::replace);
        }
    }
    if (what == "flatten") {
        fields.read("settle", request.settle);
    }
    if (what == "query") {
        fields.need("what");
        readTexts(fields, "what", request.wanted);
        readTexts(fields, "pieces", request.pieces);
    }
    if (what == "cancel") {
        readId(fields, "of", request.of);
    }
}

}  // namespace

ServeRequest readServeRequest(std::string_view line) {
    ServeRequest request;
    const auto json = parseJson(line, kLineName, ErrorCode::MalformedFile);
    if (!json) {
        request.refusal = {kWrongRequest, std::string(json.error().detail)};
        return request;
    }
    if (!json->is_object()) {
        request.refusal = {kWrongRequest, "a request must be an object"};
        return request;
    }
    JsonFaults faults;
    {
        JsonFields fields(*json, "", faults);
        readId(fields, "id", request.id);
        fields.need("do");
        fields.read("do", request.what);
        if (!fields.failed() &&
            std::ranges::find(kServeWords, request.what) == std::end(kServeWords)) {
            std::string words;
            for (const std::string_view word : kServeWords) {
                words += (words.empty() ? "" : ", ") + std::string(word);
            }
            fields.fail("do", "must be one of " + words);
        }
        if (!fields.failed()) {
            readOthers(fields, request);
        }
    }
    if (!faults.first.empty()) {
        request.refusal = {kWrongRequest, faults.first};
    } else if (!faults.unknown.empty()) {
        request.refusal = {kWrongRequest, '"' + request.what + "\" has no field \"" +
                                              faults.unknown.front() + '"'};
    }
    return request;
}

ServeRequest tooLongServeRequest() {
    ServeRequest request;
    request.refusal = {kWrongRequest,
                       "the line is longer than " + std::to_string(kMaxServeLine >> 20U) + " MiB"};
    return request;
}

std::string serveAnswer(const std::string& id, const OrderedJson& result) {
    return lineOf(id, "result", result);
}

std::string serveAnswer(const std::string& id, const Refusal& refusal) {
    return lineOf(id, "error", refusalJson(refusal));
}

std::string serveProgress(const std::string& id, double fraction) {
    return lineOf(id, "progress", fraction);
}

}  // namespace toile::app
