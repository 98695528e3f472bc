// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/seams_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/json_depth.h"
#include "core/cut/ease_limit.h"

namespace toile {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr int kIndent = 2;
constexpr double kPercent = 100;
constexpr std::array kKinds{UserCut::Kind::Path, UserCut::Kind::Loop, UserCut::Kind::Dart};

/// Reads the fields one by one; the first thing that is wrong ends it, as a sentence's middle.
class Parser {
public:
    explicit Parser(SeamsFile& file) : file_(file) {}

    const std::string& fault() const { return fault_; }

    bool run(const Json& json) {
        if (!json.is_object()) {
            return fail("the file is no JSON object");
        }
        if (!onlyFields(json, {"version", "unit", "cuts", "joins", "ease"}, "the file")) {
            return false;
        }
        const auto version = json.find("version");
        if (version == json.end() || *version != kVersion) {
            return fail("\"version\" must be 1");
        }
        return unit(json) && cuts(json) && joins(json) && ease(json);
    }

private:
    bool fail(std::string what) {
        fault_ = std::move(what);
        return false;
    }

    /// A misspelt field would be a silent loss.
    bool onlyFields(const Json& json, std::initializer_list<const char*> known,
                    const std::string& where) {
        for (const auto& [key, value] : json.items()) {
            if (std::find(known.begin(), known.end(), key) == known.end()) {
                return fail(where + " has an unknown field \"" + key + "\"");
            }
        }
        return true;
    }

    bool unit(const Json& json) {
        const auto unit = json.find("unit");
        if (unit == json.end()) {
            return true;
        }
        file_.unit = unit->is_string() ? parseLengthUnit(unit->get<std::string>()) : std::nullopt;
        return file_.unit || fail(R"("unit" must be "mm", "cm", "m" or "in")");
    }

    bool cuts(const Json& json) {
        const auto cuts = json.find("cuts");
        if (cuts == json.end()) {
            return true;
        }
        if (!cuts->is_array()) {
            return fail("\"cuts\" must be a list");
        }
        for (const Json& entry : *cuts) {
            if (!cut(entry)) {
                return false;
            }
        }
        return true;
    }

    bool cut(const Json& json) {
        UserCut cut;
        cut.name = "cut " + std::to_string(file_.cuts.size() + 1);
        if (!json.is_object()) {
            return fail(cut.name + " is no object");
        }
        if (!onlyFields(json, {"name", "kind", "along", "points"}, cut.name)) {
            return false;
        }
        if (!named(json, cut.name)) {
            return false;
        }
        if (const auto kind = json.find("kind"); kind != json.end()) {
            const auto known = std::ranges::find_if(
                kKinds, [&kind](UserCut::Kind k) { return *kind == std::string(name(k)); });
            if (known == kKinds.end()) {
                return fail(cut.name + R"(: "kind" must be "path", "loop" or "dart")");
            }
            cut.kind = *known;
        }
        if (const auto along = json.find("along"); along != json.end()) {
            if (*along != "surface" && *along != "edges") {
                return fail(cut.name + R"(: "along" must be "surface" or "edges")");
            }
            cut.alongEdges = *along == "edges";
        }
        if (!points(json, cut.name, cut.points)) {
            return false;
        }
        file_.cuts.push_back(std::move(cut));
        return true;
    }

    bool joins(const Json& json) {
        const auto joins = json.find("joins");
        if (joins == json.end()) {
            return true;
        }
        if (!joins->is_array()) {
            return fail("\"joins\" must be a list");
        }
        for (const Json& entry : *joins) {
            UserJoin join;
            join.name = "join " + std::to_string(file_.joins.size() + 1);
            if (!entry.is_object()) {
                return fail(join.name + " is no object");
            }
            if (!onlyFields(entry, {"name", "points"}, join.name) || !named(entry, join.name) ||
                !points(entry, join.name, join.points)) {
                return false;
            }
            file_.joins.push_back(std::move(join));
        }
        return true;
    }

