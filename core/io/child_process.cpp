// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/child_process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <new>
#include <optional>

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

}  // namespace toile::io
