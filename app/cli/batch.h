// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/json_fields.h"
#include "core/base/result.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile::app {

// The parts of `toile batch`: the list of garments, their records, folders and processes.

/// A garment of a list, with everything that determines its result.
struct BatchEntry {
    std::string path;                ///< as the list has it
    std::vector<std::string> words;  ///< options of flatten: those of the batch, then its own
    Answer<Arguments> arguments{Arguments{}};  ///< parsed
    std::string inputHash{};                   ///< `hashOfContent`
    std::string name{};  ///< of its folder: the file's stem, and a hash of content and options
    /// Of content, options, formats and version of the program: a finished garment with the same
    /// key is skipped.
    std::string key{};
};

/// Paths of garments, each with the words of its own options.
using BatchLines = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// The garments of a list, in its order. Blank lines, lines that begin with # and empty fields are
/// skipped. Errors: FileUnreadable, of the list.
Result<BatchLines> readBatchList(const std::filesystem::path& list);

/// Whether a garment was given instead of a list: by its ending, or because no line is a file or
/// looks like a garment. Cost: one look at the disk per line, up to the first file.
bool isNoBatchList(const std::filesystem::path& list, const BatchLines& lines);

/// The garment of a line; its files are not read, and it has neither hash nor name yet.
BatchEntry batchEntry(const BatchArguments& batch, const std::string& path,
                      const std::vector<std::string>& ownWords);

/// Hash of the bytes of its files, its project's meshes and its seams; empty if one cannot be read.
/// Reading may take long or fail: call it in a process of its own.
std::string hashOfContent(const BatchEntry& entry);

/// Sets hash, name and key. @param hash  of its content
void identify(BatchEntry& entry, const BatchArguments& batch, const std::string& hash);

/// Status of a garment (docs/batch.md).
inline constexpr const char* kBatchDone = "done";  ///< every piece, every file
inline constexpr const char* kBatchSomeFailed =
    "some-failed";  ///< pieces failed, or cloth cut by the pattern would be wasted (`hasFaults`)
inline constexpr const char* kBatchFailed = "failed";  ///< there is nothing

/// Cost of a garment: the only part of a record that differs between runs.
struct BatchCost {
    double wallSeconds = 0, processorSeconds = 0, peakMib = 0;
};

/// The figures of a garment without a result.
OrderedJson failedFigures(const Refusal& why);
/// The figures of a flattened garment; its error is that of the first failed piece. Status done or
/// some-failed; no outputs yet.
/// @param fabrics  as `findDoubts` takes them
OrderedJson figuresOf(const Garment& garment, const PieceResults& results,
                      const std::vector<Fabric>& fabrics);

/// The whole record, one line with its end.
std::string recordLine(const BatchEntry& entry, const OrderedJson& figures, const BatchCost& cost);
/// The record of a garment with the same content, for another line of the list.
std::string recordLineOf(std::string_view input, std::string_view line);

/// The fields of a record that are read again; empty if it is no record.
struct RecordHead {
    std::string key, status, code, message;
    bool isRetryable = false;
    std::vector<std::string> outputs;
};
RecordHead headOf(std::string_view line);

/// The record in a garment's folder; it is written last.
inline constexpr const char* kBatchRecord = "garment.json";

/// The folder of one garment while it is written: first as NAME.part, then renamed, so that NAME is
/// always complete, whenever a process is killed. Of several processes, on one machine or on a
/// shared file system, one writes it and the others wait. The file system must support locks.
class BatchFolder {
public:
    BatchFolder(const std::filesystem::path& parent, const std::string& name);
    ~BatchFolder();
    BatchFolder(const BatchFolder&) = delete;
    BatchFolder& operator=(const BatchFolder&) = delete;

    /// The record if the garment is finished; empty if it is not, or if another try may help.
    std::string finished(const std::string& key) const;

    /// Waits until this process may write the folder. @param isEnough  asked ten times a second;
    /// true: give up  @return whether it may. Errors: FileUnwritable, also without locks.
    Result<bool> claim(const std::function<bool()>& isEnough);
    /// Empties it. Precondition: claimed.
    Result<void> clear() const;
    /// Writes the record and puts the folder in its place. Precondition: claimed.
    Result<void> finish(const std::string& record);

    const std::filesystem::path& part() const { return part_; }

private:
    void release();

    std::filesystem::path folder_, part_;
    int lock_ = -1;
};

/// While one exists, Ctrl-C, SIGTERM and SIGHUP are noted and do not end the program. Signals that
/// it was started to ignore stay ignored. One at a time.
class BatchSignals {
public:
    BatchSignals();
    ~BatchSignals();
    BatchSignals(const BatchSignals&) = delete;
    BatchSignals& operator=(const BatchSignals&) = delete;

    /// The signal that came; 0: none.
    static int received();
    /// Until a signal comes, a process ends, or the seconds are over; negative: no limit.
    static void wait(double seconds);
};

/// How a process ended.
struct ProcessEnd {
    int status = 0;                                  ///< exit status; where `signal` is 0
    int signal = 0;                                  ///< that ended it
    bool isTimedOut = false, isInterrupted = false;  ///< `signal` is ours then
    BatchCost cost{};
};

/// Limits of a process; 0: none.
struct ProcessLimits {
    double seconds = 0;
    int memoryMib = 0;  ///< as `limitMemory`
    int threads = 1;    ///< that work in it; for its memory
};

/// Does the work in a child process and waits for it. The child ends with this process.
/// Precondition: BatchSignals exist; no other thread works.
/// @param work  returns the exit status  @return signal -1 if no process can be started
ProcessEnd inOwnProcess(const std::function<int()>& work, const ProcessLimits& limits);

/// The same for work that returns a text of at most 4096 bytes; empty if it does not finish.
ProcessEnd textOfOwnProcess(const std::function<std::string()>& work, const ProcessLimits& limits,
                            std::string& text);

/// Limits further memory of this process. The stacks of its threads and the working memory of the
/// BLAS, most of which is never touched, do not count. No effect on systems without such limits.
/// @param mib  > 0  @param threads  that work at the same time
void limitMemory(int mib, int threads);

/// Ends the limit.
void liftMemoryLimit();

}  // namespace toile::app
