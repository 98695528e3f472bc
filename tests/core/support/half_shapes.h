// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/io/soup.h"

namespace toile::test {

/// What of a file lies on the plane's positive side: faces across it are cut along it, names and
/// UV map go along. @param plane  in the file's axes and unit
inline PolygonSoup halfOf(const PolygonSoup& whole, const Eigen::Hyperplane<double, 3>& plane) {
    constexpr double kOnPlane = 1e-9;
    PolygonSoup half;
    half.positions = whole.positions;
    half.uvs = whole.uvs;
    half.objects = whole.objects;
    half.groups = whole.groups;
    half.materials = whole.materials;
    const auto sideOf = [&](int v) {
        const double distance = plane.signedDistance(whole.positions[static_cast<std::size_t>(v)]);
        return std::abs(distance) < kOnPlane ? 0.0 : distance;
    };
    std::map<std::pair<int, int>, int> crossing, uvCrossing;
    const auto between = [](auto& known, auto& list, int a, int b, double share) {
        const bool turned = a > b;
        const auto [at, isNew] =
            known.try_emplace(std::minmax(a, b), static_cast<int>(list.size()));
        if (isNew) {
            const auto p = list[static_cast<std::size_t>(turned ? b : a)];
            const auto q = list[static_cast<std::size_t>(turned ? a : b)];
            list.push_back(p + (turned ? 1 - share : share) * (q - p));
        }
        return at->second;
    };
    for (int face = 0; face < whole.faceCount(); ++face) {
        std::vector<int> corners, uvs;
        const int from = whole.faceStart[static_cast<std::size_t>(face)],
                  n = whole.cornerCount(face);
        bool isInside = false;
        for (int k = 0; k < n; ++k) {
            const auto c = static_cast<std::size_t>(from + k);
            const auto d = static_cast<std::size_t>(from + (k + 1) % n);
            const int a = whole.corners[c], b = whole.corners[d];
            const double here = sideOf(a), there = sideOf(b);
            isInside |= here > 0;
            if (here >= 0) {
                corners.push_back(a);
                uvs.push_back(whole.cornerUvs.empty() ? -1 : whole.cornerUvs[c]);
            }
            if (here * there < 0) {
                const double share = here / (here - there);
                corners.push_back(between(crossing, half.positions, a, b, share));
                uvs.push_back(whole.cornerUvs.empty()
                                  ? -1
                                  : between(uvCrossing, half.uvs, whole.cornerUvs[c],
                                            whole.cornerUvs[d], share));
            }
        }
        if (!isInside || corners.size() < 3) {
            continue;
        }
        half.corners.insert(half.corners.end(), corners.begin(), corners.end());
        if (!whole.cornerUvs.empty()) {
            half.cornerUvs.insert(half.cornerUvs.end(), uvs.begin(), uvs.end());
        }
        half.faceStart.push_back(static_cast<int>(half.corners.size()));
        const auto keep = [face](std::vector<int>& list, const std::vector<int>& before) {
            if (!before.empty()) {
                list.push_back(before[static_cast<std::size_t>(face)]);
            }
        };
        keep(half.faceObject, whole.faceObject);
        keep(half.faceGroup, whole.faceGroup);
        keep(half.faceMaterial, whole.faceMaterial);
    }
    return half;
}

/// The soup as the text of an .obj file, with the names of its objects.
inline std::string objOf(const PolygonSoup& soup) {
    std::string text;
    const auto number = [](double value) {
        char digits[32];
        std::snprintf(digits, sizeof digits, " %.12g", value);
        return std::string(digits);
    };
    for (const Eigen::Vector3d& p : soup.positions) {
        text += "v" + number(p.x()) + number(p.y()) + number(p.z()) + "\n";
    }
    for (const Eigen::Vector2d& uv : soup.uvs) {
        text += "vt" + number(uv.x()) + number(uv.y()) + "\n";
    }
    int object = -1;
    for (int face = 0; face < soup.faceCount(); ++face) {
        const auto f = static_cast<std::size_t>(face);
        if (!soup.faceObject.empty() &&
            soup.faceObject[f] != std::exchange(object, soup.faceObject[f])) {
            text += "o " + soup.objects[static_cast<std::size_t>(object)] + "\n";
        }
        text += "f";
        for (auto c = static_cast<std::size_t>(soup.faceStart[f]);
             c < static_cast<std::size_t>(soup.faceStart[f + 1]); ++c) {
            text += " " + std::to_string(soup.corners[c] + 1);
            if (!soup.cornerUvs.empty()) {
                text += "/" + std::to_string(soup.cornerUvs[c] + 1);
            }
        }
        text += "\n";
    }
    return text;
}

}  // namespace toile::test
