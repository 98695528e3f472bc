// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include <Eigen/Geometry>

#include "core/base/version.h"
#include "core/formats/json.h"
#include "core/formats/mesh/piece_meshes.h"

namespace toile {
namespace {

constexpr double kMetresPerMillimetre = 0.001;
constexpr int kFloat = 5126, kUnsigned = 5125;              // component types
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;  // targets
constexpr std::uint32_t kMagic = 0x46546C67, kVersion2 = 2, kJson = 0x4E4F534A, kBin = 0x004E4942;
constexpr std::size_t kAligned = 4;

void append32(std::string& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        out += static_cast<char>((value >> shift) & 0xFFU);
    }
}

void appendReal(std::string& out, double value) {
    append32(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

/// Vertex normals: the mean of the triangles' normals, weighted by area.
Points3 vertexNormals(const PieceMesh& mesh) {
    Points3 normals = Points3::Zero(mesh.V.rows(), 3);
    for (const auto& face : mesh.F.rowwise()) {
        const Eigen::RowVector3d a = mesh.V.row(face[0]), b = mesh.V.row(face[1]),
                                 c = mesh.V.row(face[2]);
        const Eigen::RowVector3d normal = (b - a).cross(c - a);
        for (const int vertex : face) {
            normals.row(vertex) += normal;
        }
    }
    for (auto row : normals.rowwise()) {
        const double length = row.norm();
        row = length > 0 ? Eigen::RowVector3d(row / length) : Eigen::RowVector3d(0, 0, 1);
    }
    return normals;
}

/// The binary part of the file, and its description in the JSON.
class Buffers {
public:
    Json views = Json::array(), accessors = Json::array();
    std::string bytes;

    /// @param rows  #n x k  @return index of the accessor
    template <class Matrix>
    int add(const Matrix& rows, const char* type, bool withBounds) {
        const std::size_t start = bytes.size();
        for (Eigen::Index i = 0; i < rows.rows(); ++i) {
            for (Eigen::Index k = 0; k < rows.cols(); ++k) {
                appendReal(bytes, rows(i, k));
            }
        }
        Json accessor{{"bufferView", view(start, kVertexBuffer)},
                      {"componentType", kFloat},
                      {"count", rows.rows()},
                      {"type", type}};
        if (withBounds) {
            for (const auto& [key, bound] :
                 {std::pair("min", Eigen::RowVectorXd(rows.colwise().minCoeff())),
                  std::pair("max", Eigen::RowVectorXd(rows.colwise().maxCoeff()))}) {
                Json values = Json::array();
                for (const double value : bound) {
                    values.push_back(static_cast<double>(static_cast<float>(value)));
                }
                accessor[key] = std::move(values);
            }
        }
        accessors.push_back(std::move(accessor));
        return static_cast<int>(accessors.size()) - 1;
    }

    int addIndices(const Triangles& F) {
        const std::size_t start = bytes.size();
        for (const auto& face : F.rowwise()) {
            for (const int vertex : face) {
                append32(bytes, static_cast<std::uint32_t>(vertex));
            }
        }
        accessors.push_back({{"bufferView", view(start, kIndexBuffer)},
                             {"componentType", kUnsigned},
                             {"count", F.size()},
                             {"type", "SCALAR"}});
        return static_cast<int>(accessors.size()) - 1;
    }

private:
    int view(std::size_t start, int target) {
        views.push_back({{"buffer", 0},
                         {"byteOffset", start},
                         {"byteLength", bytes.size() - start},
                         {"target", target}});
        return static_cast<int>(views.size()) - 1;
    }
};

Json glbSeams(const PieceMeshes& meshes) {
    Json seams = Json::array();
    for (const MeshSeam& seam : meshes.seams) {
        seams.push_back({{"name", text(seam.name)},
                         {"kind", text(seam.kind)},
                         {"meshes", seam.mesh},
                         {"left", seam.vertices[0]},
                         {"right", seam.vertices[1]}});
    }
    return seams;
}

void appendChunk(std::string& out, std::uint32_t kind, std::string data, char filler) {
    data.resize((data.size() + kAligned - 1) / kAligned * kAligned, filler);
    append32(out, static_cast<std::uint32_t>(data.size()));
    append32(out, kind);
    out += data;
}

}  // namespace

std::string writeGlb(const PieceMeshes& meshes, const std::string& title) {
    Buffers buffers;
    Json nodes = Json::array(), drawn = Json::array(), all = Json::array();
    for (const PieceMesh& mesh : meshes.meshes) {
        Json attributes{
            {"POSITION", buffers.add(Points3(kMetresPerMillimetre * mesh.V), "VEC3", true)},
            {"NORMAL", buffers.add(vertexNormals(mesh), "VEC3", false)}};
        if (mesh.uv.rows() > 0) {
            Points2 uv = kMetresPerMillimetre * mesh.uv;
            uv.col(1) = 1 - uv.col(1).array();
            attributes["TEXCOORD_0"] = buffers.add(uv, "VEC2", false);
        }
        Json primitive{{"attributes", std::move(attributes)},
                       {"indices", buffers.addIndices(mesh.F)},
                       {"material", 0}};
        all.push_back(nodes.size());
        nodes.push_back({{"name", text(mesh.name)}, {"mesh", drawn.size()}});
        drawn.push_back(
            {{"name", text(mesh.name)}, {"primitives", Json::array({std::move(primitive)})}});
    }
    Json scene{{"name", text(title)}, {"nodes", std::move(all)}};
    scene["extras"] = {{"toile_pattern_unit", "m"}, {"toile_seams", glbSeams(meshes)}};
    Json json{{"asset", {{"version", "2.0"}, {"generator", "Toile " + std::string(version())}}},
              {"scene", 0},
              {"scenes", Json::array({std::move(scene)})},
              {"nodes", std::move(nodes)},
              {"materials", Json::array({{{"name", "cloth"}, {"doubleSided", true}}})},
              {"meshes", std::move(drawn)},
              {"accessors", std::move(buffers.accessors)},
              {"bufferViews", std::move(buffers.views)},
              {"buffers", Json::array({{{"byteLength", buffers.bytes.size()}}})}};
    std::string chunks;
    appendChunk(chunks, kJson, json.dump(), ' ');
    appendChunk(chunks, kBin, std::move(buffers.bytes), '\0');
    std::string out;
    append32(out, kMagic);
    append32(out, kVersion2);
    constexpr std::size_t kHeadBytes = 12;
    append32(out, static_cast<std::uint32_t>(chunks.size() + kHeadBytes));
    return out + chunks;
}

}  // namespace toile
