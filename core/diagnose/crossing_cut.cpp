// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnose/crossing_cut.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/garment/piece.h"
#include "core/geometry/buckets.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// A path from loop vertex `from` to loop vertex `to` of the outline, with the piece's vertices.
struct InteriorPath {
    int from, to;  ///< indices into Piece::boundary
    std::vector<int> vertices;
    double length;  ///< mm
};

/// Shortest paths along edges through the inside of a piece: they touch the outline only at their
/// ends, and never a hole's rim. Keeps a reference to the piece. Use from one thread at a time:
/// searches share their workspace.
class InteriorPaths {
public:
    /// Cost: linear.
    explicit InteriorPaths(const Piece& piece);

    /// For each reachable target, in order: the path from the nearest source. Ties between paths
    /// are decided by index.
    /// @param sources, targets  indices into Piece::boundary
    /// @param longest           mm: longer paths are left out; the others do not depend on it
    /// Cost: O(m log m) for the m edges within `longest` of the sources, and the targets.
    std::vector<InteriorPath> find(const std::vector<int>& sources, const std::vector<int>& targets,
                                   double longest = std::numeric_limits<double>::infinity());

    /// Whether the last find() may have left out longer paths.
    bool hasLeftOut() const { return hasLeftOut_; }

private:
    void search(const std::vector<int>& sources, double longest);

    const Piece& piece_;
    std::vector<int> loopIndex_;      ///< per vertex; -1 inside
    std::vector<bool> isHoleRim_;     ///< per vertex
    geometry::Buckets<> neighbours_;  ///< per vertex: along interior edges
    // Between two searches: infinite, -1, empty.
    std::vector<double> distance_;
    std::vector<int> parent_;
    std::vector<int> reached_;
    bool hasLeftOut_ = false;
};

constexpr double kFar = std::numeric_limits<double>::infinity();

InteriorPaths::InteriorPaths(const Piece& piece)
    : piece_(piece),
      loopIndex_(static_cast<std::size_t>(piece.mesh.V.rows()), -1),
      isHoleRim_(loopIndex_.size(), false),
      neighbours_(static_cast<int>(loopIndex_.size()),
                  [&table = piece.table](auto add) {
                      for (int e = 0; e < table.edges.rows(); ++e) {
                          if (!table.isBorder(e)) {
                              add(table.edges(e, 0), table.edges(e, 1));
                              add(table.edges(e, 1), table.edges(e, 0));
                          }
                      }
                  }),
      distance_(loopIndex_.size(), kFar),
      parent_(loopIndex_.size(), -1) {
    for (std::size_t i = 0; i < piece.boundary.size(); ++i) {
        loopIndex_[piece.boundary[i]] = static_cast<int>(i);
    }
    for (const auto& hole : piece.holes) {
        for (const int v : hole) {
            isHoleRim_[v] = true;
        }
    }
}

void InteriorPaths::search(const std::vector<int>& sources, double longest) {
    const Points3& V = piece_.mesh.V;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int i : sources) {
        distance_[piece_.boundary[i]] = 0;
        reached_.push_back(piece_.boundary[i]);
        queue.emplace(0, piece_.boundary[i]);
    }
    while (!queue.empty()) {
        const auto [reached, v] = queue.top();
        queue.pop();
        const bool isEnd = loopIndex_[v] >= 0 && reached > 0;
        if (reached > distance_[v] || isEnd || isHoleRim_[v]) {
            continue;
        }
        for (const int w : neighbours_[v]) {
            const double there = reached + (V.row(v) - V.row(w)).norm();
            if (there < distance_[w] && there > longest) {
                hasLeftOut_ = true;
            } else if (there < distance_[w]) {
                if (distance_[w] == kFar) {
                    reached_.push_back(w);
                }
                distance_[w] = there;
                parent_[w] = v;
                queue.emplace(there, w);
            }
        }
    }
}

std::vector<InteriorPath> InteriorPaths::find(const std::vector<int>& sources,
                                              const std::vector<int>& targets, double longest) {
    hasLeftOut_ = false;
    search(sources, longest);
    std::vector<InteriorPath> paths;
    for (const int i : targets) {
        const int end = piece_.boundary[i];
        if (parent_[end] < 0) {
            continue;  // a source, or unreachable
        }
        InteriorPath path{-1, i, {}, distance_[end]};
        for (int v = end; v >= 0; v = parent_[v]) {
            path.vertices.push_back(v);
        }
        std::reverse(path.vertices.begin(), path.vertices.end());
        path.from = loopIndex_[path.vertices.front()];
        paths.push_back(std::move(path));
    }
    for (const int v : reached_) {
        distance_[v] = kFar;
        parent_[v] = -1;
    }
    reached_.clear();
    return paths;
}

