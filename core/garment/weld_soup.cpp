// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/weld_soup.h"

#include <numeric>

#include "core/mesh/weld.h"

namespace toile {
namespace {

/// Fans of the faces of one object, or of all (-1): good enough to tell border from inside.
Triangles fans(const PolygonSoup& soup, int object) {
    Triangles F(static_cast<Eigen::Index>(soup.corners.size()), 3);
    Eigen::Index row = 0;
    for (int face = 0; face < soup.faceCount(); ++face) {
        if (object >= 0 && soup.faceObject[face] != object) {
            continue;
        }
        const int* corners = soup.corners.data() + soup.faceStart[face];
        for (int k = 2; k < soup.cornerCount(face); ++k) {
            F.row(row++) << corners[0], corners[k - 1], corners[k];
        }
    }
    F.conservativeResize(row, 3);
    return F;
}

/// Gives corners their new vertex and takes out those that repeat the one before.
void rename(PolygonSoup& soup, const std::vector<int>& target) {
    std::vector<int> corners, uvs, start{0};
    const bool hasUvs = !soup.cornerUvs.empty();
    for (int face = 0; face < soup.faceCount(); ++face) {
        const int first = soup.faceStart[face];
        const int count = soup.cornerCount(face);
        const auto vertex = [&](int k) { return target[soup.corners[first + k % count]]; };
        int different = 0;
        for (int k = 0; k < count; ++k) {
            different += vertex(k) != vertex(k + 1) ? 1 : 0;
        }
        for (int k = 0; k < count; ++k) {
            if (different < 3 || vertex(k) != vertex(k + 1)) {
                corners.push_back(vertex(k));
                if (hasUvs) {
                    uvs.push_back(soup.cornerUvs[first + k]);
                }
            }
        }
        start.push_back(static_cast<int>(corners.size()));
    }
    soup.corners = std::move(corners);
    soup.cornerUvs = std::move(uvs);
    soup.faceStart = std::move(start);
}

}  // namespace

Problems weldSoup(PolygonSoup& soup, bool wanted, double millimetres, const std::string& name) {
    if (soup.positions.empty()) {
        return {};
    }
    const Eigen::Map<const Points3> V(soup.positions.front().data(),
                                      static_cast<Eigen::Index>(soup.positions.size()), 3);
    if (!wanted && !looksUnwelded(fans(soup, -1), V)) {
        return {};
    }
    Weld all;
    all.target.resize(soup.positions.size());
    std::iota(all.target.begin(), all.target.end(), 0);
    const int objects = soup.faceObject.empty() ? 0 : static_cast<int>(soup.objects.size());
    for (int object = objects > 0 ? 0 : -1; object < objects; ++object) {
        const Triangles F = fans(soup, object);
        const Weld weld = findWeld(F, V, {wanted ? weldTolerance(F, V) : 0.0, true});
        for (Eigen::Index corner = 0; corner < F.size(); ++corner) {
            const int v = F.data()[corner];
            all.target[v] = weld.target[v];
        }
    }
    for (std::size_t v = 0; v < all.target.size(); ++v) {
        all.merged += all.target[v] != static_cast<int>(v) ? 1 : 0;
    }
    if (all.merged == 0) {
        return {};
    }
    rename(soup, all.target);
    return {weldNote(all, millimetres * V, name)};
}

}  // namespace toile
