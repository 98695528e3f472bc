// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/read_pattern.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/formats/garmentcode/garmentcode_reader.h"

namespace toile {

namespace {

/// Whether the start of a JSON file has panels, as GarmentCode files do.
bool hasPanels(const std::filesystem::path& path) {
    constexpr std::streamsize kLooked = 1 << 20;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        return false;
    }
    std::ifstream file(path, std::ios::binary);
    std::string start(kLooked, ' ');
    file.read(start.data(), kLooked);
    return start.find("\"panels\"") != std::string::npos;
}

/// Adds a note if a table with grade rules lies beside a DXF file, under its name.
void noteRuleTable(const std::filesystem::path& path, PatternFile& file) {
    for (const char* ending : {".rul", ".RUL"}) {
        std::error_code ignored;
        const auto table = std::filesystem::path(path).replace_extension(ending);
        if (std::filesystem::exists(table, ignored)) {
            file.notes.push_back(
                worded("the grade rules in \"%1\" are not read, only sizes drawn in the DXF file",
                       {readableName(pathText(table.filename()))}));
            return;
        }
    }
}

}  // namespace

std::optional<PatternFileKind> patternFileKind(const std::filesystem::path& path) {
    std::string name = pathText(path.filename());
    std::ranges::transform(name, name.begin(), lowered);
    return name.ends_with(".dxf")   ? std::optional(PatternFileKind::Dxf)
           : name.ends_with(".svg") ? std::optional(PatternFileKind::Svg)
           : name.ends_with("specification.json") || (name.ends_with(".json") && hasPanels(path))
               ? std::optional(PatternFileKind::GarmentCode)
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
    if (!bytes) {
        return bytes.error();
    }
    Result<PatternFile> file = readPattern(*bytes, *kind, path.string(), unit);
    if (file && kind == PatternFileKind::Dxf) {
        noteRuleTable(path, *file);
    }
    return file;
}

}  // namespace toile
