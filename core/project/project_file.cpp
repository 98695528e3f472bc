// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_file.h"

#include <array>
#include <climits>
#include <utility>

#include "core/base/content_hash.h"
#include "core/base/file.h"
#include "core/base/json_depth.h"
#include "core/cut/ease_limit.h"
#include "core/flatten/option_words.h"
#include "core/project/json_fields.h"
#include "core/project/project_upgrades.h"
#include "core/sheet/sheet_limit.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

constexpr auto kFormat = "toile-project";
constexpr auto kUnits = R"("mm", "cm", "m" or "in")";
constexpr int kMostCopies = 1000000;
constexpr double kMostStrain = 10;
constexpr double kMostTurn = 1e6;         ///< radians: beyond, the sine of a double is no direction
constexpr std::size_t kUnknownNamed = 3;  ///< unknown keys that a note names

fs::path pathOf(const std::string& text) {
    return std::u8string(text.begin(), text.end());
}

std::string indexed(const std::string& place, std::size_t index) {
    return place + "[" + std::to_string(index) + "]";
}

/// Reads a document of the present version.
class Reader {
public:
    Reader(fs::path folder, JsonFaults& faults) : folder_(std::move(folder)), faults_(faults) {}

    Project run(const Json& json) {
        Project project;
        JsonFields fields(json, "", faults_);
        for (const char* stated : {"format", "version", "program"}) {
            fields.find(stated);
        }
        files(fields, project);
        with(fields, "reading", [&](JsonFields& at) { reading(at, project.loading); });
        with(fields, "seams", [&](JsonFields& at) { seams(at, project.loading.seams); });
        with(fields, "flattening", [&](JsonFields& at) { flattening(at, project.options); });
        with(fields, "fabric", [&](JsonFields& at) { fabric(at, project.fabric); });
        with(fields, "pieces", [&](JsonFields& at) { pieces(at, project); });
        with(fields, "view", [&](JsonFields& at) { view(at, project.view); });
        if (fields.find("recoveryOf")) {
            std::string text;
            fields.read("recoveryOf", text);
            project.recoveryOf = pathOf(text);
        }
        return project;
    }

private:
    template <class Read>
    void with(JsonFields& fields, std::string_view key, const Read& read) {
        if (const Json* json = fields.find(key)) {
            JsonFields at(*json, fields.placeOf(key), faults_);
            read(at);
        }
    }

    /// Each entry of a list.
    template <class Read>
    void each(JsonFields& fields, std::string_view key, const Json* list, const Read& read) {
        if (!list) {
            return;
        }
        if (!list->is_array()) {
            fields.fail(key, "must be a list");
            return;
        }
        for (std::size_t i = 0; i < list->size() && !fields.failed(); ++i) {
            read((*list)[i], indexed(fields.placeOf(key), i));
        }
    }

    void files(JsonFields& fields, Project& project) {
        const Json* list = fields.need("files");
        if (list && list->is_array() && list->empty()) {
            fields.fail("files", "must name a file");
        }
        each(fields, "files", list, [&](const Json& json, const std::string& place) {
            JsonFields at(json, place, faults_);
            std::string relative, absolute;
            at.read("path", relative);
            at.read("absolute", absolute);
            if (relative.empty() && absolute.empty()) {
                at.fail("path", "is missing");
            }
            MeshReference file;
            file.path = relative.empty() ? pathOf(absolute)
                                         : (folder_ / pathOf(relative)).lexically_normal();
            if (!relative.empty() && pathOf(absolute) != file.path) {
                file.elsewhere = pathOf(absolute);
            }
            if (at.find("hash")) {
                std::uint64_t hash = 0;
                at.readWord("hash", hash, R"("xxh64:" and 16 hexadecimal digits)", parseHash);
                file.hash = hash;
            }
            project.files.push_back(std::move(file));
        });
    }

    static void unit(JsonFields& fields, std::optional<LengthUnit>& unit) {
        LengthUnit stated{};
        if (fields.find("unit")) {
            fields.readWord("unit", stated, kUnits, parseLengthUnit);
            unit = stated;
        }
    }

    static void reading(JsonFields& fields, LoadOptions& loading) {
        unit(fields, loading.unit);
        if (fields.find("up")) {
            UpAxis up{};
            fields.readWord("up", up, R"("y" or "z")", parseUpAxis);
            loading.up = up;
        }
        fields.readWord(
            "split", loading.split,
            R"("auto", "components", "objects", "groups", "materials", "uv" or "seams")",
            parseSplitMode);
        fields.read("weld", loading.weld);
        fields.read("strict", loading.strict);
        fields.read("autoCut", loading.autoCut);
    }

