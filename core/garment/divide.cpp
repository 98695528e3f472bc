// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/divide.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/text.h"
#include "core/io/triangulate.h"

namespace toile {
namespace {

/// The file's own name for a face: its object, else its group, else nothing.
std::string nameInFile(const PolygonSoup& soup, int face) {
    if (!soup.faceObject.empty() && soup.faceObject[face] >= 0) {
        return soup.objects[soup.faceObject[face]];
    }
    if (!soup.faceGroup.empty() && soup.faceGroup[face] >= 0) {
        return soup.groups[soup.faceGroup[face]];
    }
    return "";
}

/// Makes names unique: a name that several pieces share gets " 2", " 3" from the second on.
class NameKeeper {
public:
    std::string unique(const std::string& wanted) {
        const std::string base = wanted.empty() ? "piece" : wanted;
        std::string name = base;
        int& next = nextNumber_.try_emplace(base, 2).first->second;
        while (!taken_.insert(name).second) {
            name = base + " " + std::to_string(next++);
        }
        return name;
    }

private:
    std::set<std::string> taken_;
    std::map<std::string, int> nextNumber_;  ///< thousands of pieces may share a name
};

/// The triangles of one component, and where they come from. Vertices are numbered in order of
/// their index in the file, so that the piece does not depend on the order of its faces' corners.
struct Component {
    MeshArrays mesh;
    std::vector<int> sourceVertex, sourceFace;
};

Component gather(const PolygonSoup& soup, const Triangulation& triangles,
                 const std::vector<int>& members, double millimetres) {
    Component part;
    std::vector<int>& vertices = part.sourceVertex;
    for (const int t : members) {
        for (int k = 0; k < 3; ++k) {
            vertices.push_back(triangles.F(t, k));
        }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    part.mesh.V.resize(static_cast<Eigen::Index>(vertices.size()), 3);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        part.mesh.V.row(static_cast<Eigen::Index>(v)) = millimetres * soup.positions[vertices[v]];
    }
    part.mesh.F.resize(static_cast<Eigen::Index>(members.size()), 3);
    part.sourceFace.reserve(members.size());
    for (std::size_t f = 0; f < members.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto at =
                std::lower_bound(vertices.begin(), vertices.end(), triangles.F(members[f], k));
            part.mesh.F(static_cast<Eigen::Index>(f), k) = static_cast<int>(at - vertices.begin());
        }
        part.sourceFace.push_back(triangles.sourceFace[members[f]]);
    }
    return part;
}

}  // namespace

std::vector<std::shared_ptr<const Piece>> divide(const SourceFile& file, int fileIndex,
                                                 const std::string& namePrefix,
                                                 Problems& problems) {
    const PolygonSoup& soup = file.soup;
    const Triangulation triangles = triangulate(soup, file.path.filename().string());
    problems.insert(problems.end(), triangles.problems.begin(), triangles.problems.end());
    const std::vector<int> component =
        faceComponents(triangles.F, static_cast<int>(soup.positions.size()));
    std::vector<std::vector<int>> members;
    for (std::size_t t = 0; t < component.size(); ++t) {
        if (component[t] == static_cast<int>(members.size())) {
            members.emplace_back();  // components are numbered by first face
        }
        members[component[t]].push_back(static_cast<int>(t));
    }

    NameKeeper names;
    std::vector<std::shared_ptr<const Piece>> pieces;
    for (const auto& faces : members) {
        Component part = gather(soup, triangles, faces, millimetresPer(file.unit));
        auto piece = std::make_shared<Piece>(
            makePiece(namePrefix + names.unique(nameInFile(soup, part.sourceFace.front())),
                      std::move(part.mesh)));
        piece->file = fileIndex;
        piece->sourceVertex = std::move(part.sourceVertex);
        piece->sourceFace = std::move(part.sourceFace);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace toile
