// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/content_hash.h"
#include "core/base/file.h"
#include "core/base/version.h"
#include "core/flatten/option_words.h"
#include "core/project/project_file.h"
#include "core/project/project_upgrades.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

constexpr int kIndent = 2;

/// UTF-8, with slashes on every system.
std::string textOf(const fs::path& path) {
    const std::u8string text = path.generic_u8string();
    return {text.begin(), text.end()};
}

Json pairOf(const Eigen::Vector2d& point) {
    return Json::array({point.x(), point.y()});
}

Json filesOf(const Project& project, const fs::path& folder) {
    Json list = Json::array();
    for (const MeshReference& file : project.files) {
        Json entry = Json::object();
        const fs::path relative =
            folder.empty() ? fs::path() : file.path.lexically_relative(folder);
        if (!relative.empty()) {
            entry["path"] = textOf(relative);
        }
        entry["absolute"] = textOf(file.path);
        if (file.hash) {
            entry["hash"] = hashText(*file.hash);
        }
        list.push_back(std::move(entry));
    }
    return list;
}

Json pointsOf(const std::vector<Eigen::Vector3d>& points) {
    Json list = Json::array();
    for (const Eigen::Vector3d& point : points) {
        list.push_back({point.x(), point.y(), point.z()});
    }
    return list;
}

Json cutsOf(const SeamsFile& seams) {
    Json list = Json::array();
    for (const UserCut& cut : seams.cuts) {
        list.push_back({{"name", cut.name},
                        {"kind", std::string(name(cut.kind))},
                        {"along", cut.alongEdges ? "edges" : "surface"},
                        {"points", pointsOf(cut.points)}});
    }
    return list;
}

Json readingOf(const LoadOptions& loading) {
    Json reading = Json::object();
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

Json seamsOf(const SeamsFile& seams) {
    Json json = Json::object();
    if (seams.unit) {
        json["unit"] = std::string(symbol(*seams.unit));
    }
    json["cuts"] = cutsOf(seams);
    json["joins"] = Json::array();
    for (const UserJoin& join : seams.joins) {
        json["joins"].push_back({{"name", join.name}, {"points", pointsOf(join.points)}});
    }
    json["ease"] = Json::object();
    for (const auto& [seam, ease] : seams.ease) {
        json["ease"][seam] = ease;
    }
    return json;
}

Json flatteningOf(const FlattenOptions& options) {
    return {{"method", std::string(name(options.method))},
            {"quality", std::string(wordOf(kQualityWords, options.quality))},
            {"boundarySolver", std::string(name(options.boundarySolver))},
            {"freeBoundary", std::string(wordOf(kFreeBoundaryWords, options.freeBoundary))},
            {"stretchOutline", std::string(wordOf(kStretchOutlineWords, options.stretchOutline))},
            {"authalic", options.authalic}};
}

Json fabricOf(const Fabric& fabric) {
    const auto limits = [](const StrainLimits& strain) -> Json {
        return Json::array({strain.least, strain.most});
    };
    return {{"id", fabric.id},
            {"warp", limits(fabric.warp)},
            {"weft", limits(fabric.weft)},
            {"bias", limits(fabric.bias)}};
}

Json pieceOf(const PieceSettings& settings) {
    Json piece = Json::object();
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
    if (!settings.anchors.empty()) {
        piece["anchors"] = Json::array();
        for (const Anchor& anchor : settings.anchors) {
            piece["anchors"].push_back({{"vertex", anchor.vertex}, {"at", pairOf(anchor.flat)}});
        }
    }
    return piece;
}

Json viewOf(const ProjectView& view) {
    Json json = Json::object();
    if (!view.overlay.empty()) {
        json["overlay"] = view.overlay;
    }
    json["wireframe"] = view.wireframe;
    json["designerOutline"] = view.designerOutline;
    return json;
}

}  // namespace

std::string projectText(const Project& project, const fs::path& folder) {
    Json json{{"format", "toile-project"},
              {"version", kProjectVersion},
              {"program", "Toile " + std::string(version())},
              {"files", filesOf(project, folder)},
              {"reading", readingOf(project.loading)},
              {"seams", seamsOf(project.loading.seams)},
              {"flattening", flatteningOf(project.options)},
              {"fabric", fabricOf(project.fabric)},
              {"pieces", Json::object()},
              {"view", viewOf(project.view)}};
    for (const auto& [piece, settings] : project.pieces) {
        json["pieces"][piece] = pieceOf(settings);
    }
    if (project.recoveryOf) {
        json["recoveryOf"] = textOf(*project.recoveryOf);
    }
    return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
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
