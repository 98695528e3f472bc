// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <optional>

#include "core/io/usd_text.h"
#include "tests/core/readers/mesh_file.h"

namespace toile {
namespace {

using io::usdNumbers;
using io::UsdPrim;

constexpr double kMillimetresPerSt = 1000;

template <class Matrix>
std::optional<Matrix> rowsFrom(const std::string* text) {
    constexpr int kColumns = Matrix::ColsAtCompileTime;
    const auto numbers = usdNumbers(text);
    if (!numbers || numbers->size() % kColumns != 0) {
        return {};
    }
    Matrix rows(static_cast<Eigen::Index>(numbers->size()) / kColumns, kColumns);
    for (std::size_t k = 0; k < numbers->size(); ++k) {
        rows(static_cast<Eigen::Index>(k / kColumns), static_cast<Eigen::Index>(k % kColumns)) =
            static_cast<typename Matrix::Scalar>((*numbers)[k]);
    }
    return rows;
}

std::optional<FileMesh> usdMesh(const UsdPrim& prim) {
    const auto points = rowsFrom<Points3>(prim.find("points"));
    // As they are read: not every number is an index.
    const auto corners = rowsFrom<Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(
        prim.find("faceVertexIndices"));
    if (!points || !corners || (corners->array() < 0).any() ||
        (corners->array() >= static_cast<double>(points->rows())).any()) {
        return {};
    }
    FileMesh mesh;
    const std::string* name = prim.find("toile:name");
    mesh.name = name ? *name : prim.name;
    if (mesh.name.size() > kLongestMeshName) {
        return {};
    }
    mesh.V = *points;
    mesh.F = corners->cast<int>();
    if (const std::string* st = prim.find("primvars:st")) {
        const auto uv = rowsFrom<Points2>(st);
        if (!uv || uv->rows() != points->rows()) {
            return {};
        }
        mesh.uv = kMillimetresPerSt * *uv;
    }
    return mesh;
}

/// The garment's meshes by the names of their prims.
using MeshesByPrim = std::map<std::string_view, const FileMesh*>;

/// The mesh that a path names; null where there is none.
const FileMesh* meshAt(const MeshesByPrim& meshes, const std::string* path) {
    const std::size_t slash = path ? path->rfind('/') : std::string::npos;
    if (slash == std::string::npos || !path->ends_with('>')) {
        return nullptr;
    }
    const std::string_view prim = std::string_view(*path).substr(slash + 1);
    const auto found = meshes.find(prim.substr(0, prim.size() - 1));
    return found == meshes.end() ? nullptr : found->second;
}

std::optional<FileSeam> usdSeam(const UsdPrim& prim, const MeshesByPrim& meshes) {
    FileSeam seam;
    const std::string* name = prim.find("toile:name");
    seam.name = name ? *name : "";
    constexpr const char* kSides[] = {"toile:left", "toile:right"};
    for (std::size_t k = 0; k < 2; ++k) {
        const FileMesh* mesh = meshAt(meshes, prim.find(kSides[k]));
        const auto numbers = usdNumbers(prim.find(std::string(kSides[k]) + "Vertices"));
        if (!mesh || !numbers) {
            return {};
        }
        seam.mesh[k] = mesh->name;
        for (const double number : *numbers) {
            if (number < 0 || number >= static_cast<double>(mesh->V.rows()) ||
                number != std::floor(number)) {
                return {};
            }
            seam.vertices[k].push_back(static_cast<int>(number));
        }
    }
    return seam;
}

Error malformedUsd(const char* what) {
    return {ErrorCode::MalformedFile, {}, what};
}

}  // namespace

Result<MeshFile> readUsda(std::string_view bytes) {
    const Result<io::UsdStage> stage = io::parseUsd(bytes);
    if (!stage) {
        return stage.error();
    }
    if (stage->prims.size() != 1) {
        return malformedUsd("it is not one thing");
    }
    const UsdPrim& root = stage->prims.front();
    MeshFile made;
    const UsdPrim *garment = root.child("garment"), *pattern = root.child("pattern"),
                  *seams = root.child("seams");
    if (!garment || !pattern || !seams) {
        return malformedUsd("it lacks the garment, the pattern or the seams");
    }
    for (const auto& [prims, list] :
         {std::pair(garment, &made.meshes), std::pair(pattern, &made.flat)}) {
        for (const UsdPrim& prim : prims->children) {
            auto mesh = usdMesh(prim);
            if (!mesh) {
                return malformedUsd("a mesh cannot be read");
            }
            list->push_back(std::move(*mesh));
        }
    }
    MeshesByPrim byPrim;
    for (std::size_t k = 0; k < made.meshes.size(); ++k) {
        byPrim.emplace(garment->children[k].name, &made.meshes[k]);
    }
    for (const UsdPrim& prim : seams->children) {
        auto seam = usdSeam(prim, byPrim);
        if (!seam) {
            return malformedUsd("a seam cannot be read");
        }
        made.seams.push_back(std::move(*seam));
    }
    return made;
}

}  // namespace toile
