// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_file.h"

#include <climits>
#include <utility>

#include "core/base/content_hash.h"
#include "core/base/file.h"
#include "core/base/json_fields.h"
#include "core/base/text.h"
#include "core/cut/seams_fields.h"
#include "core/flatten/option_words.h"
#include "core/project/project_upgrades.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

constexpr auto kFormat = "toile-project";
constexpr double kMostStrain = 10;
constexpr int kMostColour = 1000000;
constexpr double kMostTurns = 2;   ///< round a line that is closed
constexpr double kMostTurn = 1e6;  ///< radians: beyond, the sine of a double is no direction

/// Empty where it is not there.
fs::path readPath(JsonFields& fields, std::string_view key) {
    std::string text;
    fields.read(key, text);
    if (text.find('\0') != std::string::npos) {  // the system would take what stands before it
        fields.fail(key, "is no path");
    }
    return std::u8string(text.begin(), text.end());
}

/// Reads a document of the present version.
class Reader {
public:
    Reader(fs::path folder, JsonFaults& faults) : folder_(std::move(folder)), faults_(faults) {}

    Project run(const JsonDocument& json) {
        Project project;
        JsonFields fields(json, "", faults_);
        for (const char* stated : {"format", "version", "program"}) {
            fields.find(stated);
        }
        files(fields, project);
        fields.readObject("reading", [&](JsonFields& at) { reading(at, project.loading); });
        division(fields, project.loading.known);
        fields.readObject("seams", [&](JsonFields& at) {
            readSeams(at, project.loading.seams, 1, true);
            seamSettings(at, project.loading.seamSettings);
        });
        fields.readObject("flattening", [&](JsonFields& at) { flattening(at, project.options); });
        fields.readObject("fabric", [&](JsonFields& at) { fabric(at, project.fabric); });
        pieces(fields, project);
        labels(fields, project.labels);
        fields.readObject("view", [&](JsonFields& at) { view(at, project.view); });
        if (fields.find("recoveryOf")) {
            project.recoveryOf = readPath(fields, "recoveryOf");
        }
        return project;
    }

private:
    void files(JsonFields& fields, Project& project) {
        const JsonDocument* list = fields.need("files");
        if (list && list->is_array() && list->empty()) {
            fields.fail("files", "must name a file");
        }
        fields.readObjects("files", [&](JsonFields& at) {
            const fs::path relative = readPath(at, "path"), absolute = readPath(at, "absolute");
            if (relative.empty() && absolute.empty()) {
                at.fail("path", "is missing");
            }
            MeshReference file;
            file.path = relative.empty() ? absolute : (folder_ / relative).lexically_normal();
            if (!relative.empty() && absolute != file.path) {
                file.elsewhere = absolute;
            }
            if (at.find("hash")) {
                std::uint64_t hash = 0;
                at.readWord("hash", hash, R"("xxh64:" and 16 hexadecimal digits)", parseHash);
                file.hash = hash;
            }
            project.files.push_back(std::move(file));
        });
    }

    static void reading(JsonFields& fields, LoadOptions& loading) {
        fields.read("unit", loading.unit);
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

    static void flattening(JsonFields& fields, FlattenOptions& options) {
        fields.readWord("method", options.method, "the name of a method", parseMethod);
        fields.readWord("quality", options.quality, kQualityWords);
        fields.readWord("boundarySolver", options.boundarySolver, R"("newton" or "slcp")",
                        parseBoundarySolver);
        fields.readWord("freeBoundary", options.freeBoundary, kFreeBoundaryWords);
        fields.readWord("stretchOutline", options.stretchOutline, kStretchOutlineWords);
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

    template <class Kind>
    static void id(JsonFields& fields, std::string_view key, Id<Kind>& id) {
        fields.readWord(key, id.value, "16 hexadecimal digits", parseId);
    }

    static std::optional<Eigen::Vector3d> point3(JsonFields& fields, std::string_view key) {
        const auto numbers = fields.numbers(key, 3);
        return numbers ? std::optional(Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]))
                       : std::nullopt;
    }

