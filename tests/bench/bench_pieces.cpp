// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/bench_pieces.h"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>
#include <system_error>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/toile/pipeline.h"
#include "tests/bench/bench_meshes.h"

namespace toile::bench {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, const char*> kSharedFiles{
    {"dress", "garments/dress.obj"},
    {"face", "disks/face.obj"},
    {"mannequin-devil", "disks/mannequin-devil.off"}};

/// A folder for the life of the program.
class TemporaryFolder {
public:
    TemporaryFolder()
        : path_(fs::temp_directory_path() /
                ("toile_bench_" + std::to_string(std::random_device{}()))) {
        fs::create_directory(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

MeshArrays generated(const std::string& name) {
    const std::size_t slash = name.find('/');
    const int triangles = std::stoi(name.substr(slash + 1));
    return name.substr(0, slash) == "panel" ? panelMesh(triangles) : headMesh(triangles);
}

Pieces makePieces(const std::string& name) {
    if (!kSharedFiles.contains(name)) {
        return {std::make_shared<const Piece>(makePiece(name, generated(name)))};
    }
    Progress progress;
    const auto garment = loadGarment({sharedFile(name)}, {}, progress);
    if (!garment) {
        return {};
    }
    Pieces disks;
    std::ranges::copy_if(garment->pieces, std::back_inserter(disks),
                         [](const auto& piece) { return !piece->defect; });
    return disks;
}

std::string objText(const MeshArrays& mesh) {
    std::string text = "o piece\n";
    for (int v = 0; v < mesh.V.rows(); ++v) {
        text += 'v';
        for (int k = 0; k < 3; ++k) {
            text += ' ';
            appendFixed(text, mesh.V(v, k), 6);
        }
        text += '\n';
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
        text += 'f';
        for (int k = 0; k < 3; ++k) {
            text.append(" ").append(std::to_string(mesh.F(f, k) + 1));
        }
        text += '\n';
    }
    return text;
}

}  // namespace

const Pieces& piecesOf(const std::string& name) {
    static std::map<std::string, Pieces> kept;
    const auto found = kept.find(name);
    return found != kept.end() ? found->second : kept.emplace(name, makePieces(name)).first->second;
}

double triangleCount(const Pieces& pieces) {
    double count = 0;
    for (const auto& piece : pieces) {
        count += static_cast<double>(piece->mesh.F.rows());
    }
    return count;
}

std::vector<std::string> sharedGarments() {
    std::vector<std::string> names;
    for (const auto& [name, file] : kSharedFiles) {
        names.push_back(name);
    }
    return names;
}

fs::path sharedFile(const std::string& name) {
    return fs::path(TOILE_SHARED_DATA) / kSharedFiles.at(name);
}

fs::path sharedScan() {
    return fs::path(TOILE_SHARED_DATA) / "scans/dress_scan.obj";
}

const fs::path& temporaryFolder() {
    static const TemporaryFolder folder;
    return folder.path();
}

const fs::path& fileOf(const std::string& name) {
    static std::map<std::string, fs::path> written;
    const auto found = written.find(name);
    if (found != written.end()) {
        return found->second;
    }
    fs::path path = temporaryFolder() / (slug(name) + ".obj");
    if (const auto done = writeFile(path, objText(generated(name))); !done) {
        throw std::runtime_error(sentence(done.error()));
    }
    return written.emplace(name, std::move(path)).first->second;
}

}  // namespace toile::bench
