// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edge_table.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>

#include "core/geometry/disjoint_sets.h"

namespace toile {
namespace {

/// Longer buckets than this are sorted by `std::sort`; a vertex of a usual mesh has about six.
constexpr std::ptrdiff_t kFewSides = 32;

/// A triangle's side, kept in the bucket of its smaller vertex: larger vertex and use (3 * face +
/// k) in one number, in the order of both.
using Side = std::uint64_t;

Side makeSide(int larger, int use) {
    return static_cast<Side>(larger) << 32 | static_cast<Side>(use);
}

int largerOf(Side side) {
    return static_cast<int>(side >> 32);
}

int useOf(Side side) {
    return static_cast<int>(side & 0xFFFFFFFFu);
}

void sortBucket(Side* first, Side* last) {
    if (last - first > kFewSides) {
        std::sort(first, last);
        return;
    }
    for (Side* at = first; at < last; ++at) {
        const Side side = *at;
        Side* to = at;
        for (; to > first && to[-1] > side; --to) {
            *to = to[-1];
        }
        *to = side;
    }
}

/// Calls visit(smaller vertex, larger vertex, use) for every side.
template <class Visit>
void visitSides(const Triangles& F, Visit visit) {
    const int* corner = F.data();
    const int count = static_cast<int>(F.size());
    for (int first = 0; first < count; first += 3) {
        const int a = corner[first], b = corner[first + 1], c = corner[first + 2];
        visit(std::min(a, b), std::max(a, b), first);
        visit(std::min(b, c), std::max(b, c), first + 1);
        visit(std::min(c, a), std::max(c, a), first + 2);
    }
}

/// All sides in the order of their edges; `end[v]` is where the bucket of vertex v ends.
std::unique_ptr<Side[]> sortedSides(const Triangles& F, std::vector<int>& end) {
    visitSides(F, [&end](int smaller, int, int) { ++end[smaller + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    auto sides = std::make_unique_for_overwrite<Side[]>(static_cast<std::size_t>(F.size()));
    visitSides(F, [&](int smaller, int larger, int use) {
        sides[end[smaller]++] = makeSide(larger, use);
    });
    end.pop_back();  // what was the start of a bucket is its end now
    int begin = 0;
    for (const int e : end) {
        sortBucket(sides.get() + begin, sides.get() + e);
        begin = e;
    }
    return sides;
}

}  // namespace

EdgeTable buildEdgeTable(const Triangles& F, int vertexCount) {
    const int sideCount = static_cast<int>(F.size());
    std::vector<int> end(static_cast<std::size_t>(vertexCount) + 1, 0);
    const std::unique_ptr<Side[]> sides = sortedSides(F, end);
    int edgeCount = 0;
    for (int v = 0, s = 0; v < vertexCount; ++v) {
        for (int last = -1; s < end[v]; ++s) {
            edgeCount += largerOf(sides[s]) != last ? 1 : 0;
            last = largerOf(sides[s]);
        }
    }

    EdgeTable table;
    table.edges.resize(edgeCount, 2);
    table.faceEdges.resize(F.rows(), 3);
    table.use.resize(static_cast<std::size_t>(sideCount));
    table.useStart.resize(static_cast<std::size_t>(edgeCount) + 1);
    int edge = -1;
    for (int v = 0, s = 0; v < vertexCount; ++v) {
        for (int last = -1; s < end[v]; ++s) {
            const int larger = largerOf(sides[s]);
            if (larger != last) {
                ++edge;
                table.useStart[edge] = s;
                table.edges(edge, 0) = v;
                table.edges(edge, 1) = larger;
                last = larger;
            }
            table.use[s] = useOf(sides[s]);
            table.faceEdges.data()[table.use[s]] = edge;
        }
    }
    table.useStart[edgeCount] = sideCount;
    return table;
}

std::vector<int> faceComponents(const Triangles& F, int vertexCount) {
    DisjointSets sets(vertexCount);
    for (int f = 0; f < F.rows(); ++f) {
        sets.join(F(f, 0), F(f, 1));
        sets.join(F(f, 0), F(f, 2));
    }
    std::vector<int> labelOfRoot(vertexCount, -1);
    std::vector<int> label(F.rows());
    int count = 0;
    for (int f = 0; f < F.rows(); ++f) {
        int& known = labelOfRoot[sets.root(F(f, 0))];
        if (known < 0) {
            known = count++;
        }
        label[f] = known;
    }
    return label;
}

int findEdge(const Edges& edges, int a, int b) {
    const std::pair<int, int> wanted = std::minmax(a, b);
    int low = 0, high = static_cast<int>(edges.rows());
    while (low < high) {
        const int middle = std::midpoint(low, high);
        const std::pair<int, int> ends(edges(middle, 0), edges(middle, 1));
        if (ends == wanted) {
            return middle;
        }
        (ends < wanted ? low : high) = ends < wanted ? middle + 1 : middle;
    }
    return -1;
}

}  // namespace toile
