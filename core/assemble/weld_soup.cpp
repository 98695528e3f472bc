// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/weld_soup.h"

#include <algorithm>
#include <numeric>

#include "core/mesh/weld.h"

namespace toile {

MergedVertices mergedVertices(const Points3& V, const std::vector<int>& sourceVertex,
                              geometry::DisjointSets& same) {
    MergedVertices merged{Points3(V.rows(), 3), std::vector<int>(V.rows()), {}};
    for (int v = 0; v < V.rows(); ++v) {
        const int ownSource = sourceVertex.empty() ? -1 : sourceVertex[v];
        const int root = same.root(v);  // the smallest: numbered already
        if (root == v) {
            merged.number[v] = static_cast<int>(merged.sourceVertex.size());
            merged.V.row(merged.number[v]) = V.row(v);
            merged.sourceVertex.push_back(ownSource);
        } else {
            merged.number[v] = merged.number[root];
            int& source = merged.sourceVertex[merged.number[v]];
            source = source < 0 ? ownSource : source;
        }
    }
    merged.V.conservativeResize(static_cast<Eigen::Index>(merged.sourceVertex.size()), 3);
    return merged;
}

namespace {

/// Groups of faces that may be joined: those of one object, and those without one.
std::vector<std::vector<int>> facesByObject(const PolygonSoup& soup) {
    const std::size_t objects = soup.faceObject.empty() ? 0 : soup.objects.size();
    std::vector<std::vector<int>> faces(objects + 1);
    for (int face = 0; face < soup.faceCount(); ++face) {
        const int object = objects > 0 ? soup.faceObject[face] : -1;
        faces[object < 0 ? objects : static_cast<std::size_t>(object)].push_back(face);
    }
    return faces;
}

/// These faces as fans, by positions of the soup: enough to distinguish border from inside.
Triangles fansOf(const PolygonSoup& soup, const std::vector<int>& faces) {
    Eigen::Index triangles = 0;
    for (const int face : faces) {
        triangles += soup.cornerCount(face) - 2;
    }
    Triangles fans(triangles, 3);
    Eigen::Index row = 0;
    for (const int face : faces) {
        const int* corners = soup.corners.data() + soup.faceStart[face];
        for (int k = 2; k < soup.cornerCount(face); ++k) {
            fans.row(row++) << corners[0], corners[k - 1], corners[k];
        }
    }
    return fans;
}

/// The same with vertices numbered from 0.
struct Patch {
    std::vector<int> vertices;  ///< position in the soup, ascending
    Points3 V;
    Triangles F;
};

/// @param local  as long as the soup's positions; scratch space
Patch patchOf(const PolygonSoup& soup, const std::vector<int>& faces, std::vector<int>& local) {
    Patch patch{{}, {}, fansOf(soup, faces)};
    patch.vertices.assign(patch.F.data(), patch.F.data() + patch.F.size());
    std::ranges::sort(patch.vertices);
    patch.vertices.erase(std::unique(patch.vertices.begin(), patch.vertices.end()),
                         patch.vertices.end());
    patch.V.resize(std::ssize(patch.vertices), 3);
    for (std::size_t v = 0; v < patch.vertices.size(); ++v) {
        patch.V.row(static_cast<Eigen::Index>(v)) = soup.positions[patch.vertices[v]];
        local[patch.vertices[v]] = static_cast<int>(v);
    }
    for (int& v : cornersOf(patch.F)) {
        v = local[v];
    }
    return patch;
}

/// Assigns corners their new vertex and removes those that repeat their predecessor.
void rename(PolygonSoup& soup, const std::vector<int>& renamed) {
    std::vector<int> corners, uvs, start{0};
    const bool hasUvs = !soup.cornerUvs.empty();
    for (int face = 0; face < soup.faceCount(); ++face) {
        const int first = soup.faceStart[face];
        const int count = soup.cornerCount(face);
        const auto vertex = [&](int k) { return renamed[first + k % count]; };
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

Problems weldSoup(std::shared_ptr<const PolygonSoup>& shared, std::optional<double> wanted,
                  double millimetres, const std::string& name) {
    const PolygonSoup& soup = *shared;
    if (soup.corners.empty()) {
        return {};
    }
    if (!wanted) {
        std::vector<int> all(static_cast<std::size_t>(soup.faceCount()));
        std::iota(all.begin(), all.end(), 0);
        const Eigen::Map<const Points3> V(soup.positions.front().data(), std::ssize(soup.positions),
                                          3);
        if (!looksUnwelded(fansOf(soup, all), V)) {
            return {};
        }
    }
    std::vector<int> local(soup.positions.size(), -1);
    std::vector<int> renamed = soup.corners;
    long long merged = 0;
    Error note;
    for (const std::vector<int>& faces : facesByObject(soup)) {
        const Patch patch = patchOf(soup, faces, local);
        const double within = !wanted       ? 0
                              : *wanted > 0 ? *wanted / millimetres
                                            : weldTolerance(patch.F, patch.V);
        const Weld weld = findWeld(patch.F, patch.V, {within, true});
        for (const int face : faces) {
            for (int c = soup.faceStart[face]; c < soup.faceStart[face + 1]; ++c) {
                renamed[c] = patch.vertices[weld.target[local[soup.corners[c]]]];
            }
        }
        if (weld.merged > 0 && merged == 0) {
            note = weldNote(weld, millimetres * patch.V, name);
        }
        merged += weld.merged;
    }
    if (merged == 0) {
        return {};
    }
    auto welded = std::make_shared<PolygonSoup>(soup);
    rename(*welded, renamed);
    shared = std::move(welded);
    // The note of the first object with one, with the count of all.
    std::vector<Wording> words = note.detail.arguments();
    words.front() = countWording(merged, "vertex");
    note.detail = worded(note.detail.pattern(), std::move(words));
    return {note};
}

}  // namespace toile
