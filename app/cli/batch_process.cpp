// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/cli/batch.h"

namespace toile::app {
namespace {

constexpr double kKibPerMib = 1024;
constexpr double kMicrosecondsPerSecond = 1e6;
constexpr double kMillisecondsPerBatchSecond = 1e3;
constexpr int kLongestPoll = 3'600'000;  // ms; then poll again
constexpr int kTakenSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGCHLD};

volatile std::sig_atomic_t receivedSignal = 0;
int signalPipe[2] = {-1, -1};

/// May run on any thread: OpenBLAS has some, so signals cannot be blocked and waited for.
void takeNote(int signal) {
    const int before = errno;
    if (signal != SIGCHLD) {
        receivedSignal = signal;
    }
    [[maybe_unused]] const auto written = ::write(signalPipe[1], "", 1);
    errno = before;
}

/// Keeps signals ignored that were ignored at startup, as by nohup.
void answerAll(void (*answer)(int)) {
    for (const int signal : kTakenSignals) {
        struct sigaction action {};
        sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_IGN && signal != SIGCHLD) {
            continue;
        }
        action = {};
        action.sa_handler = answer;
        sigaction(signal, &action, nullptr);
    }
}

[[noreturn]] void runAsChild(const std::function<int()>& work, const ProcessLimits& limits,
                             pid_t parent) {
    answerAll(SIG_DFL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent) {
        _exit(1);
    }
    if (limits.memoryMib > 0) {
        limitMemory(limits.memoryMib, limits.threads);
    }
    _exit(work());
}

double secondsOf(const timeval& time) {
    return static_cast<double>(time.tv_sec) +
           static_cast<double>(time.tv_usec) / kMicrosecondsPerSecond;
}

constexpr rlim_t kBytesPerMib = rlim_t{1} << 20U;
/// OpenBLAS's buffer per calling thread, plus the reserve of core/linalg.
constexpr rlim_t kBlasBytes = 144 * kBytesPerMib;
constexpr rlim_t kUsualStack = 8 * kBytesPerMib;

/// Memory of this process as counted by RLIMIT_DATA, including the program's own data.
rlim_t dataBytes() {
    std::ifstream sizes("/proc/self/statm");  // in pages; the sixth field is data and stack
    rlim_t pages = 0;
    for (int field = 0; field < 6; ++field) {
        sizes >> pages;
    }
    return sizes ? pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

rlim_t stackBytes() {
    rlimit stack{};
    getrlimit(RLIMIT_STACK, &stack);
    return stack.rlim_cur == RLIM_INFINITY ? kUsualStack : stack.rlim_cur;
}

void setMemoryLimit(rlim_t bytes) {
    rlimit limit{};
    getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = std::min(bytes, limit.rlim_max);
    setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace

BatchSignals::BatchSignals() {
    receivedSignal = 0;
    if (pipe(signalPipe) == 0) {
        for (const int end : signalPipe) {
            fcntl(end, F_SETFL, O_NONBLOCK);
            fcntl(end, F_SETFD, FD_CLOEXEC);
        }
    }
    answerAll(takeNote);
}

BatchSignals::~BatchSignals() {
    answerAll(SIG_DFL);
    close(signalPipe[0]);
    close(signalPipe[1]);
}

int BatchSignals::received() {
    return receivedSignal;
}

void BatchSignals::wait(double seconds) {
    pollfd input{signalPipe[0], POLLIN, 0};
    const double milliseconds = std::ceil(seconds * kMillisecondsPerBatchSecond);
    poll(&input, 1,
         milliseconds < 0 || milliseconds > kLongestPoll ? kLongestPoll
                                                         : static_cast<int>(milliseconds));
    char taken[64];
    while (::read(signalPipe[0], taken, sizeof taken) > 0) {
    }
}

ProcessEnd inOwnProcess(const std::function<int()>& work, const ProcessLimits& limits) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto passed = [&start] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    const pid_t self = getpid();
    const pid_t child = fork();
    if (child == 0) {
        runAsChild(work, limits, self);
    }
    ProcessEnd end;
    if (child < 0) {
        end.signal = -1;
        return end;
    }
    int state = 0;
    rusage used{};
    while (wait4(child, &state, WNOHANG, &used) == 0) {
        end.isInterrupted = BatchSignals::received() != 0;
        end.isTimedOut = !end.isInterrupted && limits.seconds > 0 && passed() >= limits.seconds;
        if (end.isInterrupted || end.isTimedOut) {
            kill(child, SIGKILL);
            wait4(child, &state, 0, &used);
            break;
        }
        BatchSignals::wait(limits.seconds > 0 ? limits.seconds - passed() : -1);
    }
    end.signal = WIFSIGNALED(state) ? WTERMSIG(state) : 0;
    // Ctrl-C reaches both processes, and the child may end first.
    end.isInterrupted = end.isInterrupted || (end.signal != 0 && BatchSignals::received() != 0);
    end.status = WIFEXITED(state) ? WEXITSTATUS(state) : 0;
    end.cost = {passed(), secondsOf(used.ru_utime) + secondsOf(used.ru_stime),
                static_cast<double>(used.ru_maxrss) / kKibPerMib};
    return end;
}

ProcessEnd textOfOwnProcess(const std::function<std::string()>& work, const ProcessLimits& limits,
                            std::string& text) {
    text.clear();
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) {
        return {.signal = -1};
    }
    const ProcessEnd end = inOwnProcess(
        [&] {
            const std::string found = work();
            return ::write(ends[1], found.data(), found.size()) < 0 ? 1 : 0;
        },
        limits);
    close(ends[1]);
    char block[256];
    for (ssize_t taken = 0; (taken = ::read(ends[0], block, sizeof block)) > 0;) {
        text.append(block, static_cast<std::size_t>(taken));
    }
    close(ends[0]);
    return end;
}

void limitMemory(int mib, int threads) {
    const auto working = static_cast<rlim_t>(threads);
    const rlim_t stacks = (working + std::thread::hardware_concurrency()) * stackBytes();
    setMemoryLimit(dataBytes() + stacks + working * kBlasBytes +
                   static_cast<rlim_t>(mib) * kBytesPerMib);
}

void liftMemoryLimit() {
    setMemoryLimit(RLIM_INFINITY);
}

}  // namespace toile::app
