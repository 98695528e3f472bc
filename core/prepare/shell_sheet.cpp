// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>

#include "core/mesh/weld.h"
#include "core/prepare/shell.h"

namespace toile {
namespace {

/// The role of a face of the file, by most of its area, and its winding.
struct FaceSide {
    int face;
    ShellSide side;
    bool isTurned;
};

std::vector<FaceSide> faceSides(const FileSurface& surface, const Shell& shell) {
    std::vector<FaceSide> sides;
    const std::size_t count = surface.face.size();
    for (std::size_t first = 0; first < count;) {
        std::array<double, 4> areas{};
        double turned = 0;
        std::size_t t = first;
        for (; t < count && surface.face[t] == surface.face[first]; ++t) {
            const double area = doubleAreaNormal(surface.mesh, static_cast<Eigen::Index>(t)).norm();
            areas[static_cast<std::size_t>(shell.side[t])] += area;
            turned += shell.turned[t] != 0 ? area : -area;
        }
        const auto most = std::max_element(areas.begin(), areas.end()) - areas.begin();
        sides.push_back({surface.face[first], static_cast<ShellSide>(most), turned > 0});
        first = t;
    }
    return sides;
}

ShellSide sideOf(ShellSurface which) {
    return which == ShellSurface::Inner ? ShellSide::Inner : ShellSide::Outer;
}

/// Millimetres per unit of the soup.
double millimetresOf(const PolygonSoup& soup, const FileSurface& surface) {
    double inFile = 0, inMillimetres = 0;
    for (std::size_t v = 0; v < soup.positions.size(); ++v) {
        if (soup.positions[v].allFinite()) {
            inFile += soup.positions[v].lpNorm<1>();
            inMillimetres += surface.mesh.V.row(static_cast<Eigen::Index>(v)).lpNorm<1>();
        }
    }
    return inFile > 0 ? inMillimetres / inFile : 1;
}

/// The vector of each vertex of the outer surface to the middle, mm; equal for coinciding ones.
Points3 waysToMiddle(const FileSurface& surface, const Shell& shell) {
    const MeshArrays& mesh = surface.mesh;
    Points3 way = Points3::Zero(mesh.V.rows(), 3);
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(mesh.V.rows());
    const std::vector<int> target =
        findWeld(mesh.F, mesh.V, {.tolerance = 0, .borderOnly = false}).target;
    for (Eigen::Index t = 0; t < mesh.F.rows(); ++t) {
        const auto at = static_cast<std::size_t>(t);
        if (shell.side[at] != ShellSide::Outer) {
            continue;
        }
        const Eigen::RowVector3d normal = doubleAreaNormal(mesh, t).transpose();
        const double area = normal.norm();
        const double thickness = shell.thickness[at] > 0 ? shell.thickness[at] : shell.median;
        for (const int v : mesh.F.row(t)) {
            const int partner = shell.partner[v];
            if (partner >= 0) {
                way.row(target[v]) += area / 2 * (mesh.V.row(partner) - mesh.V.row(v));
            } else {
                way.row(target[v]) += (shell.turned[at] != 0 ? 0.5 : -0.5) * thickness * normal;
            }
            weight[target[v]] += area;
        }
    }
    for (Eigen::Index v = 0; v < way.rows(); ++v) {
        way.row(v) /= weight[v] > 0 ? weight[v] : 1;
    }
    for (Eigen::Index v = 0; v < way.rows(); ++v) {
        way.row(v) = Eigen::RowVector3d(way.row(target[static_cast<std::size_t>(v)]));
    }
    return way;
}

void moveToMiddle(PolygonSoup& sheet, const FileSurface& surface, const Shell& shell) {
    const double millimetres = millimetresOf(sheet, surface);
    const Points3 way = waysToMiddle(surface, shell);
    for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
        const Eigen::Vector3d step = way.row(static_cast<Eigen::Index>(v)).transpose();
        if (!step.isZero(0)) {
            sheet.positions[v] += step / millimetres;
            if (!sheet.positionText.empty()) {
                sheet.positionText[v] = {};  // not the file's digits any more
            }
        }
    }
}

/// Reverses a face, keeping its first corner.
void turn(PolygonSoup& soup, int face) {
    const auto reverse = [&soup, face](std::vector<int>& perCorner) {
        if (!perCorner.empty()) {
            std::reverse(perCorner.begin() + soup.faceStart[face] + 1,
                         perCorner.begin() + soup.faceStart[face + 1]);
        }
    };
    reverse(soup.corners);
    reverse(soup.cornerUvs);
}

}  // namespace

PolygonSoup sheetOf(const PolygonSoup& soup, const FileSurface& surface, const Shell& shell,
                    ShellSurface which) {
    std::vector<int> kept;
    std::vector<char> isTurned;
    for (const FaceSide& face : faceSides(surface, shell)) {
        if (face.side == sideOf(which) || face.side == ShellSide::Single) {
            kept.push_back(face.face);
            isTurned.push_back(face.isTurned ? 1 : 0);
        }
    }
    PolygonSoup sheet = withFaces(soup, kept);
    for (int face = 0; face < sheet.faceCount(); ++face) {
        if (isTurned[static_cast<std::size_t>(face)] != 0) {
            turn(sheet, face);
        }
    }
    if (which == ShellSurface::Middle) {
        moveToMiddle(sheet, surface, shell);
    }
    return sheet;
}

LeftOut leftOut(const FileSurface& surface, const Shell& shell, ShellSurface which) {
    LeftOut left;
    for (const FaceSide& face : faceSides(surface, shell)) {
        if (face.side == ShellSide::Rim) {
            left.rims.push_back(face.face);
        } else if (face.side != sideOf(which) && face.side != ShellSide::Single) {
            left.other.push_back(face.face);
        }
    }
    return left;
}

}  // namespace toile
