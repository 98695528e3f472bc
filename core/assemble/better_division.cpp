// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/better_division.h"

#include "core/assemble/split.h"

namespace toile {
namespace {

constexpr SplitMode kCandidates[] = {SplitMode::Uv, SplitMode::Objects, SplitMode::Groups,
                                     SplitMode::Materials, SplitMode::Components};

/// Whether the file has the names or the map that the mode needs.
bool isThere(SplitMode mode, const PolygonSoup& soup) {
    switch (mode) {
        case SplitMode::Uv:
            return !soup.cornerUvs.empty();
        case SplitMode::Objects:
            return soup.objects.size() > 1;
        case SplitMode::Groups:
            return soup.groups.size() > 1;
        case SplitMode::Materials:
            return soup.materials.size() > 1;
        default:
            return true;
    }
}

bool isBetter(const DivisionCount& a, const DivisionCount& b) {
    const auto left = static_cast<long long>(a.flat) * b.pieces;
    const auto right = static_cast<long long>(b.flat) * a.pieces;
    return left != right ? left > right : a.pieces < b.pieces;
}

}  // namespace

std::optional<DivisionCount> betterDivision(const PolygonSoup& soup, const DivisionCount& present,
                                            const Progress& progress) {
    const Triangulation triangles = triangulate(soup, {});
    std::optional<DivisionCount> best;
    for (const SplitMode mode : kCandidates) {
        if (progress.isCancelled()) {
            return std::nullopt;
        }
        if (mode == present.mode || !isThere(mode, soup)) {
            continue;
        }
        const Division division = splitTriangles(mode, soup, triangles);
        const DivisionCount count{mode, division.partCount, diskCount(division)};
        if (count.flat > present.flat && isBetter(count, best.value_or(present)) &&
            static_cast<double>(triangles.F.rows()) >= kMinTrianglesPerPart * count.pieces) {
            best = count;
        }
    }
    return best;
}

}  // namespace toile
