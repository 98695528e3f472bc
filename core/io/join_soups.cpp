// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/join_soups.h"

#include <map>
#include <utility>

#include "core/base/unique_names.h"
#include "core/io/soup_builder.h"

namespace toile::io {
namespace {

template <class Value>
void append(std::vector<Value>& all, const std::vector<Value>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// Names of one kind of all files, and the name of each face; equal names are merged.
class JoinedNames {
public:
    JoinedNames(std::vector<std::string>& names, std::vector<int>& ofFace)
        : names_(names), ofFace_(ofFace) {}

    /// @param facesBefore  number of faces without a name
    void append(const std::vector<std::string>& more, const std::vector<int>& ofMore,
                int facesBefore) {
        if (ofMore.empty()) {
            return;
        }
        std::vector<int> index{};
        for (const std::string& name : more) {
            const auto [known, isNew] = indexOf_.try_emplace(name, static_cast<int>(names_.size()));
            index.push_back(known->second);
            if (isNew) {
                names_.push_back(name);
            }
        }
        ofFace_.resize(static_cast<std::size_t>(facesBefore), -1);
        for (const int name : ofMore) {
            ofFace_.push_back(name < 0 ? -1 : index[static_cast<std::size_t>(name)]);
        }
    }

private:
    std::vector<std::string>& names_;
    std::vector<int>& ofFace_;
    std::map<std::string, int> indexOf_;
};

void padTo(std::size_t count, std::vector<int>& list) {
    if (!list.empty()) {
        list.resize(count, -1);
    }
}

/// Names the objects uniquely.
void nameObjects(PolygonSoup& soup, const std::string& file, UniqueNames& names) {
    if (soup.objects.empty()) {
        soup.objects = {file};
        soup.faceObject.assign(static_cast<std::size_t>(soup.faceCount()), 0);
    }
    for (std::string& name : soup.objects) {
        if (!names.isFree(name)) {
            name.insert(0, " ").insert(0, file);
        }
        name = names.free(name);
    }
}

}  // namespace

PolygonSoup joinedSoups(std::vector<NamedSoup> files) {
    PolygonSoup all;
    all.statedUnit = files.front().soup.statedUnit;
    all.statedUp = files.front().soup.statedUp;
    UniqueNames names;
    JoinedNames objects(all.objects, all.faceObject), groups(all.groups, all.faceGroup),
        materials(all.materials, all.faceMaterial);
    for (auto& [name, soup] : files) {
        nameObjects(soup, name, names);
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
        objects.append(soup.objects, soup.faceObject, faces);
        groups.append(soup.groups, soup.faceGroup, faces);
        materials.append(soup.materials, soup.faceMaterial, faces);
        append(all.problems, soup.problems);
    }
    padTo(all.corners.size(), all.cornerUvs);
    for (auto* ofFace : {&all.faceObject, &all.faceGroup, &all.faceMaterial}) {
        padTo(static_cast<std::size_t>(all.faceCount()), *ofFace);
    }
    return all;
}

}  // namespace toile::io
