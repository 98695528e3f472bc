// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/assimp_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <assimp/BaseImporter.h>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/geometry/point_index.h"
#include "core/io/child_process.h"
#include "core/io/gltf_buffers.h"
#include "core/io/soup_builder.h"
#include "core/io/zip_reader.h"

namespace toile {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr const char* kHoldsOther = translatable("it contains %1, not %2 as its name says");
constexpr const char* kHoldsNone = translatable("it does not start like %1");
constexpr const char* kTakesMuch = translatable(
    "reading it needs more than %1 s of processor time or %2 MB of memory, too much for %3 MB; it "
    "may be damaged, or repeat its meshes too often");
constexpr const char* kPlacesMany = translatable(
    "it places %1 objects, too many for its size; export the garment alone, without instances");
constexpr const char* kElsewhere = translatable(
    "it refers to \"%1\", which is not in its folder; export it again with its files in the same "
    "folder, or as .glb");
constexpr const char* kNo3mfParts = translatable(
    "Toile cannot read 3MF files with meshes in separate parts, as slicers save them; export the "
    "mesh alone");
constexpr const char* kNoJoints =
    translatable("the joints of a skin cannot be found by name; export the mesh without its rig");

struct Format {
    std::string_view ending;
    const char* name;
};

/// Endings that assimp reads, and the names of their formats.
constexpr Format kFormats[] = {{".glb", translatable("binary glTF")},
                               {".gltf", translatable("glTF as text")},
                               {".fbx", "FBX"},
                               {".dae", "Collada"},
                               {".3mf", translatable("a ZIP archive, as 3MF is")}};
/// A .vrm file is a .glb file with data of avatars, which Toile ignores.
constexpr std::string_view kEndings[] = {".glb", ".gltf", ".fbx", ".dae", ".3mf", ".vrm"};

/// Whether the first bytes of a file fit the format of this ending.
bool beginsAs(std::string_view ending, std::string_view bytes) {
    constexpr std::size_t kLooked = 4096;
    const std::string_view start = bytes.substr(0, kLooked);
    const std::size_t blanks = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    const char first = blanks == std::string_view::npos ? '\0' : start[blanks];
    return ending == ".glb"    ? start.starts_with("glTF")
           : ending == ".gltf" ? first == '{'
           : ending == ".3mf"  ? start.starts_with("PK")
           : ending == ".dae"
               ? first == '<' || start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")
               : first != '{' && first != '<' && start.find("FBX") != std::string_view::npos;
}

/// The content of a file whose first bytes do not fit its ending.
Wording otherContent(std::string_view ending, std::string_view bytes) {
    constexpr std::pair<std::string_view, const char*> kStarts[] = {
        {"LWSC", translatable("a LightWave scene")},
        {"ply", "PLY"},
        {"OFF", "OFF"},
        {"COFF", "OFF"},
        {"solid", "STL"},
        {"#usda", "USD"},
        {"mtllib", "OBJ"},
        {"v ", "OBJ"},
        {"o ", "OBJ"},
        {"g ", "OBJ"},
        {"# Blender", "OBJ"}};
    const auto* format = std::ranges::find_if(
        kFormats, [bytes](const Format& known) { return beginsAs(known.ending, bytes); });
    const auto* start = std::ranges::find_if(
        kStarts, [bytes](const auto& known) { return bytes.starts_with(known.first); });
    const auto* own = std::ranges::find(kFormats, ending, &Format::ending);
    return start != std::end(kStarts) ? worded(kHoldsOther, {start->second, worded(own->name)})
           : format != std::end(kFormats)
               ? worded(kHoldsOther, {worded(format->name), worded(own->name)})
               : worded(kHoldsNone, {worded(own->name)});
}

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

/// A unit of this many millimetres: a named one, else millimetres, with the positions scaled.
LengthUnit takeUnit(double millimetres, std::vector<Vector3d>& positions) {
    constexpr double kSame = 1e-6;  // FBX stores a float
    for (const LengthUnit unit : kLengthUnits) {
        if (std::abs(millimetres / millimetresPer(unit) - 1) < kSame) {
            return unit;
        }
    }
    for (Vector3d& position : positions) {
        position *= millimetres;
    }
    return LengthUnit::Millimetre;
}

/// FBX states how many centimetres its unit has; assimp leaves the coordinates as they are.
double millimetresOfFbx(const aiScene& scene) {
    float stated = 0;
    const bool isKnown =
        scene.mMetaData != nullptr && scene.mMetaData->Get("UnitScaleFactor", stated);
    return isKnown && std::isfinite(stated) && stated > 0 ? 10 * static_cast<double>(stated) : 0;
}

/// 3MF states its unit at the start of the model; the default is millimetres.
double millimetresOf3mf(std::string_view archive) {
    using Unit = std::pair<std::string_view, double>;
    constexpr Unit kUnits[] = {
        {"micron", 0.001}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}};
    const std::string start = io::startOfZipEntry(archive, "3dmodel.model");
    const std::size_t model = std::min(start.find("<model"), start.size());
    std::string tag = start.substr(model, start.find('>', model) - model);
    std::ranges::replace_if(
        tag, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    const std::size_t open = tag.find_first_of("\"'", std::min(tag.find(" unit"), tag.size()));
    const std::string value =
        open < tag.size() ? tag.substr(open + 1, tag.find(tag[open], open + 1) - open - 1) : "";
    const auto* const found = std::ranges::find(kUnits, value, &Unit::first);
    return found == std::end(kUnits) ? 1 : found->second;
}

/// The axis that FBX states, by its index, if it is y or z.
std::optional<StatedUp> upOfFbx(const aiScene& scene) {
    std::int32_t axis = 0;
    const bool isKnown = scene.mMetaData != nullptr && scene.mMetaData->Get("UpAxis", axis);
    return isKnown && (axis == 1 || axis == 2)
               ? std::optional(StatedUp{axis == 1 ? UpAxis::Y : UpAxis::Z, {}})
               : std::nullopt;
}

/// The unit and the up axis that the format or the file states. Assimp turns Collada files to y up,
/// and leaves the others as written.
void stateConventions(std::string_view ending, std::string_view bytes, PolygonSoup& soup) {
    if (ending == ".glb" || ending == ".gltf") {
        soup.statedUnit = StatedUnit{LengthUnit::Metre, worded("glTF files are in metres")};
        soup.statedUp = StatedUp{UpAxis::Y, worded("y is up in glTF files")};
    } else if (ending == ".dae") {
        // Assimp scales the root by the unit that the file states, by default metres.
        soup.statedUnit =
            StatedUnit{LengthUnit::Metre, worded("Collada files state their unit; read as metres")};
        soup.statedUp = StatedUp{UpAxis::Y, worded("Collada files state their up axis; read as y")};
    } else if (ending == ".3mf") {
        soup.statedUnit = StatedUnit{takeUnit(millimetresOf3mf(bytes), soup.positions),
                                     worded("stated in the 3MF file")};
        soup.statedUp = StatedUp{UpAxis::Z, worded("z is up in 3MF files")};
    }
    if (ending == ".fbx" && soup.statedUnit) {
        soup.statedUnit->reason = worded("stated in the FBX file");
    }
    if (ending == ".fbx" && soup.statedUp) {
        soup.statedUp->reason = worded("stated in the FBX file");
    }
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

    /// Merges equal texture coordinates of one position.
    int uv(int position, const aiVector3D& uv) {
        const auto known = uvIndex_.insert(
            {static_cast<double>(position), static_cast<double>(uv.x), static_cast<double>(uv.y)});
        return firstUv_ + known.first;
    }

    /// Appends its texture coordinates; its positions are in the soup already.
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
    /// @param most  maximum number of corners and vertices to place
    SceneReader(const aiScene& scene, const std::string& name, std::uint64_t most)
        : scene_(scene), builder_(name, "face"), soup_(builder_.soup()), most_(most) {}

    Result<PolygonSoup> read(bool hasSkins) {
        placeNodes();
        if (placed_ > most_) {
            return Error{ErrorCode::FileUnreadable, Subject::file(builder_.name()),
                         worded(kPlacesMany, {figure(static_cast<double>(nodes_.size()))})};
        }
        for (const auto& [node, placement] : nodes_) {
            if (!readObject(*node, placement, hasSkins)) {
                return Error{ErrorCode::MalformedFile, Subject::file(builder_.name()),
                             worded(kNoJoints)};
            }
        }
        return builder_.finish();
    }

private:
    using PlacedNode = std::pair<const aiNode*, Matrix4d>;

    /// Lists the nodes that have meshes and counts the corners they place before copying any: a
    /// small file may place one mesh very often.
    void placeNodes() {
        constexpr std::uint64_t kPerObject = 150;  // cost of an object in corners
        std::vector<std::uint64_t> sizes(scene_.mNumMeshes, 0);
        for (unsigned m = 0; m < scene_.mNumMeshes; ++m) {
            const aiMesh& mesh = *scene_.mMeshes[m];
            sizes[m] = std::uint64_t{mesh.mNumVertices} + kPerObject;
            for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
                sizes[m] += mesh.mFaces[f].mNumIndices;
            }
        }
        std::vector<PlacedNode> open;  // a tree may be deep: no recursion
        if (scene_.mRootNode != nullptr) {
            open.emplace_back(scene_.mRootNode, matrixOf(scene_.mRootNode->mTransformation));
        }
        while (!open.empty()) {
            const PlacedNode at = open.back();
            const aiNode& node = *at.first;
            open.pop_back();
            for (unsigned i = 0; i < node.mNumMeshes; ++i) {
                placed_ += sizes[node.mMeshes[i]];
            }
            (node.mNumMeshes > 0 ? nodes_ : joints_[std::string(textOf(node.mName))]).push_back(at);
            for (unsigned i = node.mNumChildren; i-- > 0;) {  // visits the first child next
                const aiNode* child = node.mChildren[i];
                open.emplace_back(child, at.second * matrixOf(child->mTransformation));
            }
        }
    }

