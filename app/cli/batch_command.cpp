// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstring>
#include <map>
#include <ostream>
#include <tuple>

#include "app/cli/arguments.h"
#include "app/cli/batch_folder.h"
#include "app/cli/batch_garment.h"
#include "app/cli/batch_list.h"
#include "app/cli/batch_process.h"
#include "app/cli/batch_records_file.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"

namespace toile::app {
namespace {

/// How often a garment is tried whose process another one kills, as the system does where memory
/// is short.
constexpr int kTries = 3;
constexpr int kStatusOfSignals = 128;
/// What the garment's process leaves for this one.
constexpr const char* kFiguresFile = "figures.json";

/// Why there are no figures.
OrderedJson figuresOfEnd(const ProcessEnd& end, const BatchArguments& batch) {
    if (end.isTimedOut) {
        return failedFigures({kTimedOut, "took longer than " + shortest(batch.limitSeconds) +
                                             " s; give it more with --limit"});
    }
    if (end.signal == SIGKILL || end.signal == SIGTERM) {
        return failedFigures({kKilled,
                              "was killed from outside, as happens where memory is short; run the "
                              "batch again, fewer garments at once"});
    }
    if (end.signal > 0) {
        return failedFigures({kCrashed, std::string("ended by a fault of the program (") +
                                            strsignal(end.signal) + "); please report the file"});
    }
    return failedFigures(Error{ErrorCode::OutOfMemory, {}, "no process could be had"});
}

bool wasKilled(const ProcessEnd& end) {
    return !end.isTimedOut && !end.isInterrupted &&
           (end.signal == SIGKILL || end.signal == SIGTERM);
}

/// A line of the list, and how the process ended that was to read its content.
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

/// What has become of a list.
struct BatchTally {
    int done = 0, someFailed = 0, failed = 0, before = 0;
    std::string records;  ///< a line each, in the list's order
    /// By the garment's folder: where its record is in `records`, how long, whether from before.
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
        out << std::endl;  // seen while the next one is under way
    }

    /// Of a garment that a line before has named too. @return whether it is one
    bool addKnown(const BatchEntry& entry, std::ostream& out) {
        const auto found = known.find(entry.name);
        if (found == known.end()) {
            return false;
        }
        const auto [start, size, isBefore] = found->second;
        out << shownText(entry.path) << ": the same as one before, ";
        add(recordLineOf(entry.path, records.substr(start, size)), isBefore, out);
        return true;
    }
};

/// Brings one garment to its end. @return whether it came there; false: interrupted
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
    // Another process may have finished it between the look and the claim.
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

int runBatch(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    const BatchArguments& batch = arguments.batch;
    const auto lines = readBatchList(batch.list);
    if (!lines) {
        return refuse(lines.error(), err);
    }
    if (isNoBatchList(batch.list, *lines)) {
        const std::string list = batch.list == "-" ? "standard input" : pathText(batch.list);
        err << "toile: " << shownText(list)
            << " is no list of garments; give one, a path a line (a garment alone is flattened by "
               "toile flatten)\n";
        return kExitUsage;
    }
    std::error_code ignored;  // said where something is written
    std::filesystem::create_directories(batch.folder, ignored);
    const BatchSignals signals;
    if (const auto refusal = refusalOfRecords(batch)) {
        err << "toile: " << refusal->message << '\n';
        return refusal->code == kWrongUsage ? kExitUsage : kExitUnreadable;
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
            return refuse(isThere.error(), err);
        }
        if (!*isThere || BatchSignals::received() != 0) {
            err << "toile: interrupted; run the same command again to go on.\n";
            return kStatusOfSignals + BatchSignals::received();
        }
    }
    if (const auto written = writeFile(recordsOf(batch), tally.records); !written) {
        return refuse(written.error(), err);
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
