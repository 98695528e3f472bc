// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <vector>

#include "app/cli/batch.h"
#include "app/cli/command_line.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/json_fields.h"
#include "core/base/text.h"
#include "core/formats/export_file.h"
#include "core/formats/json.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEndingOfNote = ".of";
constexpr std::string_view kMarkOfNote = "# toile batch: the records beside this are of the list\n";

/// Whether a file is in or below a folder; both paths are canonical.
bool liesIn(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
           folder.end();
}

std::string shownRecords(const fs::path& path) {
    return shownText(pathText(path));
}

/// The records file of a list: shirts.jsonl for shirts.txt; stdin.jsonl.
fs::path recordsOf(const BatchArguments& batch) {
    const std::string stem = batch.list == "-" ? "stdin" : pathText(batch.list.stem());
    return batch.folder / (stem + ".jsonl");
}

/// Refuses records that would replace the list itself, or the records of another existing list of
/// the same name. To detect that, writes the list's name to shirts.jsonl.of, except for standard
/// input. Refuses to overwrite such a file if Toile did not write it.
/// Precondition: the folder exists if it can be created.
std::optional<Refusal> refusalOfRecords(const BatchArguments& batch) {
    std::error_code ignored;  // of missing files
    if (batch.list == "-" || !fs::is_regular_file(batch.list, ignored)) {
        return std::nullopt;
    }
    const fs::path records = recordsOf(batch);
    if (fs::equivalent(records, batch.list, ignored)) {
        return usageRefusal(shownRecords(records) +
                            " would be overwritten by the records; give the list another "
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
            return usageRefusal(
                shownRecords(note) +
                " is not a file of toile batch, which would overwrite it; rename it or the list");
        }
        std::string_view named = std::string_view(*written).substr(kMarkOfNote.size());
        named.remove_suffix(named.ends_with('\n') ? 1 : 0);
        const fs::path other = folder / named;
        if (fs::is_regular_file(other, ignored) && !fs::equivalent(other, list, ignored)) {
            return usageRefusal(shownRecords(records) + " belongs to another list, " +
                                shownRecords(other) +
                                "; rename this list, or choose another folder with -o");
        }
    }
    // Relative to the folder, so that both can be moved together.
    const fs::path shown = liesIn(list, folder) ? list.lexically_relative(folder) : list;
    const auto put = writeFile(note, std::string(kMarkOfNote) + shown.string() + '\n');
    return put ? std::nullopt : std::optional(Refusal(put.error()));
}

/// Notes per garment in the summary. A damaged file may cause thousands.
constexpr std::size_t kMaxNotes = 20;

void addNotes(OrderedJson& figures, const Messages& messages) {
    for (const std::string& sentence : messages.sentences()) {
        if (figures["notes"].size() < kMaxNotes) {
            figures["notes"].push_back(text(sentence));
        }
    }
}

OrderedJson flattenedAndWritten(const BatchEntry& entry, const std::vector<std::string>& formats,
                                const std::filesystem::path& folder) {
    Messages messages;
    const auto checked =
        entry.arguments ? withProject(*entry.arguments, messages) : entry.arguments;
    if (!checked) {
        return failedFigures(checked.refusal());
    }
    const Arguments& arguments = *checked;
    Progress progress;
    const auto read = readGarment(arguments, progress, messages);
    if (!read) {
        return failedFigures(read.refusal());
    }
    const Garment& garment = *read;
    const PieceResults results = flattened(arguments, garment, progress);
    const FinishedPattern made = finished(arguments, garment, results);
    OrderedJson figures = figuresOf(garment, results, fabricsOf(made.laid.pattern, made.fabric));
    reportProblems(garment, messages);
    reportFailures(results, messages);
    addNotes(figures, messages);
    const bool isFlat = std::ranges::any_of(
        results, [](const auto& result) -> bool { return result->flat.has_value(); });
    if (!isFlat) {  // no pattern; the report says why
        figures["status"] = kBatchFailed;
    }
    const ExportSource source = made.source(arguments.exporting);
    for (const std::string& format : formats) {
        if (!isFlat && format != "json") {
            continue;
        }
        const auto written = exportFile(folder / ("pattern." + format), source);
        if (!written) {
            return failedFigures(written.error());
        }
        for (const Wording& note : written->notes) {
            figures["notes"].push_back(text(note));
        }
        for (const std::filesystem::path& file : written->files) {
            figures["outputs"].push_back(text(pathText(file.filename())));
        }
    }
    return figures;
}

