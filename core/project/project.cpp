// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "core/project/rigid_motion.h"

namespace toile {
namespace fs = std::filesystem;

namespace {

bool isThere(const fs::path& path) {
    std::error_code failed;
    return !path.empty() && fs::exists(path, failed) && !fs::is_directory(path, failed);
}

}  // namespace

std::vector<PieceSettings> settingsFor(const Project& project, const Garment& garment) {
    std::vector<PieceSettings> settings;
    for (const auto& piece : garment.pieces) {
        const auto known = project.pieces.find(piece->name);
        settings.push_back(known == project.pieces.end() ? PieceSettings{} : known->second);
    }
    return settings;
}

Problems differencesTo(const Project& project, const Garment& garment) {
    std::vector<std::string> changed, gone;
    for (std::size_t k = 0; k < project.files.size() && k < garment.files.size(); ++k) {
        const auto& wanted = project.files[k].hash;
        const auto& found = garment.files[k]->soup.contentHash;
        if (wanted && found && *wanted != *found) {
            changed.push_back(project.files[k].path.filename().string());
        }
    }
    std::set<std::string> there;
    for (const auto& piece : garment.pieces) {
        there.insert(piece->name);
    }
    for (const auto& entry : project.pieces) {
        if (!there.contains(entry.first)) {
            gone.push_back(entry.first);
        }
    }
    Problems problems = aboutEach(ErrorCode::FileChanged, changed);
    const Problems more = aboutEach(ErrorCode::PieceGone, gone);
    problems.insert(problems.end(), more.begin(), more.end());
    return problems;
}

std::map<std::string, PieceSettings> settingsByName(const Garment& garment,
                                                    std::vector<PieceSettings> settings,
                                                    const PieceResults& results) {
    std::map<std::string, PieceSettings> byName;
    for (std::size_t i = 0; i < settings.size() && i < garment.pieces.size(); ++i) {
        const PieceResult* result = i < results.size() ? results[i].get() : nullptr;
        if (result && result->flat && settings[i].anchors.empty()) {
            settings[i].anchors = outlineAnchors(result->piece->boundary, result->flat->Q);
        }
        byName.emplace(garment.pieces[i]->name, std::move(settings[i]));
    }
    return byName;
}

std::vector<MeshReference> meshReferences(const Garment& garment) {
    std::vector<MeshReference> files;
    for (const auto& file : garment.files) {
        std::error_code failed;
        const fs::path absolute = fs::absolute(file->path, failed);
        files.push_back(
            {failed ? file->path : absolute.lexically_normal(), file->soup.contentHash, {}});
    }
    return files;
}

std::vector<fs::path> locateMeshes(Project& project) {
    std::vector<fs::path> missing;
    for (MeshReference& file : project.files) {
        if (isThere(file.path)) {
            continue;
        }
        if (isThere(file.elsewhere)) {
            std::swap(file.path, file.elsewhere);
        } else {
            missing.push_back(file.path);
        }
    }
    return missing;
}

}  // namespace toile
