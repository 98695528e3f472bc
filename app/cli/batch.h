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
    std::string path;                ///< as in the list
    std::vector<std::string> words;  ///< options of flatten: of the batch, then of its line
    Answer<Arguments> arguments{Arguments{}};  ///< parsed
    std::string inputHash{};                   ///< `hashOfContent`
    std::string name{};  ///< of its folder: the file's stem, and a hash of content and options
    /// Depends on content, options, formats and the program's version. A finished garment with the
    /// same key is skipped.
    std::string key{};
};

/// Paths of garments, each with the words of its own options.
using BatchLines = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// The garments of a list, in its order. Blank lines, lines that begin with # and empty fields are
/// skipped. Errors: FileUnreadable, of the list.
Result<BatchLines> readBatchList(const std::filesystem::path& list);

/// Whether a garment was given instead of a list: by its extension, or because no line is a file or
/// resembles a garment. Cost: one file test per line, up to the first file.
bool isNoBatchList(const std::filesystem::path& list, const BatchLines& lines);

/// Makes the entry of a line. Reads no files and sets neither hash nor name.
BatchEntry batchEntry(const BatchArguments& batch, const std::string& path,
                      const std::vector<std::string>& ownWords);

/// Hash of its files, its project's meshes and its seams; empty if one cannot be read. Call it in a
/// separate process, because reading may take long or crash.
std::string hashOfContent(const BatchEntry& entry);

/// Sets hash, name and key. @param hash  of its content
void identify(BatchEntry& entry, const BatchArguments& batch, const std::string& hash);

/// Status of a garment (docs/batch.md).
inline constexpr const char* kBatchDone = "done";  ///< every piece, every file
inline constexpr const char* kBatchSomeFailed =
    "some-failed";  ///< pieces failed, or cloth cut by the pattern would be wasted (`hasFaults`)
inline constexpr const char* kBatchFailed = "failed";  ///< no result

/// Cost of a garment: the only part of a record that varies between runs.
struct BatchCost {
    double wallSeconds = 0, processorSeconds = 0, peakMib = 0;
};

/// The figures of a garment without a result.
OrderedJson failedFigures(const Refusal& why);
/// The figures of a flattened garment, with the error of the first failed piece. Status done or
/// some-failed; no outputs yet.
/// @param fabrics  as for `findDoubts`
OrderedJson figuresOf(const Garment& garment, const PieceResults& results,
                      const std::vector<Fabric>& fabrics);

/// The complete record: one line with its line break.
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

/// The folder of one garment during writing: first NAME.part, then renamed, so NAME is always
/// complete, even if a process is killed. One process writes it while others wait, also across
/// machines on a shared file system. The file system must support locks.
class BatchFolder {
public:
    BatchFolder(const std::filesystem::path& parent, const std::string& name);
    ~BatchFolder();
    BatchFolder(const BatchFolder&) = delete;
    BatchFolder& operator=(const BatchFolder&) = delete;

    /// The record of a finished garment; empty if it is not finished, or if a retry may help.
    std::string finished(const std::string& key) const;

    /// Waits until this process may write the folder. @param isEnough  polled ten times a second;
    /// true: give up  @return whether it may. Errors: FileUnwritable, also without locks.
    Result<bool> claim(const std::function<bool()>& isEnough);
    /// Empties it. Precondition: claimed.
    Result<void> clear() const;
    /// Writes the record and renames the folder to its final name. Precondition: claimed.
    Result<void> finish(const std::string& record);

    const std::filesystem::path& part() const { return part_; }

private:
    void release();

    std::filesystem::path folder_, part_;
    int lock_ = -1;
};

/// While one exists, Ctrl-C, SIGTERM and SIGHUP are recorded instead of ending the program. Signals
/// ignored at startup stay ignored. One at a time.
class BatchSignals {
public:
    BatchSignals();
    ~BatchSignals();
    BatchSignals(const BatchSignals&) = delete;
    BatchSignals& operator=(const BatchSignals&) = delete;

    /// The received signal; 0: none.
    static int received();
    /// Returns on a signal, at a process's end, or after the seconds; negative: no limit.
    static void wait(double seconds);
};

/// How a process ended.
struct ProcessEnd {
    int status = 0;                                  ///< exit status if `signal` is 0
    int signal = 0;                                  ///< that ended the process
    bool isTimedOut = false, isInterrupted = false;  ///< `signal` was sent by us
    BatchCost cost{};
};

/// Limits of a process; 0: none.
struct ProcessLimits {
    double seconds = 0;
    int memoryMib = 0;  ///< see `limitMemory`
    int threads = 1;    ///< working threads, for its memory
};

/// Runs the work in a child process and waits for it. The child is killed with this process.
/// Precondition: BatchSignals exist; no other thread works.
/// @param work  returns the exit status  @return signal -1 if no process can be started
ProcessEnd inOwnProcess(const std::function<int()>& work, const ProcessLimits& limits);

/// The same for work that returns a text of at most 4096 bytes; empty if it does not finish.
ProcessEnd textOfOwnProcess(const std::function<std::string()>& work, const ProcessLimits& limits,
                            std::string& text);

/// Limits further memory of this process. Excludes its threads' stacks and the BLAS's work buffers,
/// most of which are never touched. No effect on systems without such limits.
/// @param mib  > 0  @param threads  that work simultaneously
void limitMemory(int mib, int threads);

/// Removes the limit.
void liftMemoryLimit();

}  // namespace toile::app
