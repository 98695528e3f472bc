// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/characters.h"
#include "core/base/content_hash.h"
#include "core/base/file.h"
#include "core/base/text.h"
#ifdef TOILE_ASSIMP
#include "core/io/assimp_reader.h"
#endif

namespace toile {
namespace {

using Reader = Result<PolygonSoup> (*)(std::shared_ptr<const std::string>, const std::string&,
                                       Progress&);

constexpr std::pair<std::string_view, Reader> kOwn[] = {
    {".obj", readObj}, {".ply", readPly}, {".off", readOff}, {".stl", readStl}};
constexpr std::string_view kForAssimp[] = {".glb", ".gltf", ".fbx", ".dae", ".3mf"};

Reader readerFor(std::string_view ending) {
    const auto known = std::ranges::find_if(
        kOwn, [ending](const auto& own) { return equalsIgnoringCase(ending, own.first); });
    return known == std::end(kOwn) ? nullptr : known->second;
}

bool isForAssimp(std::string_view ending) {
    return std::ranges::any_of(
        kForAssimp, [ending](std::string_view known) { return equalsIgnoringCase(ending, known); });
}

}  // namespace

std::vector<std::string> readableEndings() {
    std::vector<std::string> endings;
    for (const auto& own : kOwn) {
        endings.emplace_back(own.first);
    }
#ifdef TOILE_ASSIMP
    endings.insert(endings.end(), std::begin(kForAssimp), std::end(kForAssimp));
#endif
    return endings;
}

Result<PolygonSoup> readSoup(const std::filesystem::path& path, Progress& progress) {
    const std::string name = readableName(pathText(path.filename()));
    const std::string ending = readableName(pathText(path.extension()));
    if (isForAssimp(ending)) {
#ifdef TOILE_ASSIMP
        Result<PolygonSoup> soup = readWithAssimp(path, name, progress);
        if (const auto bytes = soup ? readFile(path) : Result<std::string>(soup.error()); bytes) {
            soup->contentHash = contentHash(*bytes);
        }
        return soup;
#else
        return Error{ErrorCode::UnknownFormat, Subject::file(name),
                     worded("this copy of Toile was built without %1; export the garment as OBJ",
                            {Wording(ending)})};
#endif
    }
    const Reader reader = readerFor(ending);
    if (reader == nullptr) {
        return Error{ErrorCode::UnknownFormat, Subject::file(name),
                     ending.empty() ? "the name has no ending" : "\"" + ending + "\""};
    }
    Result<std::string> bytes = readFile(path);
    if (!bytes) {
        return bytes.error();
    }
    const std::uint64_t hash = contentHash(*bytes);
    Result<PolygonSoup> soup =
        reader(std::make_shared<const std::string>(std::move(*bytes)), name, progress);
    if (soup) {
        soup->contentHash = hash;
    }
    return soup;
}

}  // namespace toile
