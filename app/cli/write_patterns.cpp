// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/write_patterns.h"

#include <algorithm>
#include <ostream>

#include "core/formats/drawing/drawing.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"

namespace toile::app {

std::optional<Refusal> refusalOfNoPattern(const PieceResults& results) {
    const auto isFlat = [](const auto& result) -> bool { return result->flat.has_value(); };
    if (std::ranges::any_of(results, isFlat)) {
        return std::nullopt;
    }
    return Refusal(kNotFlat, "no piece could be flattened, so there is no pattern.");
}

std::optional<Refusal> refusalOfNoPattern(const PieceResults& results,
                                          const std::vector<std::filesystem::path>& outputs) {
    const auto isReport = [](const std::filesystem::path& output) {
        const Format* format = formatOf(output);
        return format != nullptr && (format->id == FormatId::Report ||
                                     format->id == FormatId::Html || format->id == FormatId::Csv);
    };
    return std::ranges::all_of(outputs, isReport) ? std::nullopt : refusalOfNoPattern(results);
}

Refusal refusalOfProof(const Error& error, const PieceResults& results) {
    const auto noPattern = refusalOfNoPattern(results);
    return error.code == ErrorCode::NoGeometry && noPattern ? *noPattern : Refusal(error);
}

bool writePatterns(const std::vector<std::filesystem::path>& outputs, const ExportSource& source,
                   std::ostream& out, std::ostream& err) {
    if (outputs.empty()) {
        return true;
    }
    if (refusalOfNoPattern(source.results())) {
        err << "toile: no piece could be flattened, so the written files contain no pattern\n";
    }
    for (const Wording& note : overlapNotes(source.laid().pattern, source.drawing())) {
        err << "toile: " << note << '\n';
    }
    bool isDone = true;
    for (const auto& output : outputs) {
        const auto written = exportFile(output, source);
        if (!written) {
            err << "toile: " << sentence(written.error()) << '\n';
            isDone = false;
            continue;
        }
        for (const std::filesystem::path& file : written->files) {
            out << "wrote " << file.string();
            if (written->readBack && file == written->files.front()) {
                out << "; " << readBackSentence(*written->readBack);
            }
            out << '\n';
        }
    }
    return isDone;
}

}  // namespace toile::app
