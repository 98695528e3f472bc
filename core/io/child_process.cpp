// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/child_process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace toile::io {
namespace {

constexpr int kExitOutOfMemory = 2;
constexpr int kMaxInherited = 1024;  // of open files, the usual limit

/// Address space in use; a sanitizer has terabytes of it.
rlim_t bytesNow() {
    std::ifstream sizes("/proc/self/statm");
    rlim_t pages = 0;
    sizes >> pages;
    return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource_t resource, rlim_t soft, rlim_t hard) {
    const rlimit bound{soft, hard};
    setrlimit(resource, &bound);
}

/// Runs the child. `out` is the end of the pipe that it writes to.
[[noreturn]] void runAndExit(const std::function<std::string()>& work, const ChildLimits& limits,
                             pid_t parent, int out) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) {
        _exit(1);
    }
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGPIPE}) {
        std::signal(signal, SIG_DFL);
    }
    const auto seconds = static_cast<rlim_t>(limits.seconds);
    const rlim_t memory = bytesNow() + limits.memory;
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);  // no file can grow; pipes are not affected
    limit(RLIMIT_CPU, seconds, seconds + 1);
    limit(RLIMIT_AS, memory, memory);
    for (int file = STDERR_FILENO + 1; file < kMaxInherited; ++file) {
        if (file != out) {
            close(file);  // also pipes of other children, which end when all copies are closed
        }
    }
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    try {
        const std::string bytes = work();
        std::FILE* const pipe = fdopen(out, "w");
        const bool isWritten = std::fwrite(bytes.data(), 1, bytes.size(), pipe) == bytes.size();
        _exit(isWritten && std::fclose(pipe) == 0 ? 0 : 1);
    } catch (const std::bad_alloc&) {
        _exit(kExitOutOfMemory);
    } catch (...) {
        _exit(1);
    }
}

/// How the child ended, from the status that waitpid gives.
ChildEnd endOf(int status) {
    if (WIFEXITED(status)) {
        return WEXITSTATUS(status) == 0                  ? ChildEnd::Finished
               : WEXITSTATUS(status) == kExitOutOfMemory ? ChildEnd::BeyondLimits
                                                         : ChildEnd::Crashed;
    }
    return WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)
               ? ChildEnd::BeyondLimits
               : ChildEnd::Crashed;
}

}  // namespace

ChildResult runInChild(const std::function<std::string()>& work, const ChildLimits& limits,
                       const Progress& progress) {
    constexpr int kPollMilliseconds = 5;
    // In case the child waits instead of computing; allows for other work on the machine.
    const auto deadline =
        std::chrono::steady_clock::now() + std::chrono::seconds(4 * limits.seconds);
    ChildResult result;
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) {
        return result;
    }
    const pid_t parent = getpid(), child = fork();
    if (child == 0) {
        close(ends[0]);
        runAndExit(work, limits, parent, ends[1]);
    }
    close(ends[1]);
    std::string chunk(std::size_t{1} << 16U, '\0');
    std::optional<ChildEnd> killedFor;
    for (bool isOpen = child > 0; isOpen && !killedFor;) {
        pollfd look{ends[0], POLLIN, 0};
        if (poll(&look, 1, kPollMilliseconds) > 0) {
            const ssize_t count = read(ends[0], chunk.data(), chunk.size());
            isOpen = count > 0 || (count < 0 && errno == EINTR);
            result.output.append(chunk, 0, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        }
        const bool isBeyond =
            result.output.size() > limits.memory || std::chrono::steady_clock::now() > deadline;
        killedFor = progress.isCancelled() ? std::optional(ChildEnd::Cancelled)
                    : isBeyond             ? std::optional(ChildEnd::BeyondLimits)
                                           : std::nullopt;
    }
    close(ends[0]);
    if (child <= 0) {
        return result;
    }
    if (killedFor) {
        kill(child, SIGKILL);
    }
    int status = 0;
    pid_t ended = -1;
    do {
        ended = waitpid(child, &status, 0);
    } while (ended < 0 && errno == EINTR);
    result.end = killedFor        ? *killedFor
                 : ended == child ? endOf(status)
                                  : ChildEnd::Finished;  // another caller has reaped it
    return result;
}

namespace {

/// Writes lists of numbers to bytes, or reads them back in the same order.
class Stream {
public:
    Stream() : isWriting_(true) {}
    explicit Stream(std::string_view bytes) : isWriting_(false), rest_(bytes) {}

    /// A string, or a vector of numbers or points.
    template <class List>
    void list(List& items) {
        std::uint64_t count = items.size();
        raw(&count, sizeof count);
        if (!isWriting_) {
            failed_ = failed_ || count > rest_.size() / sizeof(items[0]);
            items.resize(failed_ ? 0 : count);
        }
        raw(items.data(), items.size() * sizeof(items[0]));
    }

