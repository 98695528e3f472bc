// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/machine.h"

#include <fstream>
#include <string>
#include <thread>

#include <Eigen/Core>
#include <OpenMesh/Core/System/config.h>
#include <benchmark/benchmark.h>
#include <cholmod.h>

#include "core/base/text.h"
#include "core/base/version.h"

#ifdef __ELF__
// Present where OpenBLAS stands in for the BLAS; declared weak because they need not.
extern "C" const char* openblas_get_config() __attribute__((weak));
extern "C" const char* openblas_get_corename() __attribute__((weak));
#else
static const char* (*const openblas_get_config)() = nullptr;
static const char* (*const openblas_get_corename)() = nullptr;
#endif

namespace toile::bench {
namespace {

/// What follows `key` and a colon in one of Linux's lists; "unknown" elsewhere.
std::string fromList(const char* path, const std::string& key) {
    std::ifstream list(path);
    for (std::string line; std::getline(list, line);) {
        const std::size_t colon = line.find(':');
        if (line.starts_with(key) && colon != line.npos) {
            const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
            return begin == line.npos ? "unknown" : line.substr(begin);
        }
    }
    return "unknown";
}

std::string memory() {
    const std::string kibibytes = fromList("/proc/meminfo", "MemTotal");
    return kibibytes == "unknown" ? kibibytes
                                  : fixed(std::stod(kibibytes) / (1024.0 * 1024.0), 1) + " GiB";
}

std::string versionOf(std::initializer_list<int> numbers) {
    std::string text;
    for (const int number : numbers) {
        text += (text.empty() ? "" : ".") + std::to_string(number);
    }
    return text;
}

std::string blas() {
    if (openblas_get_config == nullptr || openblas_get_corename == nullptr) {
        return "not OpenBLAS";
    }
    const std::string config = openblas_get_config();  // "OpenBLAS 0.3.21 NO_LAPACKE ..."
    return config.substr(0, config.find(' ', config.find(' ') + 1)) + ", kernels for " +
           openblas_get_corename();
}

std::string compiler() {
#if defined(__clang__)
    return "Clang " __clang_version__;
#elif defined(__GNUC__)
    return "GCC " __VERSION__;
#else
    return "unknown";
#endif
}

}  // namespace

void describeMachine() {
    using benchmark::AddCustomContext;
    AddCustomContext("processor", fromList("/proc/cpuinfo", "model name"));
    AddCustomContext("cores", std::to_string(std::thread::hardware_concurrency()));
    AddCustomContext("memory", memory());
    AddCustomContext("compiler", compiler());
    AddCustomContext(
        "CHOLMOD", versionOf({CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION}));
    AddCustomContext("SuiteSparse", versionOf({SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION,
                                               SUITESPARSE_SUBSUB_VERSION}));
    AddCustomContext("BLAS", blas());
    AddCustomContext("Eigen",
                     versionOf({EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION}));
    AddCustomContext("OpenMesh",
                     versionOf({(OM_VERSION & 0xf0000) >> 16, (OM_VERSION & 0xff00) >> 8}));
    AddCustomContext("Toile", std::string(version()));
}

}  // namespace toile::bench
