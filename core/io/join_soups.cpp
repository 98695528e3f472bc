// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/join_soups.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/io/soup_builder.h"

namespace toile::io {
namespace {

template <class Value>
void append(std::vector<Value>& all, const std::vector<Value>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// @param facesBefore  those without a name
void appendNames(std::vector<std::string>& names, std::vector<int>& ofFace,
                 const std::vector<std::string>& more, const std::vector<int>& ofMore,
                 int facesBefore) {
    if (ofMore.empty()) {
        return;
    }
    std::vector<int> index{};
    for (const std::string& name : more) {
        const auto known = std::ranges::find(names, name);
        index.push_back(static_cast<int>(known - names.begin()));
        if (known == names.end()) {
            names.push_back(name);
        }
    }
    ofFace.resize(static_cast<std::size_t>(facesBefore), -1);
    for (const int name : ofMore) {
        ofFace.push_back(name < 0 ? -1 : index[static_cast<std::size_t>(name)]);
    }
}

void padTo(std::size_t count, std::vector<int>& list) {
    if (!list.empty()) {
        list.resize(count, -1);
    }
}

/// Objects by names that no file before has.
void nameObjects(PolygonSoup& soup, const std::string& file, const PolygonSoup& before) {
    if (soup.objects.empty()) {
        soup.objects = {file};
        soup.faceObject.assign(static_cast<std::size_t>(soup.faceCount()), 0);
    }
    for (std::string& name : soup.objects) {
        if (std::ranges::find(before.objects, name) != before.objects.end()) {
            name = file + " " + name;
        }
    }
}

}  // namespace

PolygonSoup joinedSoups(std::vector<NamedSoup> files) {
    PolygonSoup all;
    all.statedUnit = files.front().soup.statedUnit;
    all.statedUp = files.front().soup.statedUp;
    for (auto& [name, soup] : files) {
        nameObjects(soup, name, all);
        const auto positions = static_cast<int>(all.positions.size());
        const auto uvs = static_cast<int>(all.uvs.size());
        const auto corners = static_cast<int>(all.corners.size());
        const int faces = all.faceCount();
        append(all.positions, soup.positions);
        append(all.uvs, soup.uvs);
        for (const int corner : soup.corners) {
            all.corners.push_back(positions + corner);
        }
        if (!soup.cornerUvs.empty()) {
            all.cornerUvs.resize(static_cast<std::size_t>(corners), kNoUv);
        }
        for (const int uv : soup.cornerUvs) {
            all.cornerUvs.push_back(uv < 0 ? kNoUv : uvs + uv);
        }
        for (int face = 1; face <= soup.faceCount(); ++face) {
            all.faceStart.push_back(corners + soup.faceStart[static_cast<std::size_t>(face)]);
        }
        appendNames(all.objects, all.faceObject, soup.objects, soup.faceObject, faces);
        appendNames(all.groups, all.faceGroup, soup.groups, soup.faceGroup, faces);
        appendNames(all.materials, all.faceMaterial, soup.materials, soup.faceMaterial, faces);
        append(all.problems, soup.problems);
    }
    padTo(all.corners.size(), all.cornerUvs);
    for (auto* ofFace : {&all.faceObject, &all.faceGroup, &all.faceMaterial}) {
        padTo(static_cast<std::size_t>(all.faceCount()), *ofFace);
    }
    return all;
}

}  // namespace toile::io
