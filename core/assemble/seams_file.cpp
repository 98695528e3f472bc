// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/seams_file.h"

#include "core/base/file.h"
#include "core/base/text.h"

namespace toile {
namespace {

constexpr int kVersion = 1;
constexpr double kPercent = 100;
constexpr Word<UserCut::Kind> kKinds[] = {
    {UserCut::Kind::Path, "path"}, {UserCut::Kind::Loop, "loop"}, {UserCut::Kind::Dart, "dart"}};
constexpr Word<bool> kAlongEdges[] = {{false, "surface"}, {true, "edges"}};

/// @param name  default name of the entry
void readNameAndPoints(JsonFields& fields, std::string& name,
                       std::vector<Eigen::Vector3d>& points) {
    fields.read("name", name);
    if (name.empty()) {
        fields.fail("name", "must not be empty");
    }
    fields.need("points");
    fields.readEach("points", [&](const JsonDocument& json, const std::string& place) {
        if (const auto numbers = numbersOf(json, 3)) {
            points.emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2]);
        } else {
            fields.failAt(place, "must be a list of 3 numbers");
        }
    });
}

OrderedJson pointsJson(const std::vector<Eigen::Vector3d>& points) {
    OrderedJson list = OrderedJson::array();
    for (const Eigen::Vector3d& point : points) {
        list.push_back({point.x(), point.y(), point.z()});
    }
    return list;
}

}  // namespace

void readSeams(JsonFields& fields, SeamsFile& seams, double easeUnit, bool withIds) {
    fields.read("unit", seams.unit);
    fields.readObjects("cuts", [&seams, withIds](JsonFields& at) {
        UserCut& cut = seams.cuts.emplace_back();
        cut.name = "cut " + std::to_string(seams.cuts.size());
        at.readWord("kind", cut.kind, kKinds);
        at.readWord("along", cut.alongEdges, kAlongEdges);
        if (withIds && at.find("id")) {
            at.readWord("id", cut.id.value, "16 hexadecimal digits", parseId);
        }
        if (withIds && at.find("mirrors")) {
            at.readWord("mirrors", cut.mirrors.value, "16 hexadecimal digits", parseId);
        }
        at.read("evidence", cut.evidence);
        readNameAndPoints(at, cut.name, cut.points);
    });
    giveIds(seams.cuts);
    fields.readObjects("joins", [&seams](JsonFields& at) {
        UserJoin& join = seams.joins.emplace_back();
        join.name = "join " + std::to_string(seams.joins.size());
        readNameAndPoints(at, join.name, join.points);
    });
    fields.readObject("ease", [&seams, easeUnit](JsonFields& at) {
        for (const auto& item : at.all().items()) {
            double ease = 0;
            at.read(item.key(), ease, -easeUnit, kMaxEase * easeUnit);
            if (ease <= -easeUnit) {
                at.fail(item.key(), "must be more than " + shortest(-easeUnit));
            }
            seams.ease[item.key()] = ease / easeUnit;
        }
    });
}

Result<SeamsFile> parseSeamsFile(std::string_view text, const std::string& name, Problems* notes) {
    const auto json = parseJson(text, name, ErrorCode::MalformedFile);
    if (!json) {
        return json.error();
    }
    SeamsFile file;
    JsonFaults faults;
    {
        JsonFields fields(*json, "", faults);
        int version = 0;
        fields.need("version");
        fields.read("version", version, kVersion, kVersion);
        readSeams(fields, file, kPercent, false);
    }
    if (!faults.first.empty()) {
        return Error{ErrorCode::MalformedFile, Subject::file(name), faults.first};
    }
    if (notes) {
        *notes = faults.notes(name);
    }
    return file;
}

Result<SeamsFile> readSeamsFile(const std::filesystem::path& path, Problems* notes) {
    return readFile(path).andThen([&](const std::string& text) {
        return parseSeamsFile(text, path.filename().string(), notes);
    });
}

OrderedJson cutsJson(const SeamsFile& seams, bool withIds) {
    OrderedJson list = OrderedJson::array();
    for (const UserCut& cut : seams.cuts) {
        OrderedJson& entry = list.emplace_back(OrderedJson{{"name", cut.name}});
        if (cut.id && withIds) {
            entry["id"] = idText(cut.id);
        }
        if (cut.mirrors && withIds) {
            entry["mirrors"] = idText(cut.mirrors);
        }
        entry["kind"] = std::string(name(cut.kind));
        entry["along"] = std::string(wordOf(kAlongEdges, cut.alongEdges));
        if (!cut.evidence.empty()) {
            entry["evidence"] = cut.evidence;
        }
        entry["points"] = pointsJson(cut.points);
    }
    return list;
}

OrderedJson joinsJson(const SeamsFile& seams) {
    OrderedJson list = OrderedJson::array();
    for (const UserJoin& join : seams.joins) {
        list.push_back({{"name", join.name}, {"points", pointsJson(join.points)}});
    }
    return list;
}

OrderedJson easeJson(const SeamsFile& seams, double easeUnit) {
    OrderedJson::object_t fields;
    for (const auto& [seam, ease] : seams.ease) {
        fields.emplace_back(seam, easeUnit * ease);  // avoids a search for the key
    }
    return fields;
}

std::string writeSeamsFile(const SeamsFile& file) {
    OrderedJson json{{"version", kVersion}};
    if (file.unit) {
        json["unit"] = unitText(*file.unit);
    }
    json["cuts"] = cutsJson(file, false);
    if (!file.joins.empty()) {
        json["joins"] = joinsJson(file);
    }
    if (!file.ease.empty()) {
        json["ease"] = easeJson(file, kPercent);
    }
    return jsonText(json);
}

std::string_view name(UserCut::Kind kind) {
    return wordOf(kKinds, kind);
}

}  // namespace toile
