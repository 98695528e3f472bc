// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch_garment.h"

#include <algorithm>
#include <exception>
#include <new>
#include <sstream>

#include "app/cli/batch_list.h"
#include "app/cli/batch_memory.h"
#include "app/cli/batch_record.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/typed_words.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/export/export_file.h"
#include "core/export/json.h"

namespace toile::app {
namespace {

/// A garment may have thousands of things to say; nobody reads so many in a list of garments.
constexpr std::size_t kMostNotes = 20;

/// Adds what was said, a sentence a line, as the notes.
void addNotes(OrderedJson& figures, const std::string& said) {
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line) && figures["notes"].size() < kMostNotes;) {
        figures["notes"].push_back(text(withoutSpeaker(line)));
    }
}

OrderedJson flattenedAndWritten(const BatchEntry& entry, const std::vector<std::string>& formats,
                                const std::filesystem::path& folder) {
    std::ostringstream said;
    const Arguments arguments = withProjectOfFiles(entry.arguments, said);
    if (arguments.isMessage()) {
        return failedFigures(Refusal(arguments));
    }
    Progress progress;
    auto read = readGarment(arguments, progress, said);
    if (!read) {
        return failedFigures(read.error());
    }
    const Garment& garment = *read;
    const PieceResults results = flattened(arguments, garment, progress);
    OrderedJson figures = figuresOf(garment, results);
    printProblems(garment, said);
    printFailures(results, said);
    addNotes(figures, said.str());
    const bool isFlat = std::ranges::any_of(
        results, [](const auto& result) -> bool { return result->flat.has_value(); });
    if (!isFlat) {  // no pattern; the report says why
        figures["status"] = kBatchFailed;
    }
    const LaidOutPattern laid = laidOut(arguments, garment, results);
    const ExportSource source(garment, results, laid, arguments.exporting, {}, arguments.lines,
                              arguments.fabric.value_or(fabricPresets().front()));
    for (const std::string& format : formats) {
        if (!isFlat && format != "json") {
            continue;
        }
        const auto written = exportFile(folder / ("pattern." + format), source);
        if (!written) {
            return failedFigures(written.error());
        }
        for (const std::filesystem::path& file : written->files) {
            figures["outputs"].push_back(text(pathText(file.filename())));
        }
    }
    return figures;
}

}  // namespace

OrderedJson flattenForBatch(const BatchEntry& entry, const std::vector<std::string>& formats,
                            const std::filesystem::path& folder) {
    try {
        return flattenedAndWritten(entry, formats, folder);
    } catch (const std::bad_alloc&) {
        liftMemoryLimit();  // to say so takes some
        return failedFigures(Error{ErrorCode::OutOfMemory, Subject::file(entry.path)});
    } catch (const std::exception& fault) {
        return failedFigures(
            {kCrashed, std::string("stopped by an unexpected fault (") + fault.what() + ")"});
    }
}

}  // namespace toile::app
