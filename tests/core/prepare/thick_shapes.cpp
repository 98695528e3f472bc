// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/prepare/thick_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/geometry/point_index.h"
#include "core/prepare/file_surface.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile::test {

namespace {

void addFace(PolygonSoup& soup, const std::vector<int>& corners) {
    soup.corners.insert(soup.corners.end(), corners.begin(), corners.end());
    soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
}

/// Sum of the areas around each position, as vectors.
std::vector<Eigen::Vector3d> normalsOf(const PolygonSoup& soup) {
    std::vector<Eigen::Vector3d> normals(soup.positions.size(), Eigen::Vector3d::Zero());
    for (int face = 0; face < soup.faceCount(); ++face) {
        const int first = soup.faceStart[face], count = soup.cornerCount(face);
        const auto at = [&](int k) { return soup.positions[soup.corners[first + k % count]]; };
        Eigen::Vector3d area = Eigen::Vector3d::Zero();
        for (int k = 1; k + 1 < count; ++k) {
            area += (at(k) - at(0)).cross(at(k + 1) - at(0));
        }
        for (int k = 0; k < count; ++k) {
            normals[soup.corners[first + k]] += area;
        }
    }
    return normals;
}

}  // namespace

PolygonSoup tubeSheet() {
    return asSoup(tube(48, 20));
}

PolygonSoup shirtSample() {
    Progress progress;
    return *readSoup(sourceFile("resources/samples/tshirt.obj"), progress);
}

PolygonSoup asSoup(const MeshArrays& mesh) {
    PolygonSoup soup;
    for (const auto& position : mesh.V.rowwise()) {
        soup.positions.emplace_back(position.transpose());
    }
    for (const auto& face : mesh.F.rowwise()) {
        addFace(soup, {face[0], face[1], face[2]});
    }
    return soup;
}

PolygonSoup withMap(PolygonSoup soup) {
    soup.uvs.clear();
    for (const Eigen::Vector3d& position : soup.positions) {
        soup.uvs.emplace_back(position.head<2>());
    }
    soup.cornerUvs = soup.corners;
    return soup;
}

PolygonSoup weldedSoup(PolygonSoup soup) {
    std::vector<Eigen::Vector3d> places;
    geometry::PointIndex index(places);
    std::vector<int> place;
    for (const Eigen::Vector3d& position : soup.positions) {
        place.push_back(index.insert(position).first);
    }
    for (int& corner : soup.corners) {
        corner = place[static_cast<std::size_t>(corner)];
    }
    soup.positions = std::move(places);
    soup.positionText.clear();
    return soup;
}

PolygonSoup withoutFaces(const PolygonSoup& soup, const std::vector<int>& gone) {
    std::vector<int> kept;
    for (int face = 0; face < soup.faceCount(); ++face) {
        if (std::find(gone.begin(), gone.end(), face) == gone.end()) {
            kept.push_back(face);
        }
    }
    return withFaces(soup, kept);
}

PolygonSoup looseSoup(const PolygonSoup& soup) {
    PolygonSoup loose = soup;
    loose.positions.clear();
    loose.positionText.clear();
    for (int& corner : loose.corners) {
        loose.positions.push_back(soup.positions[static_cast<std::size_t>(corner)]);
        corner = static_cast<int>(loose.positions.size()) - 1;
    }
    return loose;
}

PolygonSoup thickened(const PolygonSoup& sheet, const Thickening& how) {
    PolygonSoup soup = sheet;
    soup.positionText.clear();
    const int count = static_cast<int>(sheet.positions.size()), faces = sheet.faceCount();
    const std::vector<Eigen::Vector3d> normals = normalsOf(sheet);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const Eigen::Vector3d& position = sheet.positions[v];
        soup.positions.emplace_back(position - how.thickness(position) * normals[v].normalized());
    }
    std::set<std::pair<int, int>> sides;
    const auto eachSide = [&](const auto& visit) {
        for (int face = 0; face < faces; ++face) {
            const int first = sheet.faceStart[face], corners = sheet.cornerCount(face);
            for (int k = 0; k < corners; ++k) {
                visit(face, sheet.corners[first + k], sheet.corners[first + (k + 1) % corners]);
            }
        }
    };
    for (int face = 0; face < faces; ++face) {
        const int first = sheet.faceStart[face], corners = sheet.cornerCount(face);
        std::vector<int> copy;
        for (int k = 0; k < corners; ++k) {
            const int corner = first + (corners - k) % corners;
            copy.push_back(sheet.corners[corner] + count);
            if (!sheet.cornerUvs.empty()) {
                soup.cornerUvs.push_back(sheet.cornerUvs[corner]);
            }
        }
        addFace(soup, copy);
    }
    eachSide([&sides](int, int from, int to) { sides.insert({from, to}); });
    std::vector<int> rimOf;
    eachSide([&](int face, int from, int to) {
        if (how.rims && !sides.contains({to, from})) {
            addFace(soup, {to, from, from + count, to + count});
            soup.cornerUvs.insert(soup.cornerUvs.end(), sheet.cornerUvs.empty() ? 0 : 4, -1);
            rimOf.push_back(face);
        }
    });
    for (std::vector<int>* names : {&soup.faceObject, &soup.faceGroup, &soup.faceMaterial}) {
        if (!names->empty()) {
            names->insert(names->end(), names->begin(), names->begin() + faces);
            for (const int face : rimOf) {
                names->push_back((*names)[static_cast<std::size_t>(face)]);
            }
        }
    }
    return soup;
}

