// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/blas_call.h"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

// Present if OpenBLAS provides the BLAS; weak because it may not.
// NOLINTBEGIN(readability-identifier-naming): OpenBLAS names them
#ifdef __ELF__
extern "C" {
int openblas_get_num_threads() __attribute__((weak));
void openblas_set_num_threads(int count) __attribute__((weak));
/// Allocates the first of its unused working buffers.
void* blas_memory_alloc(int) __attribute__((weak));
void blas_memory_free(void* buffer) __attribute__((weak));
}
#else
static int (*const openblas_get_num_threads)() = nullptr;
static void (*const openblas_set_num_threads)(int) = nullptr;
static void* (*const blas_memory_alloc)(int) = nullptr;
static void (*const blas_memory_free)(void*) = nullptr;
#endif
// NOLINTEND(readability-identifier-naming)

namespace toile::linalg {
namespace {

constexpr std::size_t kBuffer = std::size_t{128} << 20U;  ///< size of one of OpenBLAS's, on x86-64
constexpr std::size_t kBeside = std::size_t{16} << 20U;   ///< for everything else meanwhile

std::mutex blasMutex;
int blasCalling = 0;             ///< threads that may call now
int blasWithRoom = 0;            ///< limit of those that have buffers at the same time
std::vector<void*> blasBuffers;  ///< those that OpenBLAS is known to have

/// Touches no memory. Maps writable memory: only that counts for RLIMIT_DATA.
bool hasRoomFor(std::size_t buffers) {
#ifdef __linux__
    const std::size_t size = buffers * kBuffer + kBeside;
    void* const room = mmap(nullptr, size, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return room != MAP_FAILED && munmap(room, size) == 0;
#else
    return buffers > 0;
#endif
}

/// Holds buffers until OpenBLAS has one more than known. Threads that call meanwhile may each need
/// one more for those held here.
bool takeOneMoreBuffer() {
    if (blas_memory_alloc == nullptr || blas_memory_free == nullptr) {
        return hasRoomFor(1);
    }
    const std::size_t known = blasBuffers.size();
    std::vector<void*> held;
    held.reserve(known + 1);
    blasBuffers.reserve(known + 1);
    while (blasBuffers.size() == known && hasRoomFor(held.size() + 1)) {
        void* const buffer = blas_memory_alloc(0);
        if (buffer == nullptr) {
            break;
        }
        held.push_back(buffer);
        if (std::ranges::find(blasBuffers, buffer) == blasBuffers.end()) {
            blasBuffers.push_back(buffer);
        }
    }
    std::ranges::for_each(held, blas_memory_free);
    return blasBuffers.size() > known;
}

}  // namespace

BlasCall::BlasCall(int threads) {
    const std::lock_guard lock(blasMutex);
    while (blasWithRoom < blasCalling + threads && takeOneMoreBuffer()) {
        ++blasWithRoom;
    }
    room_ = std::clamp(blasWithRoom - blasCalling, 0, threads);
    blasCalling += room_;
}

BlasCall::~BlasCall() {
    const std::lock_guard lock(blasMutex);
    blasCalling -= room_;
}

void useOneBlasThread() {
    if (openblas_set_num_threads != nullptr &&
        (openblas_get_num_threads == nullptr || openblas_get_num_threads() != 1)) {
        openblas_set_num_threads(1);
    }
}

}  // namespace toile::linalg
