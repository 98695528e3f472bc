// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_file.h"

#include <utility>

#include "core/base/file.h"
#include "core/base/id.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/project/project_fields.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

constexpr auto kFormat = "toile-project";
/// Empty if the key is missing.
fs::path readPath(JsonFields& fields, std::string_view key) {
    std::string text;
    fields.read(key, text);
    if (text.find('\0') != std::string::npos) {  // the system would use the part before it
        fields.fail(key, "must be a path");
    }
    return std::u8string(text.begin(), text.end());
}

FileReference readReference(JsonFields& at, const fs::path& folder) {
    const fs::path relative = readPath(at, "path"), absolute = readPath(at, "absolute");
    if (relative.empty() && absolute.empty()) {
        at.fail("path", "is missing");
    }
    FileReference file;
    file.path = relative.empty() ? absolute : (folder / relative).lexically_normal();
    if (!relative.empty() && absolute != file.path) {
        file.elsewhere = absolute;
    }
    if (at.find("hash")) {
        at.readWord("hash", file.hash.emplace(), R"("xxh64:" and 16 hexadecimal digits)",
                    parseHash);
    }
    return file;
}

void readFiles(JsonFields& fields, const fs::path& folder, Project& project) {
    const JsonDocument* list = fields.need("files");
    if (list && list->is_array() && list->empty()) {
        fields.fail("files", "must name a file");
    }
    fields.readObjects("files",
                       [&](JsonFields& at) { project.files.push_back(readReference(at, folder)); });
    fields.readObject("reference",
                      [&](JsonFields& at) { project.reference = readReference(at, folder); });
}

void readProof(JsonFields& fields, const fs::path& folder, Project& project) {
    fields.readObject("proof", [&](JsonFields& proof) {
        proof.readObject("body", [&](JsonFields& at) {
            FileReference body = readReference(at, folder);
            project.proof.body = std::move(body.path);
            project.bodyElsewhere = std::move(body.elsewhere);
        });
        FieldReader at(proof);
        kProofFields(at, project.proof);
    });
}

OrderedJson referenceJson(const FileReference& file, const fs::path& folder) {
    OrderedJson json = OrderedJson::object();
    const fs::path relative = folder.empty() ? fs::path() : file.path.lexically_relative(folder);
    if (!relative.empty()) {
        json["path"] = pathText(relative);
    }
    json["absolute"] = pathText(file.path);
    if (file.hash) {
        json["hash"] = hashText(*file.hash);
    }
    return json;
}

OrderedJson proofJson(const ProofPlan& plan, const fs::path& folder) {
    OrderedJson json;
    FieldWriter at(json);
    if (!plan.body.empty()) {
        json["body"] = referenceJson({plan.body, {}, {}}, folder);
    }
    kProofFields(at, plan);
    return json;
}

/// Reads a document of the present version.
Project readCurrent(const JsonDocument& json, const fs::path& folder, JsonFaults& faults) {
    Project project;
    JsonFields fields(json, "", faults);
    for (const char* stated : {"format", "version", "program"}) {
        fields.find(stated);
    }
    readFiles(fields, folder, project);
    readProof(fields, folder, project);
    FieldReader at(fields);
    std::vector<project_fields::LabelOfPiece> labels;
    std::vector<project_fields::MarkerOfMaterial> markers;
    project_fields::describe(at, project, labels, markers);
    for (auto& [piece, label] : labels) {
        project.labels[piece] = std::move(label);
    }
    for (auto& [material, plan] : markers) {
        if (!project.markers.emplace(std::move(material), std::move(plan)).second) {
            fields.fail("markers", "must have each material once");
        }
    }
    if (fields.find("recoveryOf")) {
        project.recoveryOf = readPath(fields, "recoveryOf");
    }
    return project;
}

/// The version stated by a document; reports a fault if it is invalid.
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
                     "its format is version " + std::to_string(version) +
                         ", but this Toile knows version " + std::to_string(kProjectVersion)};
    }
    upgradeProject(json, version, kProjectUpgrades);
    ReadProject read{readCurrent(json, folder, faults), {}};
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

std::string projectText(const Project& project, const fs::path& folder) {
    OrderedJson json;
    FieldWriter at(json);
    at.field("format", kFormat);
    at.field("version", kProjectVersion);
    at.field("program", "Toile " + std::string(version()));
    json["files"] = OrderedJson::array();
    for (const FileReference& file : project.files) {
        json["files"].push_back(referenceJson(file, folder));
    }
    if (project.reference) {
        json["reference"] = referenceJson(*project.reference, folder);
    }
    std::vector<project_fields::LabelOfPiece> labels(project.labels.begin(), project.labels.end());
    std::vector<project_fields::MarkerOfMaterial> markers(project.markers.begin(),
                                                          project.markers.end());
    project_fields::describe(at, project, labels, markers);
    if (!(project.proof == ProofPlan{})) {
        json["proof"] = proofJson(project.proof, folder);
    }
    if (project.recoveryOf) {
        json["recoveryOf"] = pathText(*project.recoveryOf);
    }
    return jsonText(json);
}

Result<std::uint64_t> writeProject(const fs::path& path, const Project& project) {
    std::error_code failed;
    const fs::path absolute = fs::absolute(path, failed);
    const fs::path folder =
        failed || project.recoveryOf ? fs::path() : absolute.lexically_normal().parent_path();
    const std::string text = projectText(project, folder);
    if (const auto written = writeFile(path, text); !written) {
        return written.error();
    }
    return contentHash(text);
}

void sayNothingOfLines(JsonDocument& document) {
    document["lines"] = JsonDocument::object();
}

void keepHemWidths(JsonDocument& document) {
    const auto lines = document.find("lines");
    if (lines == document.end() || !lines->is_object() || !lines->contains("allowance") ||
        !(*lines)["allowance"].is_object()) {
        return;
    }
    JsonDocument& widths = (*lines)["allowance"];
    const JsonDocument hem = widths.value("hem", JsonDocument(AllowanceWidths{}.hem));
    for (const char* key : kEdgeWidthKeys) {
        widths[key] = hem;
    }
}

void listPieces(JsonDocument& document) {
    const auto pieces = document.find("pieces");
    if (pieces == document.end() || !pieces->is_object()) {
        return;
    }
    JsonDocument list = JsonDocument::array();
    for (auto& item : pieces->items()) {
        JsonDocument& piece = list.emplace_back(std::move(item.value()));
        if (!piece.is_object()) {
            continue;
        }
        piece["name"] = item.key();
        // The id only groups the parts of one piece: any number they share will do.
        if (const auto whole = piece.find("partOf"); whole != piece.end() && whole->is_string()) {
            *whole = idText(hashOf({contentHash(whole->get<std::string>())}));
        }
    }
    *pieces = std::move(list);
}

}  // namespace toile
