// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program and prints the most memory it held at a time, in MiB, to standard output:
//     toile_bench_peak_memory PROGRAM [ARGUMENT...]
// A program of its own: the kernel counts what the parent held at the fork to the child, so that
// the parent must be small.
#include <cstdio>

#ifdef __linux__
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s PROGRAM [ARGUMENT...]\n", argv[0]);
        return 2;
    }
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        execv(argv[1], argv + 1);
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) ||
        WEXITSTATUS(status) != 0) {
        std::fprintf(stderr, "%s did not end well\n", argv[1]);
        return 1;
    }
    std::printf("%.1f\n", static_cast<double>(usage.ru_maxrss) / 1024);  // KiB on Linux
    return 0;
}
#else
int main() {
    std::fprintf(stderr, "peak memory is measured on Linux only\n");
    return 1;
}
#endif
