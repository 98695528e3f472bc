// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/assimp_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/geometry/point_index.h"
#include "core/io/gltf_buffers.h"
#include "core/io/soup_builder.h"
#include "core/io/tried_apart.h"

namespace toile {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

std::string_view textOf(const aiString& text) {
    return {text.data, text.length};
}

Matrix4d matrixOf(const aiMatrix4x4& m) {
    Matrix4d matrix;
    for (unsigned row = 0; row < 4; ++row) {
        for (unsigned column = 0; column < 4; ++column) {
            matrix(row, column) = static_cast<double>(m[row][column]);
        }
    }
    return matrix;
}

Vector3d vectorOf(const aiVector3D& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// The unit of the coordinates that assimp gives for a file with this ending (".fbx", in any case).
struct AssimpUnit {
    std::optional<StatedUnit> stated;  ///< none where neither format nor file says it
    double scale = 1;                  ///< factor from assimp's coordinates to that unit
};

/// FBX states how many centimetres its unit has; assimp leaves the coordinates as they are.
AssimpUnit unitOfFbx(const aiScene& scene) {
    float stated = 0;
    const bool known =
        scene.mMetaData != nullptr && scene.mMetaData->Get("UnitScaleFactor", stated);
    if (!known || !std::isfinite(stated) || stated <= 0) {
        return {};
    }
    const auto factor = static_cast<double>(stated);
    constexpr double kSame = 1e-6;  // the factor is a float
    for (const LengthUnit unit : kLengthUnits) {
        const double centimetres = millimetresPer(unit) / 10;
        if (std::abs(factor / centimetres - 1) < kSame) {
            return {StatedUnit{unit, worded("stated in the FBX file")}};
        }
    }
    return {StatedUnit{LengthUnit::Centimetre,
                       worded("the FBX file's own unit is %1 cm", {figure(factor, 3)})},
            factor};
}

AssimpUnit unitOf(const aiScene& scene, std::string_view ending) {
    if (equalsIgnoringCase(ending, ".glb") || equalsIgnoringCase(ending, ".gltf")) {
        return {StatedUnit{LengthUnit::Metre, worded("glTF files are in metres")}};
    }
    if (equalsIgnoringCase(ending, ".dae")) {
        // Assimp scales the root by the unit that the file states, metres where it states none.
        return {StatedUnit{LengthUnit::Metre,
                           worded("Collada files state their unit; read as metres")}};
    }
    return equalsIgnoringCase(ending, ".fbx") ? unitOfFbx(scene) : AssimpUnit{};
}

/// The up axis of the coordinates that assimp gives for a file with this ending. Assimp turns
/// Collada files so that y is up, and leaves the others as they are written.
std::optional<StatedUp> upOf(const aiScene& scene, std::string_view ending) {
    if (equalsIgnoringCase(ending, ".glb") || equalsIgnoringCase(ending, ".gltf")) {
        return StatedUp{UpAxis::Y, worded("glTF files have y up")};
    }
    if (equalsIgnoringCase(ending, ".dae")) {
        return StatedUp{UpAxis::Y, worded("Collada files state their up axis; read as y")};
    }
    if (equalsIgnoringCase(ending, ".3mf")) {
        return StatedUp{UpAxis::Z, worded("3MF files have z up")};
    }
    std::int32_t axis = -1;  // of FBX: 0 is x
    if (scene.mMetaData == nullptr || !scene.mMetaData->Get("UpAxis", axis) || axis < 1 ||
        axis > 2) {
        return std::nullopt;
    }
    return StatedUp{axis == 2 ? UpAxis::Z : UpAxis::Y, worded("stated in the FBX file")};
}

/// Positions and texture coordinates of one object, equal ones merged.
class ObjectCorners {
public:
    explicit ObjectCorners(const PolygonSoup& soup)
        : firstPosition_(static_cast<int>(soup.positions.size())),
          firstUv_(static_cast<int>(soup.uvs.size())) {}

    /// Its index in the soup, and whether it is new.
    std::pair<int, bool> position(const Vector3d& position) {
        const auto [index, isNew] = positionIndex_.insert(position);
        return {firstPosition_ + index, isNew};
    }

    /// Texture coordinates are one where they are equal and belong to one position.
    int uv(int position, const aiVector3D& uv) {
        const auto known = uvIndex_.insert(
            {static_cast<double>(position), static_cast<double>(uv.x), static_cast<double>(uv.y)});
        return firstUv_ + known.first;
    }

    /// Hands the texture coordinates over; the positions have been taken as they came.
    void appendUvs(std::vector<Eigen::Vector2d>& uvs) const {
        for (const Vector3d& uv : uvs_) {
            uvs.emplace_back(uv.y(), uv.z());
        }
    }

private:
    int firstPosition_, firstUv_;
    std::vector<Vector3d> positions_;
    std::vector<Vector3d> uvs_;  ///< position index, u, v
    geometry::PointIndex positionIndex_{positions_};
    geometry::PointIndex uvIndex_{uvs_};
};

class SceneReader {
public:
    SceneReader(const aiScene& scene, const std::string& name, AssimpUnit unit,
                std::optional<StatedUp> up)
        : scene_(scene), builder_(name, "face"), soup_(builder_.soup()), scale_(unit.scale) {
        soup_.statedUnit = std::move(unit.stated);
        soup_.statedUp = std::move(up);
    }

    Result<PolygonSoup> read(const Progress& progress) {
        std::vector<std::pair<const aiNode*, Matrix4d>> open;  // a tree may be deep: no recursion
        if (scene_.mRootNode != nullptr) {
            open.emplace_back(scene_.mRootNode, matrixOf(scene_.mRootNode->mTransformation));
        }
        while (!open.empty()) {
            const auto [node, placement] = open.back();
            open.pop_back();
            if (progress.isCancelled()) {
                return builder_.cancelled();
            }
            if (!readObject(*node, placement)) {
                return builder_.malformed("more corners than can be counted");
            }
            for (unsigned i = node->mNumChildren; i-- > 0;) {  // the first child is the next
                const aiNode* child = node->mChildren[i];
                open.emplace_back(child, placement * matrixOf(child->mTransformation));
            }
        }
        return builder_.finish();
    }

private:
    /// False where the corners would no longer fit an index.
    bool readObject(const aiNode& node, const Matrix4d& placement) {
        if (node.mNumMeshes == 0) {
            return true;
        }
        objects_.change(textOf(node.mName), soup_.faceCount());
        const bool mirrored = placement.topLeftCorner<3, 3>().determinant() < 0;
        ObjectCorners corners(soup_);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
            materials_.change(materialOf(mesh), soup_.faceCount());
            for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
                const aiFace& face = mesh.mFaces[f];
                if (face.mNumIndices > kMaxCorners - soup_.corners.size()) {
                    return false;
                }
                if (face.mNumIndices >= 3) {
                    readFace(mesh, face, placement, mirrored, corners);
                }
            }
        }
        corners.appendUvs(soup_.uvs);
        return true;
    }