/// The work of a garment's own process: flattens it and writes its files, such as `pattern.svg`, to
/// a folder. @return its figures (batch.h). Never throws.
OrderedJson flattenForBatch(const BatchEntry& entry, const std::vector<std::string>& formats,
                            const std::filesystem::path& folder) {
    try {
        return flattenedAndWritten(entry, formats, folder);
    } catch (const std::bad_alloc&) {
        liftMemoryLimit();  // the error message needs memory
        return failedFigures(Error{ErrorCode::OutOfMemory, Subject::file(entry.path)});
    } catch (const std::exception& fault) {
        return failedFigures(
            {kCrashed, std::string("stopped by an unexpected error (") + fault.what() + ")"});
    }
}

/// Tries per garment if its process is killed, as the system does when memory is short.
constexpr int kTries = 3;
constexpr int kStatusOfSignals = 128;
/// Written by the garment's process for this one.
constexpr const char* kFiguresFile = "figures.json";

/// Why there are no figures.
OrderedJson figuresOfEnd(const ProcessEnd& end, const BatchArguments& batch) {
    if (end.isTimedOut) {
        return failedFigures({kTimedOut, "took longer than " + shortest(batch.limitSeconds) +
                                             " s; allow more with --limit"});
    }
    if (end.signal == SIGKILL || end.signal == SIGTERM) {
        return failedFigures({kKilled,
                              "was killed from outside, probably because memory was short; run the "
                              "batch again with fewer garments at once"});
    }
    if (end.signal > 0) {
        return failedFigures({kCrashed, std::string("crashed (") + strsignal(end.signal) +
                                            "); please report the file"});
    }
    return failedFigures(Error{ErrorCode::OutOfMemory, {}, "no process could be started"});
}

bool wasKilled(const ProcessEnd& end) {
    return !end.isTimedOut && !end.isInterrupted &&
           (end.signal == SIGKILL || end.signal == SIGTERM);
}

/// A line of the list, and the end of the process that read its content.
struct IdentifiedEntry {
    BatchEntry entry;
    ProcessEnd end{};
};

IdentifiedEntry identified(const BatchArguments& batch, const std::string& path,
                           const std::vector<std::string>& words, const ProcessLimits& limits) {
    IdentifiedEntry found{batchEntry(batch, path, words)};
    std::string hash;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        found.end = textOfOwnProcess([&] { return hashOfContent(found.entry); }, limits, hash);
        if (!wasKilled(found.end)) {
            break;
        }
    }
    identify(found.entry, batch, hash);
    return found;
}

/// Flattens the garment into its claimed folder. @return its record; empty: interrupted
Result<std::string> made(const IdentifiedEntry& identified, const BatchArguments& batch,
                         const ProcessLimits& limits, const BatchFolder& folder) {
    const BatchEntry& entry = identified.entry;
    if (identified.end.signal != 0) {
        return recordLine(entry, figuresOfEnd(identified.end, batch), identified.end.cost);
    }
    const std::filesystem::path left = folder.part() / kFiguresFile;
    ProcessEnd end;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        if (auto cleared = folder.clear(); !cleared) {
            return cleared.error();
        }
        end = inOwnProcess(
            [&] {
                const OrderedJson figures = flattenForBatch(entry, batch.formats, folder.part());
                return writeFile(left, jsonText(figures)) ? kExitDone : kExitUnreadable;
            },
            limits);
        if (end.isInterrupted) {
            return std::string();
        }
        if (!wasKilled(end)) {
            break;
        }
    }
    const auto figures = readFile(left);
    const OrderedJson read = figures ? OrderedJson::parse(*figures, nullptr, false) : OrderedJson();
    if (end.signal == 0 && read.is_object()) {
        std::error_code ignored;
        std::filesystem::remove(left, ignored);
        return recordLine(entry, read, end.cost);
    }
    if (auto cleared = folder.clear(); !cleared) {
        return cleared.error();
    }
    return recordLine(entry, figuresOfEnd(end, batch), end.cost);
}

/// The results of a list so far.
struct BatchTally {
    int done = 0, someFailed = 0, failed = 0, before = 0;
    std::string records;  ///< a line each, in the list's order
    /// By the garment's folder: offset and size of its record in `records`, and whether it is old.
    std::map<std::string, std::tuple<std::size_t, std::size_t, bool>> known;
    int lines = 0;

