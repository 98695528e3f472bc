// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/characters.h"
#include "core/base/content_hash.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/io/assimp_reader.h"
#include "core/io/gltf_buffers.h"
#include "core/io/join_soups.h"
#include "core/io/usda_reader.h"
#include "core/io/zip_reader.h"

namespace toile {
namespace {

constexpr const char* kOfSeveralUnits = translatable(
    "its meshes state different units or up axes; unpack it and open those of one garment "
    "together");

constexpr const char* kIsPattern = translatable(
    "a pattern is no garment: give it to toile compare --pattern, or open it as the reference "
    "pattern");

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
    return {
        ErrorCode::UnknownFormat, Subject::file(name),
        isUsd ? worded("%1 is USD in binary form; save it as .usda", {Wording(std::string(ending))})
        : ending.empty() ? Wording("the name has no ending")
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
    }
    return soup;
}

}  // namespace toile