    /// False if the joints of a skin cannot be found.
    bool readObject(const aiNode& node, const Matrix4d& placement, bool hasSkins) {
        objects_.change(textOf(node.mName), soup_.faceCount());
        ObjectCorners corners(soup_);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
            materials_.change(materialOf(mesh), soup_.faceCount());
            const bool isSkinned = hasSkins && mesh.HasBones();
            if (!(isSkinned ? placeBySkin(mesh) : placeByNode(mesh, placement))) {
                return false;
            }
            for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
                if (mesh.mFaces[f].mNumIndices >= 3) {  // skip points and lines
                    readFace(mesh, mesh.mFaces[f], corners);
                }
            }
        }
        corners.appendUvs(soup_.uvs);
        return true;
    }

    bool placeByNode(const aiMesh& mesh, const Matrix4d& placement) {
        positions_.resize(mesh.HasPositions() ? mesh.mNumVertices : 0);
        for (std::size_t v = 0; v < positions_.size(); ++v) {
            positions_[v] = (placement * vectorOf(mesh.mVertices[v]).homogeneous()).head<3>();
        }
        isMirrored_ = placement.topLeftCorner<3, 3>().determinant() < 0;
        return true;
    }

    /// Only joints and inverse bind matrices place a mesh with a skin, not its node (glTF 2.0,
    /// 3.7.3). Assimp names joints after their nodes.
    bool placeBySkin(const aiMesh& mesh) {
        std::vector<double> weights(mesh.mNumVertices, 0);
        std::vector<Vector3d> sums(mesh.mNumVertices, Vector3d::Zero());
        for (unsigned b = mesh.mNumBones; b-- > 0;) {
            const aiBone& bone = *mesh.mBones[b];
            const auto joint = joints_.find(std::string(textOf(bone.mName)));
            if (joint == joints_.end() || joint->second.size() != 1) {
                return false;
            }
            const Matrix4d pose = joint->second.front().second * matrixOf(bone.mOffsetMatrix);
            if (b == 0) {  // vertices without weights follow the first joint, as in viewers
                placeByNode(mesh, pose);
            }
            for (unsigned w = 0; w < bone.mNumWeights; ++w) {
                const unsigned v = bone.mWeights[w].mVertexId;
                const auto weight = static_cast<double>(bone.mWeights[w].mWeight);
                if (v < mesh.mNumVertices) {
                    sums[v] +=
                        weight * (pose * vectorOf(mesh.mVertices[v]).homogeneous()).head<3>();
                    weights[v] += weight;
                }
            }
        }
        for (std::size_t v = 0; v < positions_.size(); ++v) {
            positions_[v] = weights[v] > 0 ? Vector3d(sums[v] / weights[v]) : positions_[v];
        }
        return true;
    }

    void readFace(const aiMesh& mesh, const aiFace& face, ObjectCorners& corners) {
        const int place = soup_.faceCount() + 1;
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            readCorner(mesh, face.mIndices[isMirrored_ ? face.mNumIndices - 1 - k : k], place,
                       corners);
        }
        if (builder_.endFace(place)) {
            objects_.addFace();
            materials_.addFace();
        }
    }

    /// Assimp does not check the indices of every format; the builder drops missing ones.
    void readCorner(const aiMesh& mesh, unsigned v, int place, ObjectCorners& corners) {
        int position = io::kNoSuchPosition, uv = io::kNoUv;
        if (v < positions_.size()) {
            const auto found = corners.position(positions_[v]);
            position = found.first;
            if (found.second) {
                builder_.addPosition(positions_[v], place);
            }
            uv = mesh.HasTextureCoords(0) ? corners.uv(position, mesh.mTextureCoords[0][v])
                                          : io::kNoUv;
        }
        soup_.corners.push_back(position);
        soup_.cornerUvs.push_back(uv);
    }

    /// Empty if the file gives the mesh no material and assimp made one up.
    std::string materialOf(const aiMesh& mesh) const {
        if (mesh.mMaterialIndex >= scene_.mNumMaterials) {
            return "";
        }
        const aiString name = scene_.mMaterials[mesh.mMaterialIndex]->GetName();
        return textOf(name) == AI_DEFAULT_MATERIAL_NAME ? "" : std::string(textOf(name));
    }

    const aiScene& scene_;
    io::SoupBuilder builder_;
    PolygonSoup& soup_;
    std::uint64_t most_, placed_ = 0;
    std::vector<PlacedNode> nodes_;                          ///< those that have meshes
    std::map<std::string, std::vector<PlacedNode>> joints_;  ///< all others, by name
    std::vector<Vector3d> positions_;                        ///< of the current mesh
    bool isMirrored_ = false;
    io::FaceNames objects_{soup_.objects, soup_.faceObject};
    io::FaceNames materials_{soup_.materials, soup_.faceMaterial};
};

