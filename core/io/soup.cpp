// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/file.h"
#include "core/io/readable_name.h"
#include "core/io/text_cursor.h"
#ifdef TOILE_ASSIMP
#include "core/io/assimp_reader.h"
#endif

namespace toile {
namespace {

using Reader = Result<PolygonSoup> (*)(std::shared_ptr<const std::string>, const std::string&,
                                       Progress&);

Reader readerFor(std::string_view ending) {
    for (const auto& [known, reader] : {std::pair<std::string_view, Reader>(".obj", readObj),
                                        {".off", readOff},
                                        {".ply", readPly},
                                        {".stl", readStl}}) {
        if (equalsIgnoringCase(ending, known)) {
            return reader;
        }
    }
    return nullptr;
}

bool isForAssimp(std::string_view ending) {
    constexpr std::string_view kEndings[] = {".glb", ".gltf", ".fbx", ".dae", ".3mf"};
    return std::any_of(std::begin(kEndings), std::end(kEndings), [ending](std::string_view known) {
        return equalsIgnoringCase(ending, known);
    });
}

std::string utf8(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return readableName(std::string(text.begin(), text.end()));
}

}  // namespace

Result<PolygonSoup> readSoup(const std::filesystem::path& path, Progress& progress) {
    const std::string name = utf8(path.filename());
    const std::string ending = utf8(path.extension());
    if (isForAssimp(ending)) {
#ifdef TOILE_ASSIMP
        return readWithAssimp(path, name, progress);
#else
        return Error{
            ErrorCode::UnknownFormat, name,
            "\"" + ending + "\" needs Toile built with -DTOILE_ASSIMP=ON, or an export as OBJ"};
#endif
    }
    const Reader reader = readerFor(ending);
    if (reader == nullptr) {
        return Error{ErrorCode::UnknownFormat, name,
                     ending.empty() ? "the name has no ending" : "\"" + ending + "\""};
    }
    Result<std::string> bytes = readFile(path);
    if (!bytes) {
        return bytes.error();
    }
    return reader(std::make_shared<const std::string>(std::move(*bytes)), name, progress);
}

}  // namespace toile