    void readFace(const aiMesh& mesh, const aiFace& face, const Matrix4d& placement, bool mirrored,
                  ObjectCorners& corners) {
        const int place = soup_.faceCount() + 1;
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            readCorner(mesh, face.mIndices[mirrored ? face.mNumIndices - 1 - k : k], placement,
                       place, corners);
        }
        if (builder_.endFace(place)) {
            objects_.addFace();
            materials_.addFace();
        }
    }

    /// Assimp does not check the indices of every format; the builder leaves out what is not there.
    void readCorner(const aiMesh& mesh, unsigned v, const Matrix4d& placement, int place,
                    ObjectCorners& corners) {
        int position = io::kNoSuchPosition, uv = io::kNoUv;
        if (mesh.HasPositions() && v < mesh.mNumVertices) {
            const Vector3d placed =
                scale_ * (placement * vectorOf(mesh.mVertices[v]).homogeneous()).head<3>();
            const auto found = corners.position(placed);
            position = found.first;
            if (found.second) {
                builder_.addPosition(placed, place);
            }
            uv = mesh.HasTextureCoords(0) ? corners.uv(position, mesh.mTextureCoords[0][v])
                                          : io::kNoUv;
        }
        soup_.corners.push_back(position);
        soup_.cornerUvs.push_back(uv);
    }

    /// Empty where the file gives the mesh none and assimp made one up.
    std::string materialOf(const aiMesh& mesh) const {
        if (mesh.mMaterialIndex >= scene_.mNumMaterials) {
            return "";
        }
        const aiString name = scene_.mMaterials[mesh.mMaterialIndex]->GetName();
        return textOf(name) == AI_DEFAULT_MATERIAL_NAME ? "" : std::string(textOf(name));
    }

    static constexpr std::size_t kMaxCorners = std::numeric_limits<int>::max();

    const aiScene& scene_;
    io::SoupBuilder builder_;
    PolygonSoup& soup_;
    double scale_;
    io::FaceNames objects_{soup_.objects, soup_.faceObject};
    io::FaceNames materials_{soup_.materials, soup_.faceMaterial};
};

