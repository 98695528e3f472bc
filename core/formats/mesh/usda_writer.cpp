// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/formats/mesh/piece_meshes.h"

namespace toile {
namespace {

constexpr int kUsdDecimals = 4, kUvDecimals = 7;
constexpr double kMetrePerMillimetre = 0.001;

/// A valid USD name: letters, digits and '_', no digit first.
std::string primName(const std::string& slug) {
    std::string name = slug;
    std::ranges::replace(name, '-', '_');
    return std::isdigit(static_cast<unsigned char>(name.front())) != 0 ? '_' + name : name;
}

std::string usdText(std::string_view words) {
    std::string out = "\"";
    for (const char c : cleanText(words)) {
        out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    }
    return out + '"';
}

/// "[(0, 1), (2, 3)]".
template <class Matrix>
void appendTuples(std::string& out, const Matrix& rows, int decimals) {
    out += '[';
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        out += i == 0 ? "(" : ", (";
        for (Eigen::Index k = 0; k < rows.cols(); ++k) {
            out += k == 0 ? "" : ", ";
            appendFixed(out, rows(i, k), decimals);
        }
        out += ')';
    }
    out += ']';
}

void appendInts(std::string& out, const auto& values) {
    out += '[';
    bool isFirst = true;
    for (const int value : values) {
        out += isFirst ? "" : ", ";
        out += std::to_string(value);
        isFirst = false;
    }
    out += ']';
}

/// @param points  3D, mm
void appendMesh(std::string& out, const PieceMesh& mesh, const Points3& points) {
    out += "        def Mesh \"" + primName(mesh.slug) + "\"\n        {\n";
    out += "            uniform bool doubleSided = 1\n";
    out += "            uniform token subdivisionScheme = \"none\"\n";
    out += "            custom string toile:name = " + usdText(mesh.name) + "\n";
    out += "            int[] faceVertexCounts = ";
    appendInts(out, std::vector<int>(static_cast<std::size_t>(mesh.F.rows()), 3));
    out += "\n            int[] faceVertexIndices = ";
    std::vector<int> corners;
    for (const auto& face : mesh.F.rowwise()) {
        corners.insert(corners.end(), {face[0], face[1], face[2]});
    }
    appendInts(out, corners);
    out += "\n            point3f[] points = ";
    appendTuples(out, points, kUsdDecimals);
    if (mesh.uv.rows() > 0) {
        out += "\n            texCoord2f[] primvars:st = ";
        appendTuples(out, Points2(kMetrePerMillimetre * mesh.uv), kUvDecimals);
        out += " (\n                interpolation = \"vertex\"\n            )";
    }
    out += "\n        }\n";
}

Points3 flatPoints(const PieceMesh& mesh) {
    Points3 points = Points3::Zero(mesh.uv.rows(), 3);
    points.leftCols<2>() = mesh.uv;
    return points;
}

void appendSeam(std::string& out, const PieceMeshes& meshes, const MeshSeam& seam,
                std::size_t number) {
    out += "        def Scope \"seam_" + std::to_string(number) + "\"\n        {\n";
    out += "            custom string toile:name = " + usdText(seam.name) + "\n";
    out += "            custom string toile:kind = " + usdText(seam.kind) + "\n";
    constexpr const char* kSides[] = {"left", "right"};
    for (std::size_t k = 0; k < 2; ++k) {
        const PieceMesh& mesh = meshes.meshes[static_cast<std::size_t>(seam.mesh[k])];
        const std::string side = std::string("toile:") + kSides[k];
        out.append("            custom rel ").append(side).append(" = </Toile/garment/");
        out.append(primName(mesh.slug)).append(">\n            custom int[] ");
        out.append(side).append("Vertices = ");
        appendInts(out, seam.vertices[k]);
        out += '\n';
    }
    out += "        }\n";
}

}  // namespace

std::string writeUsda(const PieceMeshes& meshes, const std::string& title) {
    std::string out = "#usda 1.0\n(\n    defaultPrim = \"Toile\"\n    doc = " +
                      usdText(title + ", made by Toile " + std::string(version())) +
                      "\n    metersPerUnit = 0.001\n    upAxis = \"Y\"\n)\n\n"
                      "def Xform \"Toile\"\n{\n";
    out += "    def Xform \"garment\"\n    {\n";
    for (const PieceMesh& mesh : meshes.meshes) {
        appendMesh(out, mesh, mesh.V);
    }
    out += "    }\n\n    def Xform \"pattern\"\n    {\n";
    for (const PieceMesh& mesh : meshes.meshes) {
        if (mesh.uv.rows() > 0) {
            appendMesh(out, mesh, flatPoints(mesh));
        }
    }
    out += "    }\n\n    def Scope \"seams\"\n    {\n";
    for (std::size_t k = 0; k < meshes.seams.size(); ++k) {
        appendSeam(out, meshes, meshes.seams[k], k + 1);
    }
    return out + "    }\n}\n";
}

}  // namespace toile
