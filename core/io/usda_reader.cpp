// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/usda_reader.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/point_index.h"
#include "core/io/soup_builder.h"
#include "core/io/usd_text.h"

namespace toile {
namespace {

/// Outside of io, because the collector of translations knows the texts of toile.
constexpr const char* kCages = translatable(
    "subdivision is not applied to %1 of its meshes, and the smooth cloth is smaller; apply it in "
    "the modelling program");

}  // namespace
}  // namespace toile

namespace toile::io {
namespace {

/// The transform from a prim's own coordinates to the world, from its parent's transform and the
/// operations of its `xformOpOrder`. Nothing if one is not understood. Pure.
std::optional<Eigen::Matrix4d> usdPlacement(const UsdPrim& prim, const Eigen::Matrix4d& parent);

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr std::string_view kInvert = "!invert!", kReset = "!resetXformStack!", kOp = "xformOp:";

Eigen::Matrix3d turnAround(char axis, double degrees) {
    return AngleAxisd(degrees * kRadiansPerDegree, Vector3d::Unit(axis - 'X')).toRotationMatrix();
}

/// "rotateXYZ": around x first, then around y and z. One axis, or all three.
std::optional<Affine3d> rotation(std::string_view axes, const std::vector<double>& degrees) {
    if (axes.empty() || degrees.size() != axes.size() ||
        axes.find_first_not_of("XYZ") != std::string_view::npos) {
        return {};
    }
    Affine3d turned = Affine3d::Identity();
    for (const char axis : axes) {
        const std::size_t k = axes.size() == 1 ? 0 : static_cast<std::size_t>(axis - 'X');
        turned = turnAround(axis, degrees[k]) * turned;
    }
    return turned;
}

/// @param kind  "translate", "rotateX" ...
std::optional<Affine3d> operation(std::string_view kind, const std::vector<double>& numbers) {
    const auto vector = [&numbers] { return Vector3d(numbers[0], numbers[1], numbers[2]); };
    if (kind == "translate" && numbers.size() == 3) {
        return Affine3d(Eigen::Translation3d(vector()));
    }
    if (kind == "scale" && numbers.size() == 3) {
        return Affine3d(Eigen::Scaling(vector()));
    }
    if (kind == "orient" && numbers.size() == 4) {
        const Eigen::Quaterniond turn(numbers[0], numbers[1], numbers[2], numbers[3]);
        return turn.norm() > 0 ? std::optional(Affine3d(turn.normalized())) : std::nullopt;
    }
    if (kind == "transform" && numbers.size() == 16) {
        Affine3d placed;
        placed.matrix() = Eigen::Map<const Matrix4d>(numbers.data());  // rows there, columns here
        return placed;
    }
    return kind.starts_with("rotate") ? rotation(kind.substr(6), numbers) : std::nullopt;
}

std::optional<Matrix4d> usdPlacement(const UsdPrim& prim, const Matrix4d& parent) {
    Matrix4d placed = parent;
    const std::string* order = prim.find("xformOpOrder");
    for (const std::string& stated : order ? usdStrings(*order) : std::vector<std::string>()) {
        std::string_view name = stated;
        if (name == kReset) {
            placed = Matrix4d::Identity();
            continue;
        }
        const bool isInverse = name.starts_with(kInvert);
        name.remove_prefix(isInverse ? kInvert.size() : 0);
        const auto numbers = usdNumbersOf(prim, std::string(name));
        if (!numbers || !name.starts_with(kOp)) {
            return {};
        }
        std::string_view kind = name.substr(kOp.size());
        kind = kind.substr(0, kind.find(':'));
        const auto step = operation(kind, *numbers);
        if (!step) {
            return {};
        }
        placed = placed * (isInverse ? Matrix4d(step->matrix().inverse()) : step->matrix());
    }
    return placed.allFinite() ? std::optional(placed) : std::nullopt;
}

}  // namespace

}  // namespace toile::io

namespace toile {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using io::UsdPrim;

constexpr std::size_t kMaxFaceCorners = std::numeric_limits<int>::max();

/// The last name of a path: </Shirt/Looks/Denim>.
std::string_view lastName(std::string_view path) {
    path.remove_prefix(path.rfind('/') + 1);
    return path.substr(0, path.find('>'));
}

bool says(const UsdPrim& prim, std::string_view attribute, std::string_view value) {
    const std::string* found = prim.find(attribute);
    return found && *found == value;
}

bool isShown(const UsdPrim& prim) {
    return prim.specifier == "def" && !says(prim, "visibility", "invisible") &&
           !says(prim, "purpose", "guide") && !says(prim, "purpose", "proxy");
}

/// Whole numbers that fit an int.
std::optional<std::vector<int>> countsOf(const UsdPrim& prim, const std::string& attribute) {
    const auto numbers = io::usdNumbersOf(prim, attribute);
    if (!numbers) {
        return {};
    }
    std::vector<int> counts;
    counts.reserve(numbers->size());
    for (const double number : *numbers) {
        if (number != std::floor(number) || std::abs(number) > std::numeric_limits<int>::max()) {
            return {};
        }
        counts.push_back(static_cast<int>(number));
    }
    return counts;
}

/// Texture coordinates by corner or by point.
struct Texture {
    std::vector<double> st;
    std::vector<int> indices;  ///< into pairs of `st`; empty: in order
    bool byPoint = false;

