// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include <algorithm>
#include <array>
#include <map>
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

/// The project's piece that a piece of the garment is; null where it does not know it.
const ProjectPiece* find(const Project& project, const Piece& piece) {
    const auto found = std::ranges::find_if(project.pieces, [&piece](const ProjectPiece& known) {
        return known.id ? known.id == piece.id : known.name == piece.name;
    });
    return found == project.pieces.end() ? nullptr : &*found;
}

/// The anchors by the piece's present numbers; without those that lie nowhere now.
std::vector<Anchor> foundAgain(std::vector<Anchor> anchors, const Piece& piece) {
    std::map<std::array<double, 3>, int> outline;
    for (const int v : piece.boundary) {
        outline.emplace(std::array{piece.mesh.V(v, 0), piece.mesh.V(v, 1), piece.mesh.V(v, 2)}, v);
    }
    for (Anchor& anchor : anchors) {
        if (const auto point = std::exchange(anchor.point, std::nullopt)) {
            const bool isThere = anchor.vertex < piece.mesh.V.rows() &&
                                 piece.mesh.V.row(anchor.vertex).transpose() == *point;
            const auto found = outline.find({point->x(), point->y(), point->z()});
            if (!isThere && found != outline.end()) {
                anchor.vertex = found->second;
            }
        }
    }
    return anchors;
}

}  // namespace

std::vector<PieceSettings> settingsFor(const Project& project, const Garment& garment) {
    std::vector<PieceSettings> settings;
    for (const auto& piece : garment.pieces) {
        const ProjectPiece* known = find(project, *piece);
        PieceSettings& said = settings.emplace_back(known ? known->settings : PieceSettings{});
        said.anchors = foundAgain(std::move(said.anchors), *piece);
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
    std::set<const ProjectPiece*> there;
    for (const auto& piece : garment.pieces) {
        there.insert(find(project, *piece));
    }
    for (const ProjectPiece& piece : project.pieces) {
        if (!there.contains(&piece)) {
            gone.push_back(piece.name);
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
        if (result && result->flat && settings[i].anchors.empty()) {
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
