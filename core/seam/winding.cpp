// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/seam/contacts.h"

namespace toile {
namespace {

// A contact that gapes by a local edge length weighs this many times less, roughly.
constexpr double kGapePenalty = 100;

/// Two pieces and how much outline length says that they are wound alike (negative: against).
struct Balance {
    int left, right;
    double alike;
};

/// How much a contact says about the winding of its pieces, in mm. Near contacts speak more softly
/// the wider they gape. Parallel edges whose cloth lies on the same side are layers on top of each
/// other and say nothing; of a piece that is wound against its neighbour the cloth goes on beyond.
double weightOf(const Outlines& outlines, const Contact& c) {
    const Outline &a = outlines.of(c.a), &b = outlines.of(c.b);
    const double gape = 0.5 * (c.gap0 + c.gap1) / a.spacing[outlines.local(c.a)];
    const double weight = (c.a1 - c.a0) / (1 + kGapePenalty * gape);
    if (!c.parallel) {
        return weight;
    }
    const double sameSide =
        a.inward.row(outlines.local(c.a)).dot(b.inward.row(outlines.local(c.b)));
    return weight * 0.5 * (1 - sameSide);
}

std::vector<Balance> balances(const Outlines& outlines, const std::vector<Contact>& contacts) {
    std::map<std::pair<int, int>, double> sums;
    for (const Contact& c : contacts) {
        const std::pair<int, int> pieces{outlines.pieceOf(c.a), outlines.pieceOf(c.b)};
        if (pieces.first != pieces.second) {
            sums[pieces] += (c.parallel ? -1 : 1) * weightOf(outlines, c);
        }
    }
    std::vector<Balance> list;
    list.reserve(sums.size());
    for (const auto& [pieces, sum] : sums) {
        list.push_back({pieces.first, pieces.second, sum});
    }
    std::stable_sort(list.begin(), list.end(), [](const Balance& x, const Balance& y) {
        return std::abs(x.alike) > std::abs(y.alike);
    });
    return list;
}

/// Union-find by size that also knows whether a member is wound like its root.
class Windings {
public:
    explicit Windings(int pieces) : parent_(pieces), turned_(pieces, 0), size_(pieces, 1) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    /// Root of x, and whether x is wound against it.
    std::pair<int, bool> find(int x) const {
        bool turned = false;
        for (; parent_[x] != x; x = parent_[x]) {
            turned ^= turned_[x] != 0;
        }
        return {x, turned};
    }

    void join(int x, int y, bool against) {
        const auto [rootX, turnedX] = find(x);
        const auto [rootY, turnedY] = find(y);
        if (rootX != rootY) {
            const int upper = size_[rootX] < size_[rootY] ? rootY : rootX;
            const int lower = upper == rootX ? rootY : rootX;
            parent_[lower] = upper;
            size_[upper] += size_[lower];
            turned_[lower] = (turnedX != turnedY) != against ? 1 : 0;
        }
    }

private:
    std::vector<int> parent_;
    std::vector<char> turned_;
    std::vector<int> size_;
};

}  // namespace

void keepConsistentWinding(const Outlines& outlines, std::vector<Contact>& contacts) {
    Windings windings(static_cast<int>(outlines.list.size()));
    for (const Balance& b : balances(outlines, contacts)) {
        windings.join(b.left, b.right, b.alike < 0);
    }
    std::erase_if(contacts, [&](const Contact& c) {
        const bool against = windings.find(outlines.pieceOf(c.a)).second !=
                             windings.find(outlines.pieceOf(c.b)).second;
        return !c.certain && c.parallel != against;
    });
    std::sort(contacts.begin(), contacts.end(), [](const Contact& x, const Contact& y) {
        return std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
}

}  // namespace toile