    static void division(JsonFields& fields, std::vector<KnownPiece>& known) {
        fields.readObjects("division", [&known](JsonFields& at) {
            KnownPiece piece;
            at.need("id");
            id(at, "id", piece.id);
            at.read("file", piece.file, 0, INT_MAX);
            at.read("name", piece.name);
            piece.centre = point3(at, "centre").value_or(piece.centre);
            at.read("area", piece.area, 0);
            known.push_back(std::move(piece));
        });
    }

    static void stretch(JsonFields& fields, std::string_view key, LineStretch& stretch) {
        fields.readObject(key, [&stretch](JsonFields& at) {
            at.need("line");
            id(at, "line", stretch.line);
            at.read("from", stretch.from, -kMostTurns, kMostTurns);
            at.read("to", stretch.to, -kMostTurns, kMostTurns);
        });
    }

    static void seamSettings(JsonFields& fields, std::vector<SeamSettings>& settings) {
        fields.readObjects("settings", [&settings](JsonFields& at) {
            SeamSettings said;
            at.need("left");
            stretch(at, "left", said.place.left);
            stretch(at, "right", said.place.right);
            at.read("ease", said.ease, -1, kMostEase);
            if (said.ease && *said.ease <= -1) {
                at.fail("ease", "must be more than -1");
            }
            at.read("name", said.name);
            settings.push_back(std::move(said));
        });
    }

    void pieces(JsonFields& fields, Project& project) {
        fields.readObjects("pieces", [&](JsonFields& at) {
            ProjectPiece known;
            if (at.find("id")) {
                id(at, "id", known.id);
            }
            at.need("name");
            at.read("name", known.name);
            known.settings = piece(at);
            project.pieces.push_back(std::move(known));
        });
    }

    static void labels(JsonFields& fields, PieceLabels& labels) {
        fields.readObjects("labels", [&labels](JsonFields& at) {
            PieceId piece;
            PieceLabel label;
            at.need("id");
            id(at, "id", piece);
            at.read("name", label.name);
            at.read("colour", label.colour, 0, kMostColour);
            labels[piece] = std::move(label);
        });
    }

    static std::optional<Eigen::Vector2d> point(JsonFields& fields, std::string_view key) {
        const auto numbers = fields.numbers(key, 2, kFarthestOnSheet);
        return numbers ? std::optional(Eigen::Vector2d((*numbers)[0], (*numbers)[1]))
                       : std::nullopt;
    }

    PieceSettings piece(JsonFields& fields) {
        PieceSettings settings;
        fields.readObject("placement", [&](JsonFields& at) {
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
        if (fields.find("partOf")) {
            id(fields, "partOf", settings.partOf);
        }
        fields.readObjects("anchors", [&settings](JsonFields& at) {
            Anchor anchor;
            at.need("vertex");
            at.need("at");
            at.read("vertex", anchor.vertex, 0, INT_MAX);
            anchor.flat = point(at, "at").value_or(anchor.flat);
            anchor.point = point3(at, "point");
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
int versionOf(const JsonDocument& json, JsonFaults& faults) {
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

Result<ReadProject> readDocument(JsonDocument json, const std::string& name,
                                 const fs::path& folder) {
    JsonFaults faults;
    const int version = versionOf(json, faults);
    if (!faults.first.empty()) {
        return Error{ErrorCode::MalformedProject, Subject::file(name), faults.first};
    }
    if (version > kProjectVersion) {
        return Error{ErrorCode::NewerProject, Subject::file(name),
                     "its format is version " + std::to_string(version) + ", this Toile knows " +
                         std::to_string(kProjectVersion)};
    }
    upgradeProject(json, version, kProjectUpgrades);
    ReadProject read{Reader(folder, faults).run(json), {}};
    if (!faults.first.empty()) {
        return Error{ErrorCode::MalformedProject, Subject::file(name), faults.first};
    }
    read.notes = faults.notes(name);
    return read;
}

}  // namespace

bool isProjectFile(const fs::path& path) {
    return equalsIgnoringCase(path.extension().string(), kProjectEnding);
}

Result<ReadProject> parseProject(std::string_view text, const std::string& name,
                                 const fs::path& folder) {
    auto json = parseJson(text, name, ErrorCode::MalformedProject);
    return json ? readDocument(std::move(*json), name, folder) : json.error();
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
