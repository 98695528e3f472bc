// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/blas_kernels.h"

#include <cstdlib>
#include <string_view>

// Present where OpenBLAS stands in for the BLAS; declared weak because they need not.
#ifdef __ELF__
extern "C" {
void openblas_set_num_threads(int count) __attribute__((weak));
const char* openblas_get_corename() __attribute__((weak));
void gotoblas_dynamic_init() __attribute__((weak));
void gotoblas_dynamic_quit() __attribute__((weak));
}
#else
static void (*const openblas_set_num_threads)(int) = nullptr;
static const char* (*const openblas_get_corename)() = nullptr;
static void (*const gotoblas_dynamic_init)() = nullptr;
static void (*const gotoblas_dynamic_quit)() = nullptr;
#endif

namespace toile {
namespace {

constexpr const char* kChoice = "OPENBLAS_CORETYPE";

/// OpenBLAS's name for the best kernels this processor can run; nullptr where nothing is known.
const char* bestKernels() {
#if defined(__GNUC__) && defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
        __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0) {
        return "SkylakeX";
    }
    if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) {
        return "Haswell";
    }
#endif
    return nullptr;
}

/// The kernels OpenBLAS takes where it does not know the processor.
bool hasFallenBack() {
    return openblas_get_corename != nullptr &&
           std::string_view(openblas_get_corename()) == "Prescott";
}

}  // namespace

void chooseBlasKernels() {
    const char* const best = bestKernels();
    if (best == nullptr || !hasFallenBack() || gotoblas_dynamic_init == nullptr ||
        gotoblas_dynamic_quit == nullptr || std::getenv(kChoice) != nullptr) {
        return;
    }
#ifdef __ELF__
    setenv(kChoice, best, 1);
    gotoblas_dynamic_quit();
    gotoblas_dynamic_init();
    unsetenv(kChoice);
#endif
}

void useOneBlasThread() {
    if (openblas_set_num_threads != nullptr) {
        openblas_set_num_threads(1);
    }
}

}  // namespace toile
