// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace toile::sew {

/// Does work(0) ... work(count - 1), each once, in stretches on several threads. What one does
/// must not depend on another, and must not throw: then it leaves no trace how many there were.
template <class Work>
void sideBySide(int threads, std::size_t count, const Work& work) {
    constexpr std::size_t kLeast = 500;  // for less no thread is worth its start
    const std::size_t most = count / kLeast;
    const std::size_t parts =
        threads > 1 && most > 1 ? std::min(static_cast<std::size_t>(threads), most) : 1;
    const auto stretch = [&](std::size_t part) {
        for (std::size_t i = count * part / parts; i < count * (part + 1) / parts; ++i) {
            work(i);
        }
    };
    std::vector<std::thread> others;
    others.reserve(parts);
    std::size_t mine = 1;  // from here on nobody else does them
    try {
        for (; mine < parts; ++mine) {
            others.emplace_back(stretch, mine);
        }
    } catch (const std::system_error&) {  // the system has no more threads
    }
    stretch(0);
    for (; mine < parts; ++mine) {
        stretch(mine);
    }
    for (std::thread& other : others) {
        other.join();
    }
}

}  // namespace toile::sew
