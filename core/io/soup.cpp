// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/id.h"
#include "core/base/text.h"
#include "core/io/assimp_reader.h"
#include "core/io/gltf_buffers.h"
#include "core/io/soup_builder.h"
#include "core/io/usda_reader.h"
#include "core/io/zip_reader.h"

namespace toile::io {
namespace {

struct NamedSoup {
    std::string name;  ///< of its file, without the ending
    PolygonSoup soup;
};

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

/// Joins several files of a garment, in their order. A file without objects becomes one object with
/// the file's name, which is also the prefix of an object whose name is taken. The files' own
/// digits are dropped. Precondition: at least one, all in one unit.
/// Cost: linear. Pure.
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

}  // namespace

}  // namespace toile::io

namespace toile {
namespace {

constexpr const char* kOfSeveralUnits = translatable(
    "its meshes state different units or up axes; unpack it and open those of one garment "
    "together");

constexpr const char* kIsPattern = translatable(
    "it is a pattern, not a garment; use it with toile compare --pattern, or open it as the "
    "reference pattern");

using Reader = Result<PolygonSoup> (*)(std::shared_ptr<const std::string>, const std::string&,
                                       Progress&);

constexpr std::string_view kZip = ".zip", kUsd = ".usd";
constexpr std::string_view kBinaryUsd[] = {kUsd, ".usdc", ".usdz"};
/// Formats that `patternFileKind` reads instead.
constexpr std::string_view kOfPatterns[] = {".dxf", ".svg", "specification.json"};

/// The error for a file with this ending.
Error unknownEnding(const std::string& name, std::string_view ending) {
    const bool isUsd = std::ranges::any_of(
        kBinaryUsd, [&](std::string_view known) { return equalsIgnoringCase(ending, known); });
    return {ErrorCode::UnknownFormat, Subject::file(name),
            isUsd ? worded("%1 is binary USD; save it as .usda", {Wording(std::string(ending))})
            : ending.empty() ? Wording("its name has no ending")
                             : Wording("\"" + std::string(ending) + "\"")};
}

/// The error for a path whose ending is not a mesh format: the path may be a folder, for example.
Error unreadEnding(const std::filesystem::path& path, const std::string& name,
                   std::string_view ending) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (!std::filesystem::exists(status) || std::filesystem::is_directory(status)) {
        const auto bytes = readFile(path);
        return bytes ? unknownEnding(name, ending) : bytes.error();
    }
    const bool isPattern = std::ranges::any_of(kOfPatterns, [&name](std::string_view known) {
        return name.size() >= known.size() &&
               equalsIgnoringCase(std::string_view(name).substr(name.size() - known.size()), known);
    });
    return isPattern ? Error{ErrorCode::UnknownFormat, Subject::file(name), worded(kIsPattern)}
                     : unknownEnding(name, ending);
}

/// Reads USD text; the binary form is refused.
Result<PolygonSoup> readEitherUsd(std::shared_ptr<const std::string> bytes, const std::string& name,
                                  Progress& progress) {
    return bytes->starts_with("#usda") ? readUsd(std::move(bytes), name, progress)
                                       : unknownEnding(name, kUsd);
}

constexpr std::pair<std::string_view, Reader> kOwn[] = {{".obj", readObj},  {".ply", readPly},
                                                        {".off", readOff},  {".stl", readStl},
                                                        {".usda", readUsd}, {kUsd, readEitherUsd}};
constexpr std::string_view kInZip[] = {".obj", ".ply", ".off", ".stl", ".usda"};

Reader readerFor(std::string_view ending) {
    const auto known = std::ranges::find_if(
        kOwn, [ending](const auto& own) { return equalsIgnoringCase(ending, own.first); });
    return known == std::end(kOwn) ? nullptr : known->second;
}

/// Uses one of our own readers. @param name  the file, or the archive containing it, for messages
Result<PolygonSoup> readOwn(std::shared_ptr<const std::string> bytes, const std::string& name,
                            std::string_view ending, Progress& progress) {
    return readerFor(ending)(std::move(bytes), name, progress);
}

/// Units stated by meshes, as in USD, must agree.
bool areOfOneUnit(const std::vector<io::NamedSoup>& soups) {
    const auto statedBy = [](const io::NamedSoup& file) {
        const auto& unit = file.soup.statedUnit;
        const auto& up = file.soup.statedUp;
        return std::pair(unit ? std::optional(unit->unit) : std::nullopt,
                         up ? std::optional(up->axis) : std::nullopt);
    };
    return std::ranges::all_of(soups, [&](const io::NamedSoup& file) {
        return statedBy(file) == statedBy(soups.front());
    });
}

/// Joins several meshes of an archive into one garment, like several files opened together.
Result<PolygonSoup> readZipped(const std::string& archive, const std::string& name,
                               Progress& progress) {
    const auto meshes = io::meshesInZip(archive, name, kInZip, progress);
    if (!meshes) {
        return meshes.error();
    }
    std::vector<io::NamedSoup> soups;
    for (const io::UnzippedFile& mesh : *meshes) {
        const std::size_t dot = mesh.name.rfind('.');
        Result<PolygonSoup> soup = readOwn(mesh.bytes, name, mesh.name.substr(dot), progress);
        if (!soup) {
            return soup.error();
        }
        const std::size_t start = mesh.name.rfind('/', dot) + 1;  // 0 if there is none
        soups.push_back({readableName(mesh.name.substr(start, dot - start)), *std::move(soup)});
        progress.report(static_cast<double>(soups.size()) / static_cast<double>(meshes->size()));
    }
    if (soups.size() == 1) {
        return std::move(soups.front().soup);
    }
    if (!areOfOneUnit(soups)) {
        return Error{ErrorCode::FileUnreadable, Subject::file(name), worded(kOfSeveralUnits)};
    }
    return io::joinedSoups(std::move(soups));
}

/// Adds a note if the coordinates are floats, and too coarse at their distance from the origin.
/// @param areFloats  known from the format; otherwise their values decide
void noteFloats(PolygonSoup& soup, const std::string& name, bool areFloats) {
    constexpr double kCoarse = 1e-4;  // of the largest extent
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : soup.positions) {
        if (position.allFinite()) {
            box.extend(position);
        }
        if (!areFloats && position.allFinite() &&
            position != position.cast<float>().cast<double>()) {
            return;
        }
    }
    const double step = 2 * precisionOfFloats(soup);
    if (!box.isEmpty() && step > kCoarse * box.sizes().maxCoeff()) {
        soup.problems.push_back(
            {ErrorCode::VerticesWelded, Subject::file(name),
             worded("the mesh lies so far from the origin that its coordinates, which are floats, "
                    "are %1 apart in the file's unit; move it to the origin and export it again",
                    {figure(step, 3)})});
    }
}

}  // namespace

