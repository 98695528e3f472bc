// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace toile::nest {

/// A random generator with the same numbers on every platform (SplitMix64), unlike the
/// distributions of the standard library.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// A different stream for each triple of numbers.
    Random(std::uint64_t seed, std::uint64_t a, std::uint64_t b) : state_(seed) {
        state_ = next() ^ (a * 0xd1342543de82ef95u);
        state_ = next() ^ (b * 0xda942042e4dd58b5u);
    }

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + share() * (high - low); }
    /// A number from 0 to count - 1; count > 0.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

private:
    std::uint64_t state_;
};

}  // namespace toile::nest
