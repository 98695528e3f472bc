// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/triangle_tree.h"

#include <bit>

namespace toile::geometry {

namespace {

/// Spreads the bits of a number so that each is followed by Dim - 1 zero bits.
template <int Dim>
std::uint32_t spread(std::uint32_t bits) {
    if constexpr (Dim == 2) {
        bits = (bits | bits << 8) & 0x00FF00FFU;
        bits = (bits | bits << 4) & 0x0F0F0F0FU;
        bits = (bits | bits << 2) & 0x33333333U;
        return (bits | bits << 1) & 0x55555555U;
    } else {
        bits = (bits | bits << 16) & 0x030000FFU;
        bits = (bits | bits << 8) & 0x0300F00FU;
        bits = (bits | bits << 4) & 0x030C30C3U;
        return (bits | bits << 2) & 0x09249249U;
    }
}

template <class Box>
Box emptyBox() {
    Box box;
    using Limits = std::numeric_limits<typename decltype(box.low)::value_type>;
    box.low.fill(Limits::max());
    box.high.fill(Limits::lowest());
    return box;
}

template <class Box, class Scalar>
void extend(Box& box, const Scalar* low, const Scalar* high) {
    for (std::size_t k = 0; k < box.low.size(); ++k) {
        box.low[k] = std::min(box.low[k], low[k]);
        box.high[k] = std::max(box.high[k], high[k]);
    }
}

}  // namespace

template <int Dim, class Scalar>
TriangleTree<Dim, Scalar>::TriangleTree(const Scalar* points, std::size_t stride,
                                        std::span<const std::uint32_t> triangles) {
    const std::size_t count = triangles.size() / 3;
    if (count == 0) {
        return;
    }
    const auto corner = [&](std::size_t triangle, std::size_t k) -> const Scalar* {
        return points + triangles[3 * triangle + k] * stride;
    };
    Box all = emptyBox<Box>();
    for (const std::uint32_t index : triangles) {
        extend(all, points + index * stride, points + index * stride);
    }

    constexpr std::uint32_t kCells = (1U << (Dim == 2 ? 16 : 10)) - 1;
    constexpr auto kFarthest = static_cast<Scalar>(kCells);
    std::array<Scalar, Dim> scale;
    for (std::size_t k = 0; k < Dim; ++k) {
        const Scalar size = all.high[k] - all.low[k];
        scale[k] = size > 0 ? kFarthest / (3 * size) : Scalar{0};
    }
    std::vector<std::uint64_t> entries(count);
    for (std::size_t t = 0; t < count; ++t) {
        const Scalar *a = corner(t, 0), *b = corner(t, 1), *c = corner(t, 2);
        std::uint32_t place = 0;
        for (std::size_t k = 0; k < Dim; ++k) {
            // If coordinates are so large that their sum is not finite, any cell will do.
            const Scalar cell = (a[k] + b[k] + c[k] - 3 * all.low[k]) * scale[k];
            const Scalar bounded = cell > 0 ? std::min(cell, kFarthest) : Scalar{0};
            place |= spread<Dim>(static_cast<std::uint32_t>(bounded)) << k;
        }
        entries[t] = std::uint64_t{place} << 32 | t;
    }
    std::ranges::sort(entries);

    order_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        order_[i] = static_cast<std::uint32_t>(entries[i]);
    }
    const std::size_t leaves = std::bit_ceil((count + kLeafSize - 1) / kLeafSize);
    firstLeaf_ = leaves - 1;
    boxes_.assign(2 * leaves - 1, emptyBox<Box>());
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Scalar* point = corner(order_[i], k);
            extend(boxes_[firstLeaf_ + i / kLeafSize], point, point);
        }
    }
    for (std::size_t node = firstLeaf_; node-- > 0;) {
        for (const std::size_t child : {2 * node + 1, 2 * node + 2}) {
            extend(boxes_[node], boxes_[child].low.data(), boxes_[child].high.data());
        }
    }
}

template class TriangleTree<2>;
template class TriangleTree<2, double>;
template class TriangleTree<3>;
template class TriangleTree<3, double>;

}  // namespace toile::geometry
