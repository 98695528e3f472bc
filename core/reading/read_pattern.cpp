// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/read_pattern.h"

#include <algorithm>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/reading/dxf_pattern.h"
#include "core/reading/garmentcode_reader.h"
#include "core/reading/svg_pattern.h"

namespace toile {

std::optional<PatternFileKind> patternFileKind(const std::filesystem::path& path) {
    std::string name = pathText(path.filename());
    std::ranges::transform(name, name.begin(), lowered);
    return name.ends_with(".dxf")                 ? std::optional(PatternFileKind::Dxf)
           : name.ends_with(".svg")               ? std::optional(PatternFileKind::Svg)
           : name.ends_with("specification.json") ? std::optional(PatternFileKind::GarmentCode)
                                                  : std::nullopt;
}

Result<PatternFile> readPatternFile(const std::filesystem::path& path,
                                    std::optional<LengthUnit> unit) {
    const auto about = [&path](Error error) {
        error.subject = Subject::file(path.string());
        return error;
    };
    const auto kind = patternFileKind(path);
    if (!kind) {
        return about({ErrorCode::UnknownFormat, {}, "it is no pattern that can be read"});
    }
    const Result<std::string> bytes = readFile(path);
    if (!bytes) {
        return bytes.error();
    }
    if (*kind != PatternFileKind::GarmentCode) {
        Result<PatternFile> file = *kind == PatternFileKind::Svg ? readSvgPattern(*bytes, unit)
                                                                 : readDxfPattern(*bytes, unit);
        return file ? std::move(file) : about(file.error());
    }
    Result<GarmentCode> code = readGarmentCode(*bytes, unit);
    return code ? Result(patternOf(*code)) : about(code.error());
}

}  // namespace toile