    /// Takes an entry's name where it has one.
    bool named(const Json& json, std::string& name) {
        const auto given = json.find("name");
        if (given == json.end()) {
            return true;
        }
        if (!given->is_string() || given->get<std::string>().empty()) {
            return fail(name + ": \"name\" must be a text");
        }
        name = given->get<std::string>();
        return true;
    }

    bool points(const Json& json, const std::string& name, std::vector<Eigen::Vector3d>& out) {
        const auto points = json.find("points");
        if (points == json.end() || !points->is_array()) {
            return fail(name + ": \"points\" must be a list");
        }
        for (const Json& point : *points) {
            const bool three =
                point.is_array() && point.size() == 3 &&
                std::ranges::all_of(point, [](const Json& x) { return x.is_number(); });
            if (!three) {
                return fail(name + ": point " + std::to_string(out.size() + 1) +
                            " must be three numbers");
            }
            out.emplace_back(point[0].get<double>(), point[1].get<double>(),
                             point[2].get<double>());
        }
        return true;
    }

    bool ease(const Json& json) {
        const auto ease = json.find("ease");
        if (ease == json.end()) {
            return true;
        }
        if (!ease->is_object()) {
            return fail("\"ease\" must give a number of percent for each seam's name");
        }
        for (const auto& [seam, percent] : ease->items()) {
            const bool usable = percent.is_number() && percent.get<double>() > -kPercent &&
                                percent.get<double>() <= kPercent * kMostEase;
            if (!usable) {
                return fail("the ease of \"" + seam +
                            "\" must be a number above -100, 1000 at most");
            }
            file_.ease[seam] = percent.get<double>() / kPercent;
        }
        return true;
    }

    SeamsFile& file_;
    std::string fault_;
};

Json pointsJson(const std::vector<Eigen::Vector3d>& points) {
    Json list = Json::array();
    for (const Eigen::Vector3d& point : points) {
        list.push_back({point.x(), point.y(), point.z()});
    }
    return list;
}

}  // namespace

Result<SeamsFile> parseSeamsFile(std::string_view text, const std::string& name) {
    SeamsFile file;
    if (jsonDepth(text) > kMostJsonDepth) {
        return Error{ErrorCode::MalformedFile, name, "its lists lie too deep in each other"};
    }
    try {
        Parser parser(file);
        if (!parser.run(Json::parse(text))) {
            return Error{ErrorCode::MalformedFile, name, parser.fault()};
        }
    } catch (const Json::parse_error& error) {
        return Error{ErrorCode::MalformedFile, name,
                     "no JSON: trouble at byte " + std::to_string(error.byte)};
    } catch (const Json::exception&) {  // a number that no double holds
        return Error{ErrorCode::MalformedFile, name, "a number is out of range"};
    }
    return file;
}

Result<SeamsFile> readSeamsFile(const std::filesystem::path& path) {
    const auto text = readFile(path);
    if (!text) {
        return text.error();
    }
    return parseSeamsFile(*text, path.filename().string());
}

std::string writeSeamsFile(const SeamsFile& file) {
    Json json{{"version", kVersion}};
    if (file.unit) {
        json["unit"] = std::string(symbol(*file.unit));
    }
    json["cuts"] = Json::array();
    for (const UserCut& cut : file.cuts) {
        json["cuts"].push_back({{"name", cut.name},
                                {"kind", std::string(name(cut.kind))},
                                {"along", cut.alongEdges ? "edges" : "surface"},
                                {"points", pointsJson(cut.points)}});
    }
    for (const UserJoin& join : file.joins) {
        json["joins"].push_back({{"name", join.name}, {"points", pointsJson(join.points)}});
    }
    if (!file.ease.empty()) {
        for (const auto& [seam, ease] : file.ease) {
            json["ease"][seam] = kPercent * ease;
        }
    }
    return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string_view name(UserCut::Kind kind) {
    switch (kind) {
        case UserCut::Kind::Path:
            return "path";
        case UserCut::Kind::Loop:
            return "loop";
        case UserCut::Kind::Dart:
            return "dart";
    }
    return "";
}

}  // namespace toile
