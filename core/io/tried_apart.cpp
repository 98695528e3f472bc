// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/tried_apart.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace toile::io {
namespace {

void limit(__rlimit_resource_t resource, rlim_t most) {
    const rlimit bound{most, most};
    setrlimit(resource, &bound);
}

/// In the new process: it says nothing, leaves no picture of its memory and ends after its time.
[[noreturn]] void runAndEnd(const std::function<void()>& work, int seconds) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) {
        std::signal(signal, SIG_DFL);
    }
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(seconds));
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    try {
        work();
    } catch (...) {
        _exit(1);
    }
    _exit(0);
}

}  // namespace

Trial triedApart(const std::function<void()>& work, int seconds, const Progress& progress) {
    constexpr auto kBetweenLooks = std::chrono::milliseconds(2);
    const pid_t child = fork();
    if (child == 0) {
        runAndEnd(work, seconds);
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
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return Trial::Returns;
}

}  // namespace toile::io