PolygonSoup withDivided(const PolygonSoup& soup, int firstFace, int lastFace) {
    PolygonSoup divided;
    divided.positions = soup.positions;
    std::map<std::pair<int, int>, int> middles;
    const auto cornersOf = [&soup](int face) {
        return std::vector<int>(soup.corners.begin() + soup.faceStart[face],
                                soup.corners.begin() + soup.faceStart[face + 1]);
    };
    const auto middleOf = [&](int a, int b) {
        const auto [entry, isNew] = middles.insert(
            {{std::min(a, b), std::max(a, b)}, static_cast<int>(divided.positions.size())});
        if (isNew) {
            divided.positions.emplace_back((soup.positions[a] + soup.positions[b]) / 2);
        }
        return entry->second;
    };
    for (int face = firstFace; face < lastFace; ++face) {
        const std::vector<int> c = cornersOf(face);
        middleOf(c[0], c[1]);
        middleOf(c[1], c[2]);
        middleOf(c[2], c[0]);
    }
    for (int face = 0; face < soup.faceCount(); ++face) {
        std::vector<int> corners;
        const std::vector<int> c = cornersOf(face);
        for (std::size_t k = 0; k < c.size(); ++k) {
            const int a = c[k], b = c[(k + 1) % c.size()];
            corners.push_back(a);
            if (const auto at = middles.find({std::min(a, b), std::max(a, b)});
                at != middles.end()) {
                corners.push_back(at->second);
            }
        }
        if (face < firstFace || face >= lastFace) {
            addFace(divided, corners);
            continue;
        }
        for (std::size_t k = 0; k < 6; k += 2) {
            addFace(divided, {corners[k], corners[k + 1], corners[(k + 5) % 6]});
        }
        addFace(divided, {corners[1], corners[3], corners[5]});
    }
    return divided;
}

PolygonSoup revolved(const std::vector<Eigen::Vector2d>& profile, int around) {
    PolygonSoup soup;
    for (const Eigen::Vector2d& point : profile) {
        for (int k = 0; k < around; ++k) {
            const double phi = 2 * std::numbers::pi * k / around;
            soup.positions.emplace_back(point.x() * std::cos(phi), point.x() * std::sin(phi),
                                        point.y());
        }
    }
    for (int r = 0; r + 1 < std::ssize(profile); ++r) {
        for (int k = 0; k < around; ++k) {
            const int a = r * around + k, b = r * around + (k + 1) % around;
            addFace(soup, {a, b, b + around, a + around});
        }
    }
    return soup;
}

PolygonSoup tubeInTube(double outerRadius, int outerAround, double innerRadius, int innerAround) {
    constexpr double kHeight = 400;
    PolygonSoup soup;
    const auto addTube = [&soup](double radius, int around, bool isOuter) {
        const int first = static_cast<int>(soup.positions.size());
        const int along = around / 3;
        for (int r = 0; r <= along; ++r) {
            for (int k = 0; k < around; ++k) {
                const double phi = 2 * std::numbers::pi * k / around;
                soup.positions.emplace_back(radius * std::cos(phi), radius * std::sin(phi),
                                            kHeight * r / along);
            }
        }
        for (int r = 0; r < along; ++r) {
            for (int k = 0; k < around; ++k) {
                const int a = first + r * around + k, b = first + r * around + (k + 1) % around;
                const int c = b + around, d = a + around;
                addFace(soup, isOuter ? std::vector{a, b, c} : std::vector{a, c, b});
                addFace(soup, isOuter ? std::vector{a, c, d} : std::vector{a, d, c});
            }
        }
        return std::pair(first, first + along * around);
    };
    const auto [outerLow, outerHigh] = addTube(outerRadius, outerAround, true);
    const auto [innerLow, innerHigh] = addTube(innerRadius, innerAround, false);
    // The two rims, advancing on whichever circle is behind.
    const auto addRim = [&](int outer, int inner, bool isHigh) {
        for (int i = 0, j = 0; i < outerAround || j < innerAround;) {
            const int a = outer + i % outerAround, b = inner + j % innerAround;
            const bool outerNext = (i + 1) * innerAround <= (j + 1) * outerAround;
            const int c = outerNext ? outer + (i + 1) % outerAround : inner + (j + 1) % innerAround;
            addFace(soup, isHigh ? std::vector{a, c, b} : std::vector{a, b, c});
            ++(outerNext ? i : j);
        }
    };
    addRim(outerLow, innerLow, false);
    addRim(outerHigh, innerHigh, true);
    return soup;
}

}  // namespace toile::test