/// Opens the file itself and, read-only, files that `pathBelow` finds in its folder.
class FolderFiles : public Assimp::DefaultIOSystem {
public:
    /// @param called  the name under which assimp opens the file
    FolderFiles(std::filesystem::path file, std::string called, std::string& refused)
        : file_(std::move(file)), called_(std::move(called)), refused_(refused) {}

    bool Exists(const char* name) const override { return !find(name).empty(); }
    Assimp::IOStream* Open(const char* name, const char* mode) override {
        const std::string path = *mode == 'r' ? find(name) : "";
        return path.empty() ? nullptr : DefaultIOSystem::Open(path.c_str(), mode);
    }

private:
    /// The path of a regular file, or nothing. URIs can contain escapes.
    std::string find(const char* name) const {
        std::error_code unknown;
        if (called_ == name) {
            return std::filesystem::is_regular_file(file_, unknown) ? file_.string() : "";
        }
        for (const std::string& written : {std::string(name), io::withoutEscapes(name)}) {
            if (std::filesystem::exists(written, unknown)) {
                const auto path = io::pathBelow(file_.parent_path(), written);
                if (!path && refused_.empty()) {
                    refused_ = written;
                }
                return path && std::filesystem::is_regular_file(*path, unknown) ? path->string()
                                                                                : "";
            }
        }
        return "";
    }