std::vector<std::string> readableEndings() {
    std::vector<std::string> endings;
    for (const auto& own : kOwn) {
        endings.emplace_back(own.first);
    }
    endings.insert(endings.end(), assimpEndings().begin(), assimpEndings().end());
    endings.emplace_back(kZip);
    return endings;
}

Result<PolygonSoup> readSoup(const std::filesystem::path& path, Progress& progress) {
    const std::string name = readableName(pathText(path.filename()));
    const std::string ending = readableName(pathText(path.extension()));
    const bool isZip = equalsIgnoringCase(ending, kZip);
    if (!isForAssimp(ending) && !isZip && readerFor(ending) == nullptr) {
        return unreadEnding(path, name, ending);
    }
    Result<std::string> bytes = readFile(path);
    if (!bytes) {
        return bytes.error();
    }
    const Result<std::uint64_t> hash = equalsIgnoringCase(ending, ".gltf")
                                           ? io::hashWithBuffers(path, *bytes, progress)
                                           : contentHash(*bytes);
    if (!hash) {
        return hash.error();
    }
    Result<PolygonSoup> soup = isForAssimp(ending) ? readWithAssimp(path, *bytes, name, progress)
                               : isZip
                                   ? readZipped(*bytes, name, progress)
                                   : readOwn(std::make_shared<const std::string>(std::move(*bytes)),
                                             name, ending, progress);
    if (soup) {
        soup->contentHash = *hash;
        if (isForAssimp(ending) || equalsIgnoringCase(ending, ".stl") ||
            equalsIgnoringCase(ending, ".ply")) {
            noteFloats(*soup, name, isForAssimp(ending));
        }
    }
    return soup;
}

}  // namespace toile