    /// Null if there is none.
    const double* at(std::size_t corner, int point) const {
        std::size_t k = byPoint ? static_cast<std::size_t>(point) : corner;
        if (!indices.empty()) {
            if (k >= indices.size() || indices[k] < 0) {
                return nullptr;
            }
            k = static_cast<std::size_t>(indices[k]);
        }
        return k < st.size() / 2 ? &st[2 * k] : nullptr;
    }
};

Texture textureOf(const UsdPrim& prim, std::size_t points, std::size_t corners) {
    for (const char* attribute : {"primvars:st", "primvars:UVMap", "primvars:map1"}) {
        auto st = io::usdNumbersOf(prim, attribute);
        if (!st || st->empty() || st->size() % 2 != 0) {
            continue;
        }
        Texture texture{
            std::move(*st),
            countsOf(prim, attribute + std::string(":indices")).value_or(std::vector<int>())};
        const std::size_t values =
            texture.indices.empty() ? texture.st.size() / 2 : texture.indices.size();
        const auto metadata = prim.metadata.find(attribute);
        const bool isFaceVarying = metadata != prim.metadata.end() &&
                                   metadata->second.find("faceVarying") != std::string::npos;
        texture.byPoint = values == points && !(isFaceVarying && values == corners);
        return texture.byPoint || values == corners ? texture : Texture();
    }
    return {};
}

struct UsdUnit {
    StatedUnit stated;
    double scale = 1;  ///< factor from the file's coordinates to that unit
};

UsdUnit unitOfStage(const io::UsdStage& stage) {
    constexpr double kUsual = 0.01, kSame = 1e-6, kMillimetresPerMetre = 1000;
    double metres = kUsual;
    const auto stated = stage.metadata.find("metersPerUnit");
    if (stated != stage.metadata.end()) {
        const auto numbers = io::usdNumbers(&stated->second);
        if (numbers && numbers->size() == 1 && numbers->front() > 0) {
            metres = numbers->front();
        }
    }
    for (const LengthUnit unit : kLengthUnits) {
        if (std::abs(metres * kMillimetresPerMetre / millimetresPer(unit) - 1) < kSame) {
            return {{unit, stated == stage.metadata.end()
                               ? worded("USD files that state no unit are in cm")
                               : worded("stated in the USD file")}};
        }
    }
    return {{LengthUnit::Metre, worded("the USD file states a unit of %1 m", {figure(metres, 6)})},
            metres};
}

StatedUp upOfStage(const io::UsdStage& stage) {
    const auto up = stage.metadata.find("upAxis");
    return up == stage.metadata.end()
               ? StatedUp{UpAxis::Y, worded("USD files that state no up axis have y up")}
               : StatedUp{up->second == "Z" ? UpAxis::Z : UpAxis::Y,
                          worded("stated in the USD file")};
}

class StageReader {
public:
    StageReader(const io::UsdStage& stage, const std::string& name)
        : stage_(stage), builder_(name, "face"), soup_(builder_.soup()) {
        takeUnit();
        soup_.statedUp = upOfStage(stage_);
    }

    Result<PolygonSoup> read(const Progress& progress) {
        if (const char* wrong = readAll(stage_.prims, Matrix4d::Identity(), {}, false, progress)) {
            return builder_.malformed(wrong);
        }
        if (progress.isCancelled()) {
            return builder_.cancelled();
        }
        auto soup = builder_.finish();
        if (soup && cages_ > 0) {
            soup->problems.push_back({ErrorCode::OutputDiffers, Subject::file(builder_.name()),
                                      worded(kCages, {figure(cages_)})});
        }
        return soup;
    }

private:
    void takeUnit() {
        UsdUnit unit = unitOfStage(stage_);
        soup_.statedUnit = std::move(unit.stated);
        scale_ = unit.scale;
    }

    /// Returns the fault, or null. Recursion is limited by the depth of the text.
    const char* readAll(const std::vector<UsdPrim>& prims, const Matrix4d& parent,
                        std::string_view material, bool isOurs, const Progress& progress) {
        for (const UsdPrim& prim : prims) {
            if (!isShown(prim) || (isOurs && prim.name == "pattern")) {
                continue;
            }
            if (progress.isCancelled()) {
                return nullptr;
            }
            const auto placement = io::usdPlacement(prim, parent);
            if (!placement) {
                return "a transform cannot be read";
            }
            const std::string* bound = prim.find("material:binding");
            const std::string_view own = bound ? lastName(*bound) : material;
            const char* wrong = prim.type == "Mesh" ? readMesh(prim, *placement, own) : nullptr;
            wrong = wrong ? wrong
                          : readAll(prim.children, *placement, own, prim.name == "Toile", progress);
            if (wrong) {
                return wrong;
            }
        }
        return nullptr;
    }