    void seams(JsonFields& fields, SeamsFile& seams) {
        unit(fields, seams.unit);
        each(fields, "cuts", fields.find("cuts"), [&](const Json& json, const std::string& place) {
            JsonFields at(json, place, faults_);
            seams.cuts.push_back(cut(at));
        });
        each(fields, "joins", fields.find("joins"),
             [&](const Json& json, const std::string& place) {
                 JsonFields at(json, place, faults_);
                 UserJoin& join = seams.joins.emplace_back();
                 at.need("name");
                 at.read("name", join.name);
                 points(at, join.points);
             });
        with(fields, "ease", [&](JsonFields& at) {
            for (const auto& item : at.all().items()) {
                double ease = 0;
                at.read(item.key(), ease, -1, kMostEase);
                if (ease <= -1) {
                    at.fail(item.key(), "must be more than -1");
                }
                seams.ease[item.key()] = ease;
            }
        });
    }

    UserCut cut(JsonFields& fields) {
        UserCut cut;
        fields.need("name");
        fields.read("name", cut.name);
        fields.readWord("kind", cut.kind, R"("path", "loop" or "dart")",
                        [](const std::string& text) -> std::optional<UserCut::Kind> {
                            for (const auto kind :
                                 {UserCut::Kind::Path, UserCut::Kind::Loop, UserCut::Kind::Dart}) {
                                if (text == name(kind)) {
                                    return kind;
                                }
                            }
                            return std::nullopt;
                        });
        fields.readWord("along", cut.alongEdges, R"("surface" or "edges")",
                        [](const std::string& text) -> std::optional<bool> {
                            return text == "edges"     ? std::optional(true)
                                   : text == "surface" ? std::optional(false)
                                                       : std::nullopt;
                        });
        points(fields, cut.points);
        return cut;
    }

    void points(JsonFields& fields, std::vector<Eigen::Vector3d>& points) {
        const Json* list = fields.need("points");
        each(fields, "points", list, [&](const Json& json, const std::string& place) {
            if (const auto numbers = numbersOf(json, 3)) {
                points.emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2]);
            } else {
                faults_.first = '"' + place + "\" must be a list of 3 numbers";
            }
        });
    }

    static void flattening(JsonFields& fields, FlattenOptions& options) {
        fields.readWord("method", options.method, "the name of a method", parseMethod);
        fields.readWord("quality", options.quality, R"("draft", "standard" or "fine")",
                        [](std::string_view text) { return parseWord(kQualityWords, text); });
        fields.readWord("boundarySolver", options.boundarySolver, R"("newton" or "slcp")",
                        parseBoundarySolver);
        fields.readWord("freeBoundary", options.freeBoundary, R"("pinned" or "spectral")",
                        [](std::string_view text) { return parseWord(kFreeBoundaryWords, text); });
        fields.readWord(
            "stretchOutline", options.stretchOutline, R"("circle" or "curvature")",
            [](std::string_view text) { return parseWord(kStretchOutlineWords, text); });
        fields.read("authalic", options.authalic, 0, 1);
    }

    static void fabric(JsonFields& fields, Fabric& fabric) {
        fields.read("id", fabric.id);
        const std::pair<const char*, StrainLimits*> directions[] = {
            {"warp", &fabric.warp}, {"weft", &fabric.weft}, {"bias", &fabric.bias}};
        for (const auto& [key, limits] : directions) {
            if (const auto numbers = fields.numbers(key, 2)) {
                *limits = {(*numbers)[0], (*numbers)[1]};
                if (limits->least > 0 || limits->most < 0 || limits->least <= -1 ||
                    limits->most > kMostStrain) {
                    fields.fail(key, "must be a number from -1 to 0 and one from 0 to 10");
                }
            }
        }
    }

    void pieces(JsonFields& fields, Project& project) {
        for (const auto& item : fields.all().items()) {
            JsonFields at(item.value(), fields.placeOf(item.key()), faults_);
            project.pieces[item.key()] = piece(at);
        }
    }

    static std::optional<Eigen::Vector2d> point(JsonFields& fields, std::string_view key) {
        const auto numbers = fields.numbers(key, 2, kFarthestOnSheet);
        return numbers ? std::optional(Eigen::Vector2d((*numbers)[0], (*numbers)[1]))
                       : std::nullopt;
    }

    PieceSettings piece(JsonFields& fields) {
        PieceSettings settings;
        with(fields, "placement", [&](JsonFields& at) {
            Placement placement;
            at.need("offset");
            placement.offset = point(at, "offset").value_or(placement.offset);
            at.read("turn", placement.turn, -kMostTurn, kMostTurn);
            at.read("mirrored", placement.mirrored);
            settings.placedByHand = true;  // older files do not say
            at.read("byHand", settings.placedByHand);
            settings.placement = placement;
        });
        fields.read("grain", settings.grain, -kMostTurn, kMostTurn);
        fields.read("quantity", settings.quantity, 0, kMostCopies);
        fields.read("mirroredPair", settings.mirroredPair);
        each(fields, "anchors", fields.find("anchors"),
             [&](const Json& json, const std::string& place) {
                 JsonFields at(json, place, faults_);
                 Anchor anchor;
                 at.need("vertex");
                 at.need("at");
                 at.read("vertex", anchor.vertex, 0, INT_MAX);
                 anchor.flat = point(at, "at").value_or(anchor.flat);
                 settings.anchors.push_back(anchor);
             });
        return settings;
    }

    static void view(JsonFields& fields, ProjectView& view) {
        fields.read("overlay", view.overlay);
        fields.read("wireframe", view.wireframe);
        fields.read("designerOutline", view.designerOutline);
    }

    fs::path folder_;
    JsonFaults& faults_;
};

