// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/complete_half.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mesh/edge_table.h"
#include "core/mesh/repair.h"
#include "core/prepare/file_surface.h"

namespace toile {
namespace {

/// Per position: whether it, or another one at the same place, is on the border.
std::vector<char> onBorder(const MeshArrays& mesh) {
    const Triangles F = weldedFaces(mesh);
    const EdgeTable table = buildEdgeTable(F, static_cast<int>(mesh.V.rows()));
    std::vector<char> border(static_cast<std::size_t>(mesh.V.rows()), 0);
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            border[table.edges(e, 0)] = border[table.edges(e, 1)] = 1;
        }
    }
    for (Eigen::Index i = 0; i < F.size(); ++i) {
        border[mesh.F.data()[i]] = border[F.data()[i]];
    }
    return border;
}

/// Adds the mirror image of a UV map, to its right. @return the offset to add to an index
int mirrorMap(std::vector<Eigen::Vector2d>& uvs) {
    constexpr double kGap = 0.05;  // of the map's width
    const auto count = static_cast<int>(uvs.size());
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Eigen::Vector2d& uv : uvs) {
        if (uv.allFinite()) {
            least = std::min(least, uv.x());
            most = std::max(most, uv.x());
        }
    }
    if (least > most) {
        least = most = 0;  // no finite values
    }
    const double sum = 2 * most + kGap * (most - least);
    for (int k = 0; k < count; ++k) {
        uvs.emplace_back(sum - uvs[k].x(), uvs[k].y());
    }
    return count;
}

/// The name of the mirror image: "sleeve_left" of "sleeve_right".
std::string mirroredName(const std::string& name) {
    constexpr std::pair<std::string_view, std::string_view> kSides[] = {
        {"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}};
    for (const auto& [left, right] : kSides) {
        for (const auto& [one, other] : {std::pair(left, right), std::pair(right, left)}) {
            const std::size_t at = name.find(one);
            const auto isLetter = [&name](std::size_t k) {
                return k < name.size() && std::islower(static_cast<unsigned char>(name[k])) != 0;
            };
            // A whole word, as in "sleeveLeft"; not "bright" or "Leftover".
            const bool isWithin = at != std::string::npos &&
                                  ((isLetter(at) && isLetter(at - 1)) || isLetter(at + one.size()));
            if (at != std::string::npos && !isWithin) {
                return std::string(name).replace(at, one.size(), other);
            }
        }
    }
    return name;
}

/// Adds the names of the images, face by face.
void nameImages(std::vector<int>& perFace, std::vector<std::string>& names) {
    std::vector<int> image(names.size());
    for (std::size_t k = 0; k < image.size(); ++k) {
        std::string name = mirroredName(names[k]);
        const auto found = std::ranges::find(names, name);
        image[k] = static_cast<int>(found - names.begin());
        if (found == names.end()) {
            names.push_back(std::move(name));
        }
    }
    const std::size_t count = perFace.size();
    for (std::size_t face = 0; face < count; ++face) {
        perFace.push_back(perFace[face] < 0 ? -1 : image[perFace[face]]);
    }
}

}  // namespace

std::optional<CompletedHalf> completeHalf(const PolygonSoup& half,
                                          const Eigen::Hyperplane<double, 3>& plane,
                                          double tolerance, double millimetres) {
    const FileSurface surface = surfaceOf(half, millimetres);
    const std::vector<char> border = onBorder(surface.mesh);
    const std::vector<char> used = usedVertices(surface.mesh.F, surface.mesh.V.rows());
    CompletedHalf whole{half, 0};
    PolygonSoup& soup = whole.soup;
    double least = 0, most = 0;
    std::vector<int> image(half.positions.size());  // same index on the plane
    for (std::size_t v = 0; v < half.positions.size(); ++v) {
        image[v] = static_cast<int>(soup.positions.size());
        if (!half.positions[v].allFinite()) {
            soup.positions.push_back(half.positions[v]);
            continue;
        }
        const Eigen::Vector3d here = millimetres * half.positions[v];
        const double distance = plane.signedDistance(here);
        const Eigen::Vector3d foot = plane.projection(here) / millimetres;
        if (used[v] != 0) {
            least = std::min(least, distance);
            most = std::max(most, distance);
        }
        if (border[v] != 0 && used[v] != 0 && std::abs(distance) <= tolerance) {
            image[v] = static_cast<int>(v);
            whole.joined += 1;
            if (foot != half.positions[v] && !soup.positionText.empty()) {
                soup.positionText[v] = {};  // it has moved
            }
            soup.positions[v] = foot;
        } else {
            soup.positions.push_back(2 * foot - half.positions[v]);
        }
    }
    if (whole.joined == 0 || std::min(-least, most) > tolerance) {
        return std::nullopt;
    }
    if (!soup.positionText.empty()) {
        soup.positionText.resize(soup.positions.size());
    }
    const int toImage = half.uvs.empty() ? 0 : mirrorMap(soup.uvs);
    for (int face = 0; face < half.faceCount(); ++face) {
        for (int corner = half.faceStart[face + 1] - 1; corner >= half.faceStart[face]; --corner) {
            soup.corners.push_back(image[half.corners[corner]]);
            if (!half.cornerUvs.empty()) {
                const int uv = half.cornerUvs[corner];
                soup.cornerUvs.push_back(uv < 0 ? uv : uv + toImage);
            }
        }
        soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
    }
    nameImages(soup.faceObject, soup.objects);
    nameImages(soup.faceGroup, soup.groups);
    nameImages(soup.faceMaterial, soup.materials);
    return whole;
}

}  // namespace toile
