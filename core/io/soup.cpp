// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup.h"

#include <utility>

#include "core/base/file.h"
#include "core/io/readable_name.h"
#include "core/io/text_cursor.h"

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

std::string utf8(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return readableName(std::string(text.begin(), text.end()));
}

}  // namespace

Result<PolygonSoup> readSoup(const std::filesystem::path& path, Progress& progress) {
    const std::string name = utf8(path.filename());
    const std::string ending = utf8(path.extension());
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
