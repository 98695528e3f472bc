// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/content_hash.h"
#include "core/base/file.h"
#include "core/base/version.h"
#include "core/cut/seams_fields.h"
#include "core/flatten/option_words.h"
#include "core/project/project_file.h"
#include "core/project/project_upgrades.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

constexpr int kIndent = 2;

OrderedJson pairOf(const Eigen::Vector2d& point) {
    return OrderedJson::array({point.x(), point.y()});
}

OrderedJson pointOf(const Eigen::Vector3d& point) {
    return OrderedJson::array({point.x(), point.y(), point.z()});
}

OrderedJson filesOf(const Project& project, const fs::path& folder) {
    OrderedJson list = OrderedJson::array();
    for (const MeshReference& file : project.files) {
        OrderedJson entry = OrderedJson::object();
        const fs::path relative =
            folder.empty() ? fs::path() : file.path.lexically_relative(folder);
        if (!relative.empty()) {
            entry["path"] = pathText(relative);
        }
        entry["absolute"] = pathText(file.path);
        if (file.hash) {
            entry["hash"] = hashText(*file.hash);
        }
        list.push_back(std::move(entry));
    }
    return list;
}

OrderedJson readingOf(const LoadOptions& loading) {
    OrderedJson reading = OrderedJson::object();
    if (loading.unit) {
        reading["unit"] = std::string(symbol(*loading.unit));
    }
    if (loading.up) {
        reading["up"] = std::string(name(*loading.up));
    }
    reading["split"] = std::string(name(loading.split));
    reading["weld"] = loading.weld;
    reading["strict"] = loading.strict;
    reading["autoCut"] = loading.autoCut;
    return reading;
}

OrderedJson stretchOf(const LineStretch& stretch) {
    return {{"line", idText(stretch.line)}, {"from", stretch.from}, {"to", stretch.to}};
}

OrderedJson settingsOf(const std::vector<SeamSettings>& settings) {
    OrderedJson list = OrderedJson::array();
    for (const SeamSettings& said : settings) {
        OrderedJson& seam = list.emplace_back(OrderedJson::object());
        seam["left"] = stretchOf(said.place.left);
        if (said.place.right.line) {
            seam["right"] = stretchOf(said.place.right);
        }
        if (said.ease) {
            seam["ease"] = *said.ease;
        }
        if (!said.name.empty()) {
            seam["name"] = said.name;
        }
    }
    return list;
}

OrderedJson divisionOf(const std::vector<KnownPiece>& known) {
    OrderedJson list = OrderedJson::array();
    for (const KnownPiece& piece : known) {
        list.push_back({{"id", idText(piece.id)},
                        {"file", piece.file},
                        {"name", piece.name},
                        {"centre", pointOf(piece.centre)},
                        {"area", piece.area}});
    }
    return list;
}

OrderedJson seamsOf(const LoadOptions& loading) {
    const SeamsFile& seams = loading.seams;
    OrderedJson json = OrderedJson::object();
    if (seams.unit) {
        json["unit"] = std::string(symbol(*seams.unit));
    }
    json["cuts"] = cutsJson(seams, true);
    json["joins"] = joinsJson(seams);
    if (!seams.ease.empty()) {  // by names that no garment has been held to yet
        json["ease"] = easeJson(seams, 1);
    }
    if (!loading.seamSettings.empty()) {
        json["settings"] = settingsOf(loading.seamSettings);
    }
    return json;
}

OrderedJson flatteningOf(const FlattenOptions& options) {
    return {{"method", std::string(name(options.method))},
            {"quality", std::string(wordOf(kQualityWords, options.quality))},
            {"boundarySolver", std::string(name(options.boundarySolver))},
            {"freeBoundary", std::string(wordOf(kFreeBoundaryWords, options.freeBoundary))},
            {"stretchOutline", std::string(wordOf(kStretchOutlineWords, options.stretchOutline))},
            {"authalic", options.authalic}};
}

OrderedJson fabricOf(const Fabric& fabric) {
    const auto limits = [](const StrainLimits& strain) -> OrderedJson {
        return OrderedJson::array({strain.least, strain.most});
    };
    return {{"id", fabric.id},
            {"warp", limits(fabric.warp)},
            {"weft", limits(fabric.weft)},
            {"bias", limits(fabric.bias)}};
}

OrderedJson pieceOf(const ProjectPiece& known) {
    const PieceSettings& settings = known.settings;
    OrderedJson piece = OrderedJson::object();
    if (known.id) {
        piece["id"] = idText(known.id);
    }
    piece["name"] = known.name;
    if (settings.placement) {
        piece["placement"] = {{"offset", pairOf(settings.placement->offset)},
                              {"turn", settings.placement->turn},
                              {"mirrored", settings.placement->mirrored},
                              {"byHand", settings.placedByHand}};
    }
    if (settings.grain) {
        piece["grain"] = *settings.grain;
    }
    piece["quantity"] = settings.quantity;
    piece["mirroredPair"] = settings.mirroredPair;
    if (settings.partOf) {
        piece["partOf"] = idText(settings.partOf);
    }
    if (!settings.anchors.empty()) {
        piece["anchors"] = OrderedJson::array();
        for (const Anchor& anchor : settings.anchors) {
            piece["anchors"].push_back({{"vertex", anchor.vertex}, {"at", pairOf(anchor.flat)}});
            if (anchor.point) {
                piece["anchors"].back()["point"] = pointOf(*anchor.point);
            }
        }
    }
    return piece;
}

OrderedJson piecesOf(const Project& project) {
    OrderedJson list = OrderedJson::array();
    for (const ProjectPiece& piece : project.pieces) {
        list.push_back(pieceOf(piece));
    }
    return list;
}

OrderedJson labelsOf(const PieceLabels& labels) {
    OrderedJson list = OrderedJson::array();
    for (const auto& [id, label] : labels) {
        OrderedJson& entry = list.emplace_back(OrderedJson{{"id", idText(id)}});
        if (!label.name.empty()) {
            entry["name"] = label.name;
        }
        if (label.colour >= 0) {
            entry["colour"] = label.colour;
        }
    }
    return list;
}

OrderedJson viewOf(const ProjectView& view) {
    OrderedJson json = OrderedJson::object();
    if (!view.overlay.empty()) {
        json["overlay"] = view.overlay;
    }
    json["wireframe"] = view.wireframe;
    json["designerOutline"] = view.designerOutline;
    return json;
}

}  // namespace

std::string projectText(const Project& project, const fs::path& folder) {
    OrderedJson json{{"format", "toile-project"},
                     {"version", kProjectVersion},
                     {"program", "Toile " + std::string(version())},
                     {"files", filesOf(project, folder)},
                     {"reading", readingOf(project.loading)},
                     {"division", divisionOf(project.loading.known)},
                     {"seams", seamsOf(project.loading)},
                     {"flattening", flatteningOf(project.options)},
                     {"fabric", fabricOf(project.fabric)},
                     {"pieces", piecesOf(project)},
                     {"labels", labelsOf(project.labels)},
                     {"view", viewOf(project.view)}};
    if (project.recoveryOf) {
        json["recoveryOf"] = pathText(*project.recoveryOf);
    }
    return json.dump(kIndent, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
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

}  // namespace toile