    std::filesystem::path file_;
    std::string called_;
    std::string& refused_;  ///< the first name that points outside the folder
};

/// Keeps only the importers of an ending (".glb"): assimp would also choose by content.
void keepImportersOf(std::string_view ending, Assimp::Importer& importer) {
    for (std::size_t k = importer.GetImporterCount(); k-- > 0;) {
        Assimp::BaseImporter* const other = importer.GetImporter(k);
        const std::string endings =
            " " + std::string(importer.GetImporterInfo(k)->mFileExtensions) + " ";
        if (endings.find(" " + std::string(ending.substr(1)) + " ") == std::string::npos) {
            importer.UnregisterLoader(other);
            delete other;  // the importer does not own it any more
        }
    }
}

/// Limits for reading a file of this many bytes. Garments need about a tenth of them.
io::ChildLimits limitsFor(std::size_t bytes) {
    constexpr std::uintmax_t kMemory = 400'000'000, kMemoryPerByte = 100;
    constexpr double kSeconds = 4, kSecondsPerByte = 1.2e-6;
    return {static_cast<int>(kSeconds + kSecondsPerByte * static_cast<double>(bytes)),
            kMemory + kMemoryPerByte * bytes};
}

std::uint64_t maxCornersFor(std::size_t bytes) {
    constexpr std::uint64_t kCorners = 1'500'000, kCornersPerByte = 4;
    return std::min<std::uint64_t>(kCorners + kCornersPerByte * bytes,
                                   std::numeric_limits<int>::max());
}

