// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/assemble/identify.h"
#include "core/project/rigid_motion.h"

namespace toile {
namespace fs = std::filesystem;

namespace {

bool isThere(const fs::path& path) {
    std::error_code failed;
    return !path.empty() && fs::exists(path, failed) && !fs::is_directory(path, failed);
}

/// Looks at both paths and leaves the one that exists in `path`.
bool isFound(fs::path& path, fs::path& elsewhere) {
    if (isThere(path)) {
        return true;
    }
    if (!isThere(elsewhere)) {
        return false;
    }
    std::swap(path, elsewhere);
    return true;
}

/// Finds the project's entry for a piece of the garment.
class ProjectIndex {
public:
    explicit ProjectIndex(const Project& project) {
        for (const ProjectPiece& piece : project.pieces) {
            if (piece.id) {
                byId_.emplace(piece.id, &piece);
            } else {
                byName_.emplace(piece.name, &piece);
            }
        }
    }

    /// Null if the project does not know the piece.
    const ProjectPiece* find(const Piece& piece) const {
        if (const auto known = byId_.find(piece.id); known != byId_.end()) {
            return known->second;
        }
        const auto named = byName_.find(piece.name);
        return named == byName_.end() ? nullptr : named->second;
    }

private:
    std::map<PieceId, const ProjectPiece*> byId_;
    std::map<std::string_view, const ProjectPiece*> byName_;  ///< those without ids
};

/// Maps the anchors to the piece's present vertex numbers. If the file was renumbered (an outline
/// vertex lies elsewhere), anchors that are not found by position are dropped.
std::vector<Anchor> foundAgain(std::vector<Anchor> anchors, const Piece& piece) {
    std::map<std::array<double, 3>, int> outline;  // -1 if two coincide
    for (std::size_t i = 0; i < piece.boundary.size() && !anchors.empty(); ++i) {
        const int v = piece.boundary[i];
        const auto at = outline.emplace(
            std::array{piece.mesh.V(v, 0), piece.mesh.V(v, 1), piece.mesh.V(v, 2)}, v);
        at.first->second = at.second ? v : -1;
    }
    bool isRenumbered = false;
    std::vector<char> isLost(anchors.size(), 0);
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        Anchor& anchor = anchors[i];
        const auto point = std::exchange(anchor.point, std::nullopt);
        if (!point || (anchor.vertex < piece.mesh.V.rows() &&
                       piece.mesh.V.row(anchor.vertex).transpose() == *point)) {
            continue;
        }
        const auto found = outline.find({point->x(), point->y(), point->z()});
        isLost[i] = found == outline.end() || found->second < 0 ? 1 : 0;
        if (isLost[i] == 0) {
            anchor.vertex = found->second;
            isRenumbered = true;
        }
    }
    std::vector<Anchor> kept;
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        if (!isRenumbered || isLost[i] == 0) {
            kept.push_back(anchors[i]);
        }
    }
    return kept;
}

}  // namespace

std::vector<PieceSettings> settingsFor(const Project& project, const Garment& garment) {
    const ProjectIndex index(project);
    std::vector<PieceSettings> settings;
    for (const auto& piece : garment.pieces) {
        const ProjectPiece* known = index.find(*piece);
        PieceSettings& stated = settings.emplace_back(known ? known->settings : PieceSettings{});
        stated.anchors = foundAgain(std::move(stated.anchors), *piece);
    }
    return settings;
}

Problems differencesTo(const Project& project, const Garment& garment) {
    std::vector<Subject> changed, gone;
    const std::vector<FileId> fileId = fileIds(garment.files);
    for (std::size_t k = 0; k < project.files.size() && k < garment.files.size(); ++k) {
        const auto& wanted = project.files[k].hash;
        const auto& found = garment.files[k]->soup->contentHash;
        if (wanted && found && *wanted != *found) {
            changed.push_back(Subject::file(project.files[k].path.filename().string(), fileId[k]));
        }
    }
    const ProjectIndex index(project);
    std::set<const ProjectPiece*> there;
    for (const auto& piece : garment.pieces) {
        there.insert(index.find(*piece));
    }
    for (const ProjectPiece& piece : project.pieces) {
        if (!there.contains(&piece)) {
            gone.push_back(Subject::piece(piece.name, piece.id));
        }
    }
    Problems problems = aboutEach(ErrorCode::FileChanged, changed);
    const Problems more = aboutEach(ErrorCode::PieceGone, gone);
    problems.insert(problems.end(), more.begin(), more.end());
    return problems;
}

std::vector<ProjectPiece> projectPieces(const Garment& garment, std::vector<PieceSettings> settings,
                                        const PieceResults& results) {
    std::vector<ProjectPiece> pieces;
    for (std::size_t i = 0; i < settings.size() && i < garment.pieces.size(); ++i) {
        const Piece& piece = *garment.pieces[i];
        const PieceResult* result = i < results.size() ? results[i].get() : nullptr;
        const bool isAbout = result && result->flat &&
                             (settings[i].flat == 0 || settings[i].flat == result->fingerprint);
        if (isAbout && settings[i].anchors.empty()) {
            settings[i].anchors = outlineAnchors(result->piece->boundary, result->flat->Q);
        }
        for (Anchor& anchor : settings[i].anchors) {
            if (anchor.vertex >= 0 && anchor.vertex < piece.mesh.V.rows()) {
                anchor.point = piece.mesh.V.row(anchor.vertex).transpose();
            }
        }
        pieces.push_back({piece.id, piece.name, std::move(settings[i])});
    }
    return pieces;
}

std::vector<FileReference> meshReferences(const Garment& garment) {
    std::vector<FileReference> files;
    for (const auto& file : garment.files) {
        std::error_code failed;
        const fs::path absolute = fs::absolute(file->path, failed);
        files.push_back(
            {failed ? file->path : absolute.lexically_normal(), file->soup->contentHash, {}});
    }
    return files;
}

std::vector<fs::path> locateMeshes(Project& project) {
    std::vector<fs::path> missing;
    for (FileReference& file : project.files) {
        if (!isFound(file.path, file.elsewhere)) {
            missing.push_back(file.path);
        }
    }
    if (project.reference) {
        isFound(project.reference->path, project.reference->elsewhere);
    }
    isFound(project.proof.body, project.bodyElsewhere);
    return missing;
}

}  // namespace toile
