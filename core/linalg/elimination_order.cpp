// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/elimination_order.h"

#include <algorithm>

namespace toile {
namespace {

/// The vertices' graph of a system with two unknowns 2 v and 2 v + 1 to each vertex.
SymmetricMatrix vertexPattern(const SymmetricMatrix& pairs) {
    SymmetricMatrix vertices;
    vertices.size = pairs.size / 2;
    vertices.columnStart.assign(1, 0);
    for (int v = 0; v < vertices.size; ++v) {
        vertices.row.push_back(v);
        for (int k = pairs.columnStart[2 * v] + 2; k < pairs.columnStart[2 * v + 1]; k += 2) {
            vertices.row.push_back(pairs.row[k] / 2);
        }
        vertices.columnStart.push_back(static_cast<int>(vertices.row.size()));
    }
    return vertices;
}

/// Unknowns from which on nested dissection takes less time in all than minimum degree.
constexpr int kManyVertices = 20000;
/// The same for vertices with two unknowns each.
constexpr int kLargeInPairs = 50000;

}  // namespace

bool comesInPairs(const SymmetricMatrix& pattern) {
    if (pattern.size % 2 != 0) {
        return false;
    }
    for (int i = 0; i < pattern.size; i += 2) {
        // Of the first column all but its diagonal entry: the second column.
        const int* first = &pattern.row[pattern.columnStart[i]];
        const int* second = &pattern.row[pattern.columnStart[i + 1]];
        const int length = pattern.columnStart[i + 1] - pattern.columnStart[i];
        if (length != pattern.columnStart[i + 2] - pattern.columnStart[i + 1] + 1 ||
            !std::equal(first + 1, first + length, second) || length % 2 != 0) {
            return false;
        }
        for (int k = 2; k < length; k += 2) {
            if (first[k] % 2 != 0 || first[k + 1] != first[k] + 1) {
                return false;
            }
        }
    }
    return true;
}

CouplingGraph couplings(const SymmetricMatrix& matrix) {
    const auto n = static_cast<std::size_t>(matrix.size);
    CouplingGraph graph;
    graph.start.assign(n + 1, 0);
    for (int column = 0; column < matrix.size; ++column) {
        // The diagonal entry comes first.
        for (int k = matrix.columnStart[column] + 1; k < matrix.columnStart[column + 1]; ++k) {
            ++graph.start[column + 1];
            ++graph.start[matrix.row[k] + 1];
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        graph.start[i + 1] += graph.start[i];
    }
    graph.neighbour.resize(static_cast<std::size_t>(graph.start.back()));
    std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
    for (int column = 0; column < matrix.size; ++column) {
        for (int k = matrix.columnStart[column] + 1; k < matrix.columnStart[column + 1]; ++k) {
            graph.neighbour[next[column]++] = matrix.row[k];
            graph.neighbour[next[matrix.row[k]]++] = column;
        }
    }
    return graph;
}

std::vector<int> eliminationOrder(const SymmetricMatrix& pattern) {
    if (!comesInPairs(pattern)) {
        return pattern.size < kManyVertices ? std::vector<int>() : nestedDissection(couplings(pattern));
    }
    if (pattern.size / 2 < kLargeInPairs) {
        return {};
    }
    std::vector<int> order;
    for (const int v : nestedDissection(couplings(vertexPattern(pattern)))) {
        order.push_back(2 * v);
        order.push_back(2 * v + 1);
    }
    return order;
}

}  // namespace toile
