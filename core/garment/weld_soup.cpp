// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/weld_soup.h"

#include <algorithm>
#include <numeric>

#include "core/mesh/weld.h"

namespace toile {
namespace {

/// Faces that may be joined with each other: those of one object, and those of none.
std::vector<std::vector<int>> facesByObject(const PolygonSoup& soup) {
    const std::size_t objects = soup.faceObject.empty() ? 0 : soup.objects.size();
    std::vector<std::vector<int>> faces(objects + 1);
    for (int face = 0; face < soup.faceCount(); ++face) {
        const int object = objects > 0 ? soup.faceObject[face] : -1;
        faces[object < 0 ? objects : static_cast<std::size_t>(object)].push_back(face);
    }
    return faces;
}

/// The faces with vertices numbered among themselves, as fans: good enough to tell border from
/// inside.
struct Patch {
    std::vector<int> vertices;  ///< position in the soup, ascending
    Points3 V;
    Triangles F;
};

/// @param local  as long as the soup's positions; holds nothing before and after
Patch patchOf(const PolygonSoup& soup, const std::vector<int>& faces, std::vector<int>& local) {
    Patch patch;
    Eigen::Index triangles = 0;
    for (const int face : faces) {
        const auto first = soup.corners.begin() + soup.faceStart[face];
        patch.vertices.insert(patch.vertices.end(), first, first + soup.cornerCount(face));
        triangles += soup.cornerCount(face) - 2;
    }
    std::sort(patch.vertices.begin(), patch.vertices.end());
    patch.vertices.erase(std::unique(patch.vertices.begin(), patch.vertices.end()),
                         patch.vertices.end());
    patch.V.resize(static_cast<Eigen::Index>(patch.vertices.size()), 3);
    for (std::size_t v = 0; v < patch.vertices.size(); ++v) {
        patch.V.row(static_cast<Eigen::Index>(v)) = soup.positions[patch.vertices[v]];
        local[patch.vertices[v]] = static_cast<int>(v);
    }
    patch.F.resize(triangles, 3);
    Eigen::Index row = 0;
    for (const int face : faces) {
        const int* corners = soup.corners.data() + soup.faceStart[face];
        for (int k = 2; k < soup.cornerCount(face); ++k) {
            patch.F.row(row++) << local[corners[0]], local[corners[k - 1]], local[corners[k]];
        }
    }
    return patch;
}

/// By how many triangles each position is used, were every face a fan.
std::vector<int> usesInFans(const PolygonSoup& soup) {
    std::vector<int> uses(soup.positions.size(), 0);
    for (int face = 0; face < soup.faceCount(); ++face) {
        const int* corners = soup.corners.data() + soup.faceStart[face];
        const int count = soup.cornerCount(face);
        uses[corners[0]] += count - 2;
        ++uses[corners[1]];
        for (int k = 2; k < count - 1; ++k) {
            uses[corners[k]] += 2;
        }
        ++uses[corners[count - 1]];
    }
    return uses;
}

/// Gives corners their new vertex and takes out those that repeat the one before.
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

Problems weldSoup(std::shared_ptr<const PolygonSoup>& shared, bool wanted, double millimetres,
                  const std::string& name) {
    const PolygonSoup& soup = *shared;
    // Most files are told apart from loose triangles by a count, before anything is built.
    if (soup.corners.empty() || (!wanted && !isMostlyLoose(usesInFans(soup)))) {
        return {};
    }
    std::vector<int> local(soup.positions.size(), -1);
    if (!wanted) {
        std::vector<int> all(static_cast<std::size_t>(soup.faceCount()));
        std::iota(all.begin(), all.end(), 0);
        const Patch whole = patchOf(soup, all, local);
        if (!looksUnwelded(whole.F, whole.V)) {
            return {};
        }
    }
    std::vector<int> renamed = soup.corners;
    long long merged = 0;
    Error note;
    for (const std::vector<int>& faces : facesByObject(soup)) {
        const Patch patch = patchOf(soup, faces, local);
        const Weld weld =
            findWeld(patch.F, patch.V, {wanted ? weldTolerance(patch.F, patch.V) : 0.0, true});
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
    // The note of the first object that has any, with the count of all.
    std::vector<Wording> words = note.detail.arguments();
    words.front() = countWording(merged, "vertex");
    note.detail = worded(note.detail.pattern(), std::move(words));
    return {note};
}

}  // namespace toile
