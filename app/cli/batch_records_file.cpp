// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch_records_file.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>

#include "app/cli/batch_arguments.h"
#include "core/base/characters.h"
#include "core/base/file.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEndingOfNote = ".of";
constexpr std::string_view kMarkOfNote = "# toile batch: the records beside this are of the list\n";

/// Whether a file lies in a folder or somewhere below it; both as the disk has them.
bool liesIn(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
           folder.end();
}

std::string shownRecords(const fs::path& path) {
    return shownText(pathText(path));
}

}  // namespace

fs::path recordsOf(const BatchArguments& batch) {
    const std::string stem = batch.list == "-" ? "stdin" : pathText(batch.list.stem());
    return batch.folder / (stem + ".jsonl");
}

std::optional<Refusal> refusalOfRecords(const BatchArguments& batch) {
    std::error_code ignored;  // of what is not there
    if (batch.list == "-" || !fs::is_regular_file(batch.list, ignored)) {
        return std::nullopt;
    }
    const fs::path records = recordsOf(batch);
    if (fs::equivalent(records, batch.list, ignored)) {
        return Refusal(kWrongUsage, shownRecords(records) +
                                        " is where the records would go; give the list another "
                                        "ending, such as .txt, or another folder with -o");
    }
    const fs::path list = fs::weakly_canonical(batch.list, ignored);
    const fs::path folder = fs::weakly_canonical(batch.folder, ignored);
    const fs::path note = pathText(records) + kEndingOfNote;
    if (fs::exists(note, ignored)) {
        const auto written = readFile(note);
        if (!written) {
            return Refusal(written.error());
        }
        if (!written->starts_with(kMarkOfNote)) {
            return Refusal(kWrongUsage, shownRecords(note) +
                                            " is no note of toile batch, which would take its "
                                            "place; give it or the list another name");
        }
        std::string_view said = std::string_view(*written).substr(kMarkOfNote.size());
        said.remove_suffix(said.ends_with('\n') ? 1 : 0);
        const fs::path other = folder / said;
        if (fs::is_regular_file(other, ignored) && !fs::equivalent(other, list, ignored)) {
            return Refusal(kWrongUsage,
                           shownRecords(records) + " is of another list, " + shownRecords(other) +
                               "; give this one another name, or another folder with -o");
        }
    }
    // Seen from the folder, so that both may move together.
    const fs::path said = liesIn(list, folder) ? list.lexically_relative(folder) : list;
    const auto put = writeFile(note, std::string(kMarkOfNote) + said.string() + '\n');
    return put ? std::nullopt : std::optional(Refusal(put.error()));
}

}  // namespace toile::app
