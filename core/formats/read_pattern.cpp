// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/read_pattern.h"

#include <algorithm>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/formats/garmentcode/garmentcode_reader.h"

namespace toile {

std::optional<PatternFileKind> patternFileKind(const std::filesystem::path& path) {
    std::string name = pathText(path.filename());
    std::ranges::transform(name, name.begin(), lowered);
    return name.ends_with(".dxf")                 ? std::optional(PatternFileKind::Dxf)
           : name.ends_with(".svg")               ? std::optional(PatternFileKind::Svg)
           : name.ends_with("specification.json") ? std::optional(PatternFileKind::GarmentCode)
                                                  : std::nullopt;
}

Result<PatternFile> readPattern(std::string_view bytes, PatternFileKind kind,
                                const std::string& name, std::optional<FileUnit> unit) {
    const auto about = [&name](Error error) {
        error.subject = Subject::file(name);
        return error;
    };
    if (kind != PatternFileKind::GarmentCode) {
        Result<PatternFile> file = kind == PatternFileKind::Svg ? readSvgPattern(bytes, unit)
                                                                : readDxfPattern(bytes, unit);
        if (!file) {
            return about(file.error());
        }
        shortenNotes(file->notes);
        return file;
    }
    Result<GarmentCode> code = readGarmentCode(bytes, unit);
    return code ? Result(patternOf(*code)) : about(code.error());
}

Result<PatternFile> readPatternFile(const std::filesystem::path& path,
                                    std::optional<FileUnit> unit) {
    const auto kind = patternFileKind(path);
    if (!kind) {
        return Error{ErrorCode::UnknownFormat, Subject::file(path.string()),
                     "it is not a pattern that Toile can read"};
    }
    const Result<std::string> bytes = readFile(path);
    return bytes ? readPattern(*bytes, *kind, path.string(), unit) : bytes.error();
}

}  // namespace toile