    void add(const std::string& record, bool isBefore, std::ostream& out) {
        const RecordHead head = headOf(record);
        done += head.status == kBatchDone;
        someFailed += head.status == kBatchSomeFailed;
        failed += head.status == kBatchFailed;
        before += isBefore;
        ++lines;
        records += record;
        out << (isBefore ? "finished before, " : "") << head.status;
        if (!head.code.empty()) {
            out << " (" << head.code << ": " << shownText(head.message) << ')';
        }
        out << std::endl;  // flush while the next garment is running
    }

    /// Adds a garment if it repeats an earlier line. @return whether it does
    bool addKnown(const BatchEntry& entry, std::ostream& out) {
        const auto found = known.find(entry.name);
        if (found == known.end()) {
            return false;
        }
        const auto [start, size, isBefore] = found->second;
        out << shownText(entry.path) << ": the same as an earlier one, ";
        add(recordLineOf(entry.path, records.substr(start, size)), isBefore, out);
        return true;
    }
};

/// Finishes one garment. @return false if interrupted
Result<bool> finishGarment(const IdentifiedEntry& identified, const BatchArguments& batch,
                           const ProcessLimits& limits, BatchTally& tally, std::ostream& out) {
    const BatchEntry& entry = identified.entry;
    BatchFolder folder(batch.folder, entry.name);
    std::string record = folder.finished(entry.key);
    const auto claimed = record.empty() ? folder.claim([&] {
        record = folder.finished(entry.key);
        return !record.empty() || BatchSignals::received() != 0;
    })
                                        : Result<bool>(false);
    if (!claimed) {
        return claimed.error();
    }
    if (!*claimed && record.empty()) {
        return false;
    }
    // Another process may have finished it before this one got the lock.
    record = *claimed ? folder.finished(entry.key) : record;
    const bool isBefore = !record.empty();
    if (!isBefore) {
        auto line = made(identified, batch, limits, folder);
        if (!line) {
            return line.error();
        }
        if (line->empty()) {
            return false;
        }
        if (auto put = folder.finish(*line); !put) {
            return put.error();
        }
        record = std::move(*line);
    }
    record = recordLineOf(entry.path, record);
    tally.known[entry.name] = {tally.records.size(), record.size(), isBefore};
    out << shownText(entry.path) << ": ";
    tally.add(record, isBefore, out);
    return true;
}

}  // namespace

int runBatch(const Arguments& arguments, std::ostream& out, Messages& messages) {
    const BatchArguments& batch = arguments.batch;
    const auto lines = readBatchList(batch.list);
    if (!lines) {
        return refuse(lines.error(), messages);
    }
    if (isNoBatchList(batch.list, *lines)) {
        const std::string list = batch.list == "-" ? "standard input" : pathText(batch.list);
        return refuse(
            usageRefusal(shownText(list) +
                         " is not a list of garments; give a file with one path per line, "
                         "or use toile flatten for a single garment"),
            messages);
    }
    std::error_code ignored;  // writing reports the error later
    std::filesystem::create_directories(batch.folder, ignored);
    const BatchSignals signals;
    if (const auto refusal = refusalOfRecords(batch)) {
        return refuse(*refusal, messages);
    }
    const ProcessLimits limits{batch.limitSeconds, batch.memoryMib, batch.threads};
    BatchTally tally;
    for (const auto& [path, words] : *lines) {
        const IdentifiedEntry next = identified(batch, path, words, limits);
        if (!next.end.isInterrupted && tally.addKnown(next.entry, out)) {
            continue;
        }
        const auto isThere = next.end.isInterrupted
                                 ? Result<bool>(false)
                                 : finishGarment(next, batch, limits, tally, out);
        if (!isThere) {
            return refuse(isThere.error(), messages);
        }
        if (!*isThere || BatchSignals::received() != 0) {
            messages.add("interrupted; run the same command again to continue.");
            return kStatusOfSignals + BatchSignals::received();
        }
    }
    if (const auto written = writeFile(recordsOf(batch), tally.records); !written) {
        return refuse(written.error(), messages);
    }
    out << counted(tally.lines, "garment") << ": " << tally.done << " done, " << tally.someFailed
        << " with failed pieces, " << tally.failed << " failed; " << tally.before
        << " finished before\n"
        << "wrote " << pathText(recordsOf(batch)) << '\n';
    out.flush();
    if (!out) {
        return kExitUnreadable;
    }
    return tally.done == tally.lines ? kExitDone : kExitSomeFailed;
}

}  // namespace toile::app
