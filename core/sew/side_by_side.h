// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace toile::sew {

/// Runs work(first, last) for stretches that cover 0 ... count, on several threads. The work for
/// one number must not depend on others, so that the number of threads does not matter. Rethrows
/// exceptions on the calling thread after all threads have ended.
template <class Work>
void stretchesSideBySide(int threads, std::size_t count, const Work& work) {
    constexpr std::size_t kMinStretch = 500;  // smaller stretches are not worth a thread
    const std::size_t most = count / kMinStretch;
    const std::size_t parts =
        threads > 1 && most > 1 ? std::min(static_cast<std::size_t>(threads), most) : 1;
    std::vector<std::exception_ptr> faults(parts);
    const auto stretch = [&](std::size_t part) {
        try {
            work(count * part / parts, count * (part + 1) / parts);
        } catch (...) {
            faults[part] = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    others.reserve(parts);
    std::size_t mine = 1;  // first stretch without a thread
    try {
        for (; mine < parts; ++mine) {
            others.emplace_back(stretch, mine);
        }
    } catch (const std::exception&) {  // the system has no more threads, or no memory for one
    }
    stretch(0);
    for (; mine < parts; ++mine) {
        stretch(mine);
    }
    for (std::thread& other : others) {
        other.join();
    }
    for (const std::exception_ptr& fault : faults) {
        if (fault) {
            std::rethrow_exception(fault);
        }
    }
}

/// Runs work(0) ... work(count - 1), each once, in such stretches.
template <class Work>
void sideBySide(int threads, std::size_t count, const Work& work) {
    stretchesSideBySide(threads, count, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            work(i);
        }
    });
}

}  // namespace toile::sew