    void texts(std::vector<std::string>& items) {
        std::vector<char> each(items.size());  // bounds the count by the bytes that follow
        list(each);
        items.resize(each.size());
        for (std::string& item : items) {
            list(item);
        }
    }

    bool isComplete() const { return !failed_ && rest_.empty(); }
    std::string take() { return std::move(out_); }

private:
    void raw(void* data, std::size_t size) {
        if (isWriting_) {
            out_.append(static_cast<const char*>(data), size);
        } else if (failed_ || size > rest_.size()) {
            failed_ = true;
        } else if (size > 0) {
            std::memcpy(data, rest_.data(), size);
            rest_.remove_prefix(size);
        }
    }

    bool isWriting_, failed_ = false;
    std::string out_;
    std::string_view rest_;
};

/// Exchanges a soup. The errors are its problems, or the one error instead of it.
void exchange(Stream& stream, PolygonSoup& soup, Problems& errors) {
    std::vector<int> codes, units, axes;
    if (soup.statedUnit) {
        units.push_back(static_cast<int>(soup.statedUnit->unit));
    }
    if (soup.statedUp) {
        axes.push_back(static_cast<int>(soup.statedUp->axis));
    }
    std::vector<std::string> texts;
    for (const Error& error : errors) {
        codes.push_back(static_cast<int>(error.code));
        texts.push_back(error.detail);
    }
    stream.list(soup.positions);
    stream.list(soup.uvs);
    for (auto* list : {&soup.faceStart, &soup.corners, &soup.cornerUvs, &soup.faceObject,
                       &soup.faceMaterial, &codes, &units, &axes}) {
        stream.list(*list);
    }
    for (auto* list : {&soup.objects, &soup.materials, &texts}) {
        stream.texts(*list);
    }
    if (units.size() == 1 && units[0] >= 0 &&
        units[0] < static_cast<int>(std::size(kLengthUnits))) {
        soup.statedUnit = StatedUnit{static_cast<LengthUnit>(units[0]), {}};
    }
    if (axes.size() == 1) {
        soup.statedUp =
            StatedUp{axes[0] == static_cast<int>(UpAxis::Z) ? UpAxis::Z : UpAxis::Y, {}};
    }
    errors.clear();
    for (std::size_t k = 0; k < std::min(codes.size(), texts.size()); ++k) {
        errors.push_back(
            {static_cast<ErrorCode>(std::clamp(codes[k], 0, kErrorCodeCount - 1)), {}, texts[k]});
    }
}

bool areIn(const std::vector<int>& indices, int least, std::size_t count) {
    return std::ranges::all_of(
        indices, [&](int index) { return index >= least && index < static_cast<int>(count); });
}

bool keepsPromises(const PolygonSoup& soup) {
    const auto isPerFace = [&soup](const std::vector<int>& list) {
        return list.empty() || std::ssize(list) == soup.faceCount();
    };
    return !soup.faceStart.empty() && soup.faceStart.front() == 0 &&
           std::ranges::is_sorted(soup.faceStart) &&
           soup.faceStart.back() == std::ssize(soup.corners) &&
           areIn(soup.corners, 0, soup.positions.size()) &&
           areIn(soup.cornerUvs, -1, soup.uvs.size()) &&
           (soup.cornerUvs.empty() || soup.cornerUvs.size() == soup.corners.size()) &&
           isPerFace(soup.faceObject) && isPerFace(soup.faceMaterial) &&
           areIn(soup.faceObject, -1, soup.objects.size()) &&
           areIn(soup.faceMaterial, -1, soup.materials.size());
}

}  // namespace

std::string packedSoup(Result<PolygonSoup> soup) {
    PolygonSoup none;
    none.faceStart.clear();
    Problems errors = soup ? soup->problems : Problems{soup.error()};
    Stream stream;
    exchange(stream, soup ? *soup : none, errors);
    return stream.take();
}

Result<PolygonSoup> unpackedSoup(std::string_view bytes, const std::string& name) {
    Stream stream(bytes);
    PolygonSoup soup;
    exchange(stream, soup, soup.problems);
    for (Error& problem : soup.problems) {
        problem.subject = Subject::file(name);
    }
    if (stream.isComplete() && soup.faceStart.empty() && !soup.problems.empty()) {
        return soup.problems.front();
    }
    if (!stream.isComplete() || !keepsPromises(soup)) {
        return Error{ErrorCode::MalformedFile, Subject::file(name)};
    }
    return soup;
}

}  // namespace toile::io