/// Runs in the child process. Throws std::bad_alloc.
Result<PolygonSoup> readScene(const std::filesystem::path& path, std::string_view ending,
                              const std::string& name, std::uint64_t maxCorners) {
    std::string outside;
    Assimp::Importer importer;
    keepImportersOf(ending, importer);
    const bool isCalledSo = equalsIgnoringCase(path.extension().string(), ending);
    const std::string called = path.string() + (isCalledSo ? "" : std::string(ending));
    importer.SetIOHandler(new FolderFiles(path, called, outside));  // owned by the importer
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);  // not their ids
#ifdef AI_CONFIG_IMPORT_FBX_IGNORE_UP_DIRECTION  // newer versions turn FBX files to y up
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_IGNORE_UP_DIRECTION, true);
#endif
    const aiScene* const scene = importer.ReadFile(called, 0);
    if (!outside.empty()) {
        return Error{ErrorCode::FileUnreadable, Subject::file(name),
                     worded(kElsewhere, {shownText(outside)})};
    }
    if (scene == nullptr) {
        const std::string why = importer.GetErrorString();
        if (why.find("bad_alloc") != std::string::npos) {
            throw std::bad_alloc();
        }
        return Error{ErrorCode::MalformedFile, Subject::file(name), readableName(why)};
    }
    auto soup = SceneReader(*scene, name, maxCorners).read(ending == ".gltf" || ending == ".glb");
    if (soup && ending == ".fbx") {
        if (const double unit = millimetresOfFbx(*scene); unit > 0) {
            soup->statedUnit = StatedUnit{takeUnit(unit, soup->positions), {}};
        }
        soup->statedUp = upOfFbx(*scene);
    }
    return soup;
}

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

Result<PolygonSoup> readWithAssimp(const std::filesystem::path& path, std::string_view bytes,
                                   const std::string& name, Progress& progress) {
    const auto* const known = std::ranges::find_if(kEndings, [&path](std::string_view ending) {
        return equalsIgnoringCase(path.extension().string(), ending);
    });
    const std::string_view ending =
        known == std::end(kEndings) || *known == ".vrm" ? kEndings[0] : *known;
    const Subject subject = Subject::file(name);
    if (!beginsAs(ending, bytes)) {
        return Error{ErrorCode::MalformedFile, subject, otherContent(ending, bytes)};
    }
    const io::ChildLimits limits = limitsFor(bytes.size());
    const io::ChildResult child = io::runInChild(
        [&] { return io::packedSoup(readScene(path, ending, name, maxCornersFor(bytes.size()))); },
        limits, progress);
    if (child.end == io::ChildEnd::Cancelled) {
        return Error{ErrorCode::Cancelled, subject};
    }
    if (child.end == io::ChildEnd::BeyondLimits) {
        return Error{ErrorCode::FileUnreadable, subject,
                     worded(kTakesMuch, {figure(limits.seconds),
                                         figure(static_cast<double>(limits.memory) / 1e6),
                                         figure(static_cast<double>(bytes.size()) / 1e6, 3)})};
    }
    if (child.end == io::ChildEnd::Crashed) {
        return Error{ErrorCode::MalformedFile, subject,
                     worded("the library that reads this format crashed on it")};
    }
    Result<PolygonSoup> soup = io::unpackedSoup(child.output, name);
    if (soup) {
        stateConventions(ending, bytes, *soup);
    } else if (soup.error().code == ErrorCode::NoGeometry && ending == ".3mf") {
        return Error{ErrorCode::NoGeometry, subject, worded(kNo3mfParts)};
    }
    return soup;
}

}  // namespace toile