    /// The material of each face, if subsets set it; else empty.
    static std::vector<std::string_view> subsetMaterials(const UsdPrim& mesh, std::size_t faces,
                                                         std::string_view material) {
        std::vector<std::string_view> ofFaces;
        for (const UsdPrim& subset : mesh.children) {
            const std::string* bound = subset.find("material:binding");
            const auto indices = countsOf(subset, "indices");
            if (subset.type != "GeomSubset" || !bound || !indices) {
                continue;
            }
            ofFaces.resize(faces, material);
            for (const int face : *indices) {
                if (face >= 0 && static_cast<std::size_t>(face) < faces) {
                    ofFaces[static_cast<std::size_t>(face)] = lastName(*bound);
                }
            }
        }
        return ofFaces;
    }

    const char* readMesh(const UsdPrim& prim, const Matrix4d& placement,
                         std::string_view material) {
        const auto points = io::usdNumbersOf(prim, "points");
        const auto counts = countsOf(prim, "faceVertexCounts");
        const auto corners = countsOf(prim, "faceVertexIndices");
        if (!points || points->size() % 3 != 0 || !counts || !corners) {
            return "a mesh has no points, or its faces cannot be read";
        }
        std::size_t sum = 0;
        for (const int count : *counts) {
            sum += count < 0 ? kMaxFaceCorners : static_cast<std::size_t>(count);
            if (sum > corners->size()) {
                break;
            }
        }
        const std::size_t pointCount = points->size() / 3;
        if (sum != corners->size() || sum > kMaxFaceCorners - soup_.corners.size() ||
            pointCount > kMaxFaceCorners - soup_.positions.size()) {
            return "the corners of a mesh do not match its face counts";
        }
        const std::string* scheme = prim.find("subdivisionScheme");  // default: catmullClark
        cages_ += scheme && (*scheme == "none" || *scheme == "bilinear") ? 0 : 1;
        const std::string* called = prim.find("toile:name");
        objects_.change(called ? *called : prim.name, soup_.faceCount());
        const int first = static_cast<int>(soup_.positions.size());
        for (std::size_t k = 0; k < pointCount; ++k) {
            const Vector3d point((*points)[3 * k], (*points)[3 * k + 1], (*points)[3 * k + 2]);
            builder_.addPosition(scale_ * (placement * point.homogeneous()).head<3>(),
                                 soup_.faceCount() + 1);
        }
        const bool isTurned = (placement.topLeftCorner<3, 3>().determinant() < 0) !=
                              says(prim, "orientation", "leftHanded");
        const Texture texture = textureOf(prim, pointCount, corners->size());
        const auto materials = subsetMaterials(prim, counts->size(), material);
        std::size_t at = 0;
        for (std::size_t f = 0; f < counts->size(); ++f) {
            materials_.change(materials.empty() ? material : materials[f], soup_.faceCount());
            const auto count = static_cast<std::size_t>((*counts)[f]);
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t corner = at + (isTurned ? count - 1 - k : k);
                addCorner((*corners)[corner], corner, first, pointCount, texture);
            }
            at += count;
            if (builder_.endFace(soup_.faceCount() + 1)) {
                objects_.addFace();
                materials_.addFace();
            }
        }
        return nullptr;
    }

    void addCorner(int point, std::size_t corner, int first, std::size_t points,
                   const Texture& texture) {
        const bool isThere = point >= 0 && static_cast<std::size_t>(point) < points;
        const int position = isThere ? first + point : io::kNoSuchPosition;
        const double* st = isThere ? texture.at(corner, point) : nullptr;
        soup_.corners.push_back(position);
        soup_.cornerUvs.push_back(
            st ? uvIndex_.insert({static_cast<double>(position), st[0], st[1]}).first : io::kNoUv);
        if (uvs_.size() > soup_.uvs.size()) {
            soup_.uvs.emplace_back(st[0], st[1]);
        }
    }

    const io::UsdStage& stage_;
    io::SoupBuilder builder_;
    PolygonSoup& soup_;
    double scale_ = 1;
    int cages_ = 0;              ///< meshes that USD viewers show subdivided
    std::vector<Vector3d> uvs_;  ///< position index, u, v
    geometry::PointIndex uvIndex_{uvs_};
    io::FaceNames objects_{soup_.objects, soup_.faceObject};
    io::FaceNames materials_{soup_.materials, soup_.faceMaterial};
};

}  // namespace

Result<PolygonSoup> readUsd(std::shared_ptr<const std::string> text, const std::string& name,
                            Progress& progress) {
    const Result<io::UsdStage> stage = io::parseUsd(*text);
    text.reset();  // all values are copied by now
    if (!stage) {
        return Error{stage.error().code, Subject::file(name), stage.error().detail};
    }
    return StageReader(*stage, name).read(progress);
}

}  // namespace toile
