// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/tried_apart.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace toile::io {
namespace {

/// What it may take beyond what the program has.
constexpr rlim_t kMostBytes = rlim_t{6} << 30U;

/// Of addresses: a sanitizer has terabytes of them.
rlim_t bytesNow() {
    std::ifstream sizes("/proc/self/statm");
    rlim_t pages = 0;
    sizes >> pages;
    return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource_t resource, rlim_t most) {
    const rlimit bound{most, most};
    setrlimit(resource, &bound);
}

/// In the new process: it says nothing, leaves no picture of its memory and ends after its time.
[[noreturn]] void runAndEnd(const std::function<bool()>& work, int seconds, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // it outlives nobody
    if (getppid() != parent) {
        _exit(1);
    }
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) {
        std::signal(signal, SIG_DFL);
    }
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(seconds));
    limit(RLIMIT_AS, bytesNow() + kMostBytes);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    try {
        _exit(work() ? 0 : 1);
    } catch (...) {
        _exit(1);
    }
}

}  // namespace

Trial triedApart(const std::function<bool()>& work, int seconds, const Progress& progress) {
    constexpr auto kBetweenLooks = std::chrono::milliseconds(2);
    // For one that waits instead of computing, on a machine with other work.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(4 * seconds);
    const pid_t parent = getpid(), child = fork();
    if (child == 0) {
        runAndEnd(work, seconds, parent);
    }
    int status = 0;
    for (bool isCancelled = false; child > 0;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child) {
            return isCancelled                                     ? Trial::Cancelled
                   : WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Trial::Returns
                                                                   : Trial::Dies;
        }
        if (ended < 0 && errno != EINTR) {
            break;  // somebody else has waited for it
        }
        if (!isCancelled && progress.isCancelled()) {
            isCancelled = true;
            kill(child, SIGKILL);
        }
        if (std::chrono::steady_clock::now() > deadline) {
            kill(child, SIGKILL);
        }
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return Trial::Returns;
}

}  // namespace toile::io