/// The version that a document states; what is wrong with it is a fault.
int versionOf(const Json& json, JsonFaults& faults) {
    JsonFaults here;
    int version = 0;
    {
        JsonFields fields(json, "", here);
        std::string format;
        fields.need("format");
        fields.read("format", format);
        if (format != kFormat) {
            fields.fail("format", std::string("must be \"") + kFormat + '"');
        }
        fields.need("version");
        fields.read("version", version, 1, INT_MAX);
    }
    faults.first = here.first;
    return version;
}

Problems notesOf(const JsonFaults& faults, const std::string& name) {
    if (faults.unknown.empty()) {
        return {};
    }
    std::string list;
    for (std::size_t i = 0; i < faults.unknown.size() && i < kUnknownNamed; ++i) {
        list += (i == 0 ? "\"" : ", \"") + faults.unknown[i] + '"';
    }
    if (faults.unknown.size() > kUnknownNamed) {
        list += " and " + std::to_string(faults.unknown.size() - kUnknownNamed) + " more";
    }
    return {{ErrorCode::UnknownKey, name, list}};
}

Result<ReadProject> readDocument(Json json, const std::string& name, const fs::path& folder) {
    JsonFaults faults;
    const int version = versionOf(json, faults);
    if (!faults.first.empty()) {
        return Error{ErrorCode::MalformedProject, name, faults.first};
    }
    if (version > kProjectVersion) {
        return Error{ErrorCode::NewerProject, name,
                     "its format is version " + std::to_string(version) + ", this Toile knows " +
                         std::to_string(kProjectVersion)};
    }
    upgradeProject(json, version, projectUpgrades());
    ReadProject read{Reader(folder, faults).run(json), {}};
    if (!faults.first.empty()) {
        return Error{ErrorCode::MalformedProject, name, faults.first};
    }
    read.notes = notesOf(faults, name);
    return read;
}

}  // namespace

bool isProjectFile(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return ending == kProjectEnding;
}

Result<ReadProject> parseProject(std::string_view text, const std::string& name,
                                 const fs::path& folder) {
    if (jsonDepth(text) > kMostJsonDepth) {
        return Error{ErrorCode::MalformedProject, name, "its lists lie too deep in each other"};
    }
    try {
        return readDocument(Json::parse(text), name, folder);
    } catch (const Json::parse_error& error) {
        return Error{ErrorCode::MalformedProject, name,
                     "no JSON: trouble at byte " + std::to_string(error.byte)};
    } catch (const Json::exception&) {  // a number that no double holds
        return Error{ErrorCode::MalformedProject, name, "a number is out of range"};
    }
}

Result<ReadProject> readProject(const fs::path& path) {
    const auto text = readFile(path);
    if (!text) {
        return text.error();
    }
    std::error_code failed;
    const fs::path absolute = fs::absolute(path, failed);
    auto read = parseProject(*text, path.filename().string(),
                             (failed ? path : absolute).lexically_normal().parent_path());
    if (read) {
        read->hash = contentHash(*text);
    }
    return read;
}

}  // namespace toile