/// Of processor time: no garment takes this long, and some damaged files never end.
constexpr int kMostSeconds = 120;

/// Assimp looks for the files that a glTF names by their URIs as these are written. Only a file is
/// opened: a pipe or a device may have no end.
class FilesByUri : public Assimp::DefaultIOSystem {
public:
    bool Exists(const char* file) const override {
        return DefaultIOSystem::Exists(file) ||
               DefaultIOSystem::Exists(io::withoutEscapes(file).c_str());
    }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        Assimp::IOStream* const asWritten = openFile(file, mode);
        return asWritten != nullptr ? asWritten : openFile(io::withoutEscapes(file), mode);
    }

private:
    Assimp::IOStream* openFile(const std::string& file, const char* mode) {
        std::error_code unknown;
        return std::filesystem::is_regular_file(file, unknown)
                   ? DefaultIOSystem::Open(file.c_str(), mode)
                   : nullptr;
    }
};

const aiScene* importFile(Assimp::Importer& importer, const std::filesystem::path& path) {
    importer.SetIOHandler(new FilesByUri);  // the importer's from now on
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);  // not their ids
#ifdef AI_CONFIG_IMPORT_FBX_IGNORE_UP_DIRECTION  // newer versions turn FBX files to y up
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_IGNORE_UP_DIRECTION, true);
#endif
    return importer.ReadFile(path.string(), 0);
}

constexpr std::string_view kEndings[] = {".glb", ".gltf", ".fbx", ".dae", ".3mf"};

}  // namespace

std::span<const std::string_view> assimpEndings() {
    return kEndings;
}

bool isForAssimp(std::string_view ending) {
    return std::ranges::any_of(
        kEndings, [ending](std::string_view known) { return equalsIgnoringCase(ending, known); });
}

double precisionOfFloats(const PolygonSoup& soup) {
    double largest = 0;
    for (const Vector3d& position : soup.positions) {
        largest =
            position.allFinite() ? std::max(largest, position.cwiseAbs().maxCoeff()) : largest;
    }
    return largest * static_cast<double>(std::numeric_limits<float>::epsilon()) / 2;
}

Result<PolygonSoup> readWithAssimp(const std::filesystem::path& path, const std::string& name,
                                   Progress& progress) {
    const auto trial = io::triedApart(
        [&path] {
            Assimp::Importer importer;
            return importFile(importer, path) != nullptr ||
                   std::string_view(importer.GetErrorString()).find("bad_alloc") ==
                       std::string_view::npos;
        },
        kMostSeconds, progress);
    if (trial != io::Trial::Returns) {
        return trial == io::Trial::Cancelled
                   ? Error{ErrorCode::Cancelled, Subject::file(name)}
                   : Error{ErrorCode::MalformedFile, Subject::file(name),
                           worded("the library that reads this format does not survive it")};
    }
    Assimp::Importer importer;
    const aiScene* scene = importFile(importer, path);
    if (scene == nullptr) {
        // Assimp does not say whether the file or its bytes are at fault.
        const Result<std::string> bytes = readFile(path);
        return bytes ? Error{ErrorCode::MalformedFile, Subject::file(name),
                             readableName(importer.GetErrorString())}
                     : bytes.error();
    }
    const std::string ending = path.extension().string();
    return SceneReader(*scene, name, unitOf(*scene, ending), upOf(*scene, ending)).read(progress);
}

}  // namespace toile