/// Largest number of crossings examined; of more, evenly chosen ones represent the others.
constexpr std::size_t kMaxCrossings = 256;
/// Number of pairs of opposite places between which paths are searched.
constexpr int kMaxOpposite = 16;
/// Number of sharpest corners used as ends, mainly for the tips of slits.
constexpr std::size_t kSharpest = 8;
constexpr std::size_t kCrossingEnds = 8;
/// Testing a cut passes over the outline for each edge of the cut. Tests whether a cut resolves
/// everything may pass this many outline edges in total.
constexpr std::size_t kTestedEdges = 1000000;
constexpr std::size_t kMinTests = 8;
constexpr std::size_t kMaxTests = 200;
/// Limits on the number of cuts compared if none resolves everything.
constexpr std::size_t kMinLeastBadTests = 4;
constexpr std::size_t kMaxLeastBadTests = 40;
/// Longest paths in the first round, as a share of the outline, and the factor for each further
/// round.
constexpr double kFirstReach = 0.01;
constexpr double kReachGrowth = 2;
/// From this share on, paths cross the whole piece anyway: search without a limit.
constexpr double kWholeReach = 0.125;
/// A cut up to this much longer than the shortest is preferred if it divides more evenly.
constexpr double kHardlyLonger = 1.2;

/// Every k-th element of a list, so that at most `most` are left.
template <class T>
std::vector<T> thinned(const std::vector<T>& all, std::size_t most) {
    std::vector<T> kept;
    const std::size_t count = std::min(all.size(), most);
    for (std::size_t k = 0; k < count; ++k) {
        kept.push_back(all[k * all.size() / count]);
    }
    return kept;
}

