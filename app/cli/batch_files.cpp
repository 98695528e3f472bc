// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <iostream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/cli/batch.h"
#include "app/cli/command_line.h"
#include "core/base/file.h"
#include "core/base/id.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/diagnose/doubt.h"
#include "core/formats/json.h"
#include "core/formats/tables/report_tables.h"
#include "core/seam/seam_measure.h"

namespace toile::app {
namespace {

constexpr std::size_t kLongestStem = 60;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string joinedWords(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += word + '\t';
    }
    return text;
}

/// The hash of the bytes of one or several files; empty if one cannot be read.
std::string hashOfFiles(const std::vector<std::filesystem::path>& files) {
    std::string hashes;
    for (const std::filesystem::path& file : files) {
        const auto bytes = readFile(file);
        if (!bytes) {
            return {};
        }
        hashes += hashText(contentHash(*bytes));
    }
    return files.size() == 1 ? hashes : hashText(contentHash(hashes));
}

/// The first option with a value that a line repeats from the batch; null if there is none.
const std::string* repeatedOption(const std::vector<std::string>& ofAll,
                                  const std::vector<std::string>& own) {
    const auto isAgain = [&ofAll](const std::string& word) {
        const auto said = std::ranges::find(ofAll, word.substr(0, word.find('=')));
        return word.starts_with("--") && said != ofAll.end() && std::next(said) != ofAll.end() &&
               !std::next(said)->starts_with("--");
    };
    const auto again = std::ranges::find_if(own, isAgain);
    return again == own.end() ? nullptr : &*again;
}

/// The file's stem, short enough for any file system.
std::string plainStem(const std::string& path) {
    std::string stem = slug(pathText(std::filesystem::path(path).stem()));
    stem.resize(std::min(stem.size(), kLongestStem));
    return stem;
}

/// Every field in order, empty.
OrderedJson noFigures(const char* status) {
    OrderedJson figures;
    figures["status"] = status;
    for (const char* field :
         {"error", "pieces", "failed_pieces", "triangles", "seams", "worst_seam_mm", "strain_mean",
          "strain_max", "flipped", "crossings", "fingerprint"}) {
        figures[field] = nullptr;
    }
    for (const char* list : {"doubts", "notes", "outputs"}) {
        figures[list] = OrderedJson::array();
    }
    return figures;
}

/// Mean (by area) and largest strain as fractions, and counts of faults.
void addStrain(OrderedJson& figures, const PieceResults& results) {
    double area = 0, strain = 0, most = 0;
    int flipped = 0, crossings = 0;
    for (const auto& result : results) {
        if (!result->quality) {
            continue;
        }
        const PieceQuality& quality = *result->quality;
        area += quality.area3d;
        strain += quality.area3d * quality.strainMeanAbs.value_or(0);
        most = std::max({most, std::abs(quality.strainMin.value_or(0)),
                         std::abs(quality.strainMax.value_or(0))});
        flipped += quality.flippedTriangles;
        crossings += quality.outlineCrossings;
    }
    if (area > 0) {
        figures["strain_mean"] = number(strain / area);
        figures["strain_max"] = number(most);
        figures["flipped"] = flipped;
        figures["crossings"] = crossings;
    }
}

/// A hash of all flat points, to compare two runs without their files.
std::string fingerprintOf(const PieceResults& results) {
    std::string each;
    for (const auto& result : results) {
        each += hashText(result->fingerprint);
    }
    return hashText(contentHash(each));
}

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kBetweenLooks{100};

Error cannotWrite(const fs::path& folder, const std::error_code& why) {
    return {ErrorCode::FileUnwritable, Subject::file(pathText(folder)), why.message()};
}

/// Whether the folder's name still refers to the open folder.
bool isStill(int open, const fs::path& folder) {
    struct stat held {};
    struct stat named {};
    return fstat(open, &held) == 0 && stat(folder.c_str(), &named) == 0 &&
           held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

}  // namespace

Result<BatchLines> readBatchList(const std::filesystem::path& list) {
    std::string text;
    if (list == "-") {
        text.assign(std::istreambuf_iterator<char>(std::cin), {});
    } else {
        auto bytes = readFile(list);
        if (!bytes) {
            return bytes.error();
        }
        text = std::move(*bytes);
    }
    BatchLines lines;
    text.erase(0, text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
    for (std::string line : partsOf(text, '\n')) {
        if (line.ends_with('\r')) {
            line.pop_back();
        }
        if (trimmed(line).empty() || trimmed(line).front() == '#') {
            continue;
        }
        std::vector<std::string> words = partsOf(line, '\t');
        std::erase_if(words, [](const std::string& word) { return trimmed(word).empty(); });
        const std::string path = words.front();
        words.erase(words.begin());
        lines.emplace_back(path, std::move(words));
    }
    return lines;
}

bool isNoBatchList(const std::filesystem::path& list, const BatchLines& lines) {
    return looksLikeGarment(list) ||
           (!lines.empty() && std::ranges::none_of(lines, [](const auto& line) {
               std::error_code ignored;
               return looksLikeGarment(line.first) ||
                      std::filesystem::is_regular_file(line.first, ignored);
           }));
}

BatchEntry batchEntry(const BatchArguments& batch, const std::string& path,
                      const std::vector<std::string>& ownWords) {
    BatchEntry entry{.path = path, .words = batch.words};
    entry.words.insert(entry.words.end(), ownWords.begin(), ownWords.end());
    entry.arguments = typedWords("flatten", {path}, entry.words,
                                 kInputFiles | kReading | kFlattening | kExporting);
    if (const std::string* again = repeatedOption(batch.words, ownWords)) {
        entry.arguments =
            usageRefusal(*again + " is set for all garments already; leave it out here");
    }
    if (entry.arguments) {
        entry.arguments->threads = batch.threads;
    }
    return entry;
}

std::string hashOfContent(const BatchEntry& entry) {
    Messages ignored;  // reported when the garment is flattened
    const auto arguments =
        entry.arguments ? withProject(*entry.arguments, ignored) : entry.arguments;
    std::vector<std::filesystem::path> files;
    if (!arguments || arguments->project) {  // its inputs are its meshes
        files.emplace_back(entry.path);
    }
    if (arguments) {
        files.insert(files.end(), arguments->inputs.begin(), arguments->inputs.end());
        if (!arguments->seams.empty()) {
            files.push_back(arguments->seams);
        }
    }
    return hashOfFiles(files);
}

void identify(BatchEntry& entry, const BatchArguments& batch, const std::string& hash) {
    entry.inputHash = hash;
    // Use the path if the content cannot be read.
    const std::string content =
        (hash.empty() ? entry.path : hash) + '\n' + joinedWords(entry.words);
    entry.name = plainStem(entry.path) + '-' + hashText(contentHash(content)).substr(6);
    entry.key = hashText(
        contentHash(content + '\n' + joinedWords(batch.formats) + '\n' + std::string(version())));
}

OrderedJson failedFigures(const Refusal& why) {
    OrderedJson figures = noFigures(kBatchFailed);
    figures["error"] = refusalJson(why);
    return figures;
}

OrderedJson figuresOf(const Garment& garment, const PieceResults& results,
                      const std::vector<Fabric>& fabrics) {
    OrderedJson figures = noFigures(kBatchDone);
    long long triangles = 0;
    int failed = 0;
    const auto fail = [&figures](const Refusal& why) {
        figures["status"] = kBatchSomeFailed;
        figures["error"] = figures["error"].is_null() ? refusalJson(why) : figures["error"];
    };
    for (const auto& result : results) {
        triangles += result->piece->mesh.F.rows();
        if (result->error && !isLeftOut(*result)) {
            ++failed;
            fail(*result->error);
        } else if (breaksPromise(*result)) {
            ++failed;
            fail({std::string(name(ErrorCode::TrianglesFlipped)),
                  std::string(describe(ErrorCode::TrianglesFlipped)), result->piece->name});
        }
    }
    for (const Error& problem : garment.problems) {
        if (!isNote(problem.code)) {
            fail(problem);
        }
    }
    figures["pieces"] = results.size();
    figures["failed_pieces"] = failed;
    figures["triangles"] = triangles;
    const std::vector<MeasuredSeam> seams = seamsByError(garment, results);
    figures["seams"] = seams.size();
    if (!seams.empty()) {
        figures["worst_seam_mm"] = number(std::abs(seams.front().measure.errorMm));
    }
    addStrain(figures, results);
    figures["fingerprint"] = fingerprintOf(results);
    const auto doubts = findDoubts(garment, results, fabrics);
    for (const Finding& doubt : doubts) {
        figures["doubts"].push_back(name(doubt.kind));
        if (doubt.severity == Severity::Fault) {
            fail({std::string(name(doubt.kind)), sentence(doubt), doubt.subject.name});
        }
    }
    if (hasFaults(garment, results, doubts) && figures["error"].is_null()) {
        const bool crosses = std::ranges::any_of(results, [](const auto& result) {
            return result->quality && result->quality->outlineCrossings > 0;
        });
        const ErrorCode code = crosses ? ErrorCode::OutlineCrosses : ErrorCode::TrianglesFlipped;
        fail({std::string(name(code)), std::string(describe(code))});
    }
    return figures;
}

std::string recordLine(const BatchEntry& entry, const OrderedJson& figures, const BatchCost& cost) {
    OrderedJson record;
    record["name"] = entry.name;
    record["input"] = text(entry.path);
    record["hash"] = textOrNull(entry.inputHash);
    record["options"] = OrderedJson::array();
    for (const std::string& word : entry.words) {
        record["options"].push_back(text(word));
    }
    record["toile"] = text(version());
    record["key"] = entry.key;
    record.update(figures);
    record["cost"] = {{"wall_s", number(cost.wallSeconds)},
                      {"processor_s", number(cost.processorSeconds)},
                      {"peak_mib", number(cost.peakMib)}};
    return record.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

std::string recordLineOf(std::string_view input, std::string_view line) {
    OrderedJson record = OrderedJson::parse(line, nullptr, false);
    if (!record.is_object()) {
        return std::string(line);
    }
    record["input"] = text(input);
    return record.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

RecordHead headOf(std::string_view line) {
    const OrderedJson record = OrderedJson::parse(line, nullptr, false);
    RecordHead head;
    const auto word = [](const OrderedJson& in, const char* field) {
        const auto found = in.find(field);
        return found != in.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    if (!record.is_object() || !record.contains("error") || !record.contains("outputs")) {
        return head;
    }
    head.key = word(record, "key");
    head.status = word(record, "status");
    if (record["error"].is_object()) {
        head.code = word(record["error"], "code");
        head.message = word(record["error"], "message");
        head.isRetryable = record["error"].value("again", OrderedJson()) == true;
    }
    for (const OrderedJson& output : record["outputs"]) {
        head.outputs.push_back(output.is_string() ? output.get<std::string>() : std::string());
    }
    return head;
}

BatchFolder::BatchFolder(const fs::path& parent, const std::string& name)
    : folder_(parent / name), part_(parent / (name + ".part")) {}

BatchFolder::~BatchFolder() {
    if (lock_ >= 0) {  // not finished
        std::error_code ignored;
        fs::remove_all(part_, ignored);
        release();
    }
}

void BatchFolder::release() {
    close(lock_);
    lock_ = -1;
}

std::string BatchFolder::finished(const std::string& key) const {
    auto line = readFile(folder_ / kBatchRecord);
    if (!line) {
        return {};
    }
    const RecordHead head = headOf(*line);
    const bool isThere = std::ranges::all_of(head.outputs, [this](const std::string& output) {
        std::error_code ignored;
        return fs::exists(folder_ / output, ignored);
    });
    return head.key == key && isThere && !head.isRetryable ? std::move(*line) : std::string();
}

Result<bool> BatchFolder::claim(const std::function<bool()>& isEnough) {
    while (!isEnough()) {
        std::error_code trouble;
        fs::create_directories(part_, trouble);
        if (trouble) {
            return cannotWrite(part_, trouble);
        }
        lock_ = open(part_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (lock_ < 0 && errno == ENOENT) {
            continue;  // another process has just renamed it
        }
        if (lock_ < 0) {
            return cannotWrite(part_, {errno, std::generic_category()});
        }
        const int fault = flock(lock_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
        if (fault == 0 && isStill(lock_, part_)) {
            return true;
        }
        release();
        if (fault == EWOULDBLOCK) {
            std::this_thread::sleep_for(kBetweenLooks);
        } else if (fault != 0 && fault != EINTR) {
            return cannotWrite(part_, {fault, std::generic_category()});  // no locks
        }
    }
    return false;
}

Result<void> BatchFolder::clear() const {
    std::error_code trouble;
    for (const fs::directory_entry& left : fs::directory_iterator(part_, trouble)) {
        fs::remove_all(left.path(), trouble);
    }
    return trouble ? Result<void>(cannotWrite(part_, trouble)) : Result<void>();
}

Result<void> BatchFolder::finish(const std::string& record) {
    if (auto written = writeFile(part_ / kBatchRecord, record); !written) {
        return written;
    }
    std::error_code trouble;
    fs::remove_all(folder_, trouble);  // of another version, or to be retried
    fs::rename(part_, folder_, trouble);
    if (trouble) {
        return cannotWrite(folder_, trouble);
    }
    release();
    return {};
}

}  // namespace toile::app