/// 64 pseudo-random bits; the same for the same index on every platform (SplitMix64).
std::uint64_t scrambled(std::uint64_t index) {
    std::uint64_t z = (index + 1) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

class CutSearch {
public:
    CutSearch(const Piece& piece, const Points2& Q, const std::vector<OutlineCrossing>& crossings,
              const Progress& progress)
        : piece_(piece),
          Q_(Q),
          progress_(progress),
          n_(static_cast<int>(piece.boundary.size())),
          all_(crossings),
          crossings_(thinned(crossings, kMaxCrossings)),
          paths_(piece),
          along_(piece.boundary.size() + 1, 0),
          testsLeft_(std::clamp(kTestedEdges / piece.boundary.size(), kMinTests, kMaxTests)) {
        const Eigen::VectorXd lengths = boundaryLengths3d(piece.mesh.V, piece.boundary);
        std::partial_sum(lengths.begin(), lengths.end(), along_.begin() + 1);
    }

    /// Short paths are examined first, and usually suffice: the result for paths up to a length is
    /// that for all paths, if no longer one could be preferred.
    std::optional<CrossingCut> best() {
        fromOppositePlaces();
        fromSpreadPlaces();
        double longest = kFirstReach * along_.back();
        while (true) {
            const bool isAll = findWays(longest > kWholeReach * along_.back()
                                            ? std::numeric_limits<double>::infinity()
                                            : longest);
            const Candidate* shortest = firstThatResolves();
            if (shortest != nullptr &&
                (isAll || kHardlyLonger * shortest->path.length <= longest)) {
                return mostEven(*shortest);
            }
            if (isAll || progress_.isCancelled()) {
                return candidates_.empty() ? std::nullopt : std::optional(leastBad());
            }
            longest *= kReachGrowth;
            if (shortest != nullptr) {
                ++testsLeft_;  // it will be tested again
                longest = std::max(longest, kHardlyLonger * shortest->path.length);
            } else if (testsLeft_ == 0) {
                longest = along_.back();
            }
        }
    }

    /// `CrossingCut::folded3d`.
    double folded() const {
        double sum = 0;
        for (const OutlineCrossing& c : all_) {
            const double between = along_[c.second] - along_[c.first];
            sum += std::min(between, along_.back() - between);
        }
        return sum;
    }

private:
    struct Candidate {
        InteriorPath path;
        int together;  ///< crossings that the path does not separate
    };

    /// Outline places to connect.
    struct Search {
        std::vector<int> from, to;
    };

    /// Finds paths up to `longest`. Sorts them by the number of crossings that they separate, then
    /// by length. True if no longer path was left out.
    bool findWays(double longest) {
        candidates_.clear();
        bool isAll = true;
        for (const Search& search : searches_) {
            if (progress_.isCancelled()) {
                break;
            }
            add(paths_.find(search.from, search.to, longest));
            isAll = isAll && !paths_.hasLeftOut();
        }
        std::stable_sort(
            candidates_.begin(), candidates_.end(), [](const Candidate& s, const Candidate& t) {
                return std::tie(s.together, s.path.length) < std::tie(t.together, t.path.length);
            });
        return isAll;
    }

    bool isBetween(int edge, int from, int to) const {
        return from < to ? edge >= from && edge < to : from > to && (edge >= from || edge < to);
    }

    int together(int from, int to) const {
        return static_cast<int>(std::ranges::count_if(crossings_, [&](const OutlineCrossing& c) {
            return isBetween(c.first, from, to) == isBetween(c.second, from, to);
        }));
    }

    void add(std::vector<InteriorPath> found) {
        for (InteriorPath& path : found) {
            const int left = together(path.from, path.to);
            if (left < static_cast<int>(crossings_.size())) {
                candidates_.push_back({std::move(path), left});
            }
        }
    }

    /// A path separates all crossings if its ends are on different sides of each. Each crossing
    /// gets a random word; words are combined by exclusive or on passing the crossing's edges. The
    /// words of the two ends then differ by the combination of all words.
    void fromOppositePlaces() {
        std::vector<std::uint64_t> passed(static_cast<std::size_t>(n_) + 1, 0);
        std::uint64_t all = 0;
        for (std::size_t k = 0; k < crossings_.size(); ++k) {
            all ^= scrambled(k);
            passed[crossings_[k].first + 1] ^= scrambled(k);
            passed[crossings_[k].second + 1] ^= scrambled(k);
        }
        std::map<std::uint64_t, std::vector<int>> places;
        std::vector<std::uint64_t> order;  // by first place, not by word
        for (int i = 0; i < n_; ++i) {
            passed[i] ^= i > 0 ? passed[i - 1] : 0;
            auto& here = places[passed[i]];
            if (here.empty()) {
                order.push_back(passed[i]);
            }
            here.push_back(i);
        }
        int searched = 0;
        for (const std::uint64_t word : order) {
            const auto opposite = places.find(word ^ all);
            if (opposite != places.end() && places[word].front() < opposite->second.front() &&
                searched++ < kMaxOpposite) {
                searches_.push_back({places[word], opposite->second});
            }
        }
    }

    /// Likely ends of a cut: the sharpest corners, places next to crossings, evenly spread places.
    std::vector<int> spreadPlaces(std::size_t count) const {
        const Eigen::VectorXd angles = boundaryAngles3d(piece_.mesh, piece_.boundary);
        std::vector<int> sharpest(piece_.boundary.size());
        std::iota(sharpest.begin(), sharpest.end(), 0);
        std::stable_sort(sharpest.begin(), sharpest.end(), [&](int i, int j) {
            return std::abs(angles[i] - std::numbers::pi) > std::abs(angles[j] - std::numbers::pi);
        });
        sharpest.resize(std::min(sharpest.size(), kSharpest));
        std::vector<int> places = sharpest;
        for (const OutlineCrossing& c : thinned(crossings_, kCrossingEnds)) {
            for (const int i : {c.first, c.first + 1, c.second, c.second + 1}) {
                places.push_back(i % n_);
            }
        }
        for (std::size_t k = 0; k < count; ++k) {
            const double at = along_.back() * static_cast<double>(k) / static_cast<double>(count);
            const auto next = std::lower_bound(along_.begin(), along_.end(), at);
            places.push_back(static_cast<int>(next - along_.begin()) % n_);
        }
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        return places;
    }

    void fromSpreadPlaces() {
        const auto edges = static_cast<std::size_t>(piece_.table.edges.rows());
        const std::vector<int> places =
            spreadPlaces(std::clamp<std::size_t>(3000000 / edges, 4, 48));
        for (const int from : thinned(places, std::clamp<std::size_t>(3000000 / edges, 4, 96))) {
            searches_.push_back({{from}, places});
        }
    }

    /// Number of crossings, at most `most`, in the outlines of the two parts: those between edges
    /// of one part, and those of its new edges. The edge after the path counts as new, because
    /// contact at the start of an edge is judged by the edge before.
    int left(const InteriorPath& path, int most) const {
        int count = 0;
        for (const bool second : {false, true}) {
            const int begin = second ? path.to : path.from;
            const int end = second ? path.from : path.to;
            count += static_cast<int>(std::ranges::count_if(all_, [&](const OutlineCrossing& c) {
                return isBetween(c.first, begin + 1, end) && isBetween(c.second, begin + 1, end);
            }));
            std::vector<int> loop;
            for (int i = begin; i != end; loop.push_back(piece_.boundary[i])) {
                i = (i + 1) % n_;
            }
            const int firstNew = static_cast<int>(loop.size()) - 1;
            if (second) {
                loop.insert(loop.end(), path.vertices.begin() + 1, path.vertices.end());
            } else {
                loop.insert(loop.end(), path.vertices.rbegin() + 1, path.vertices.rend());
            }
            count += crossingsFrom(Q_, loop, firstNew, most - count);
        }
        return count;
    }

    /// Precondition: tests are left.
    bool resolves(const InteriorPath& path) {
        --testsLeft_;
        return all_.size() < kMaxOutlineCrossings && left(path, 1) == 0;
    }

    bool mayTest() const { return testsLeft_ > 0 && !progress_.isCancelled(); }

    /// Skips paths already tested in shorter rounds: they come first in the new list too.
    const Candidate* firstThatResolves() {
        for (; tested_ < candidates_.size(); ++tested_) {
            const Candidate& c = candidates_[tested_];
            if (c.together > 0 || !mayTest()) {  // paths that separate all crossings come first
                break;
            }
            if (resolves(c.path)) {
                return &c;
            }
        }
        return nullptr;
    }

    /// Difference between the two parts' shares of the outline, mm.
    double unevenness(const InteriorPath& path) const {
        const double between = std::abs(along_[path.to] - along_[path.from]);
        return std::abs(along_.back() - 2 * between);
    }

    /// Uses the remaining tests.
    CrossingCut mostEven(const Candidate& shortest) {
        std::vector<const Candidate*> close;
        for (const Candidate& c : candidates_) {
            if (c.together == 0 && c.path.length <= kHardlyLonger * shortest.path.length) {
                close.push_back(&c);
            }
        }
        std::stable_sort(close.begin(), close.end(), [&](const Candidate* s, const Candidate* t) {
            return unevenness(s->path) < unevenness(t->path);
        });
        for (std::size_t k = 0; k < close.size() && close[k] != &shortest && mayTest(); ++k) {
            if (resolves(close[k]->path)) {
                return {close[k]->path.vertices, close[k]->path.length, true};
            }
        }
        return {shortest.path.vertices, shortest.path.length, true};
    }

    /// Of the paths that separate the most crossings, the one that leaves the fewest.
    CrossingCut leastBad() const {
        const Candidate* best = &candidates_.front();
        int fewest = std::numeric_limits<int>::max();
        const std::size_t count =
            std::min(candidates_.size(), std::clamp(kTestedEdges / piece_.boundary.size(),
                                                    kMinLeastBadTests, kMaxLeastBadTests));
        for (std::size_t k = 0; k < count && !progress_.isCancelled(); ++k) {
            const Candidate& c = candidates_[k];
            const int here = left(c.path, fewest);
            if (here < fewest) {
                best = &c;
                fewest = here;
            }
        }
        return {best->path.vertices, best->path.length, false};
    }

    const Piece& piece_;
    const Points2& Q_;
    const Progress& progress_;
    int n_;
    const std::vector<OutlineCrossing>& all_;
    std::vector<OutlineCrossing> crossings_;  ///< a selection of all
    InteriorPaths paths_;
    std::vector<double> along_;  ///< length of the outline up to each loop vertex
    std::size_t testsLeft_;
    std::vector<Search> searches_;
    std::vector<Candidate> candidates_;
    std::size_t tested_ = 0;  ///< candidates that do not resolve the crossings
};

Wording cutWords(const Piece& piece, const std::optional<CrossingCut>& cut) {
    if (!cut) {
        return worded("; no cut through the inside was found");
    }
    if (!cut->isWorthIt()) {
        return worded(
            "; only %1 mm of its edge folds over: smooth the edge there, or remesh a scan",
            {figure(cut->folded3d, 1)});
    }
    const auto place = [&piece](int v) {
        return placeWording(piece.mesh.V(v, 0), piece.mesh.V(v, 1), piece.mesh.V(v, 2));
    };
    const std::vector<Wording> values{place(cut->path.front()), place(cut->path.back()),
                                      figure(cut->length3d)};
    return cut->resolves
               ? worded("; cut it from %1 to %2, %3 mm", values)
               : worded("; one cut is not enough: begin with one from %1 to %2, %3 mm", values);
}

}  // namespace

std::optional<CrossingCut> cutForCrossings(const Piece& piece, const Points2& Q,
                                           const std::vector<OutlineCrossing>& crossings,
                                           const Progress& progress) {
    CutSearch search(piece, Q, crossings, progress);
    auto cut = search.best();
    if (cut) {
        cut->folded3d = search.folded();
    }
    return cut;
}

void nameCrossingCut(const Piece& piece, const Points2& Q,
                     const std::vector<OutlineCrossing>& crossings, const Progress& progress,
                     Problems& notes) {
    const auto note = std::ranges::find(notes, ErrorCode::OutlineCrosses, &Error::code);
    if (note == notes.end()) {
        return;
    }
    const auto cut = cutForCrossings(piece, Q, crossings, progress);
    if (!progress.isCancelled()) {  // after a cancel the cut may not be the best
        note->detail += cutWords(piece, cut);
    }
}

}  // namespace toile
