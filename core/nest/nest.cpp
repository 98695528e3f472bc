// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/nest.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <numeric>
#include <set>
#include <thread>
#include <utility>

#include "core/base/units.h"
#include "core/nest/collision.h"
#include "core/nest/problem.h"
#include "core/nest/rules.h"
#include "core/nest/search.h"
#include "core/nest/shape.h"

namespace toile {
namespace {

constexpr const char* kNoRoom = translatable("no room is left for it on the cloth");

}  // namespace
}  // namespace toile

namespace toile::nest {
namespace {

struct Laid {
    const Shape* shape;
    double x, y;
    double left() const { return x + shape->box.left; }
    double right() const { return x + shape->box.right; }
};

/// Copies and obstacles along the strip, sorted by their start.
class LaidAlong {
public:
    explicit LaidAlong(double cell) : cell_(cell) {}

    void add(const Laid& laid) {
        const std::size_t at = cellOf(laid.left());
        cells_.resize(std::max(cells_.size(), at + 1));
        cells_[at].push_back(laid);
        widest_ = std::max(widest_, laid.right() - laid.left());
        end_ = std::max(end_, laid.right());
    }
    double end() const { return end_; }
    /// Calls `does` for each that intersects the range, in any order.
    template <typename Does>
    void forEach(double left, double right, Does does) const {
        const std::size_t last = std::min(cellOf(right) + 1, cells_.size());
        for (std::size_t at = cellOf(left - widest_); at < last; ++at) {
            for (const Laid& laid : cells_[at]) {
                if (laid.right() > left && laid.left() < right) {
                    does(laid);
                }
            }
        }
    }

private:
    std::size_t cellOf(double x) const {
        return static_cast<std::size_t>(std::clamp(x / cell_, 0.0, kMaxCells));
    }

    static constexpr double kMaxCells = 1e5;
    double cell_, widest_ = 0, end_ = 0;
    std::vector<std::vector<Laid>> cells_;
};

constexpr Patience kCrowded{60, 2};
constexpr std::int64_t kMaxEvaluations = 200'000;

/// A nest on limited cloth, for copies for which sequential placement found no room: from these
/// poses, overlaps allowed, by separation. Nothing if that fails after a while.
std::optional<Found> crowdedNest(const Problem& problem, const std::vector<Pose>& poses,
                                 const NestOptions& options, const Progress& progress) {
    const double end = problem.stretches.back().to;
    if (!std::isfinite(end) || !(problem.leastLength < end)) {
        return std::nullopt;
    }
    Random random(1);
    Separation separation(problem, poses, end);
    separation.begin(poses, end, kCrowded);
    auto outcome = Separation::Outcome::Going;
    for (std::int64_t evaluations = 0;
         outcome == Separation::Outcome::Going && evaluations < kMaxEvaluations &&
         !progress.isCancelled() && !options.isHasty();
         ++evaluations) {
        outcome = separation.pass(random, evaluations, progress);
    }
    const Found found{separation.lay().poses(), separation.lay().usedLength()};
    return outcome == Separation::Outcome::Separated && isValid(problem, found.poses, found.length)
               ? std::optional(found)
               : std::nullopt;
}

constexpr int kTurnsTried = 8;             // rotations per side, for shapes that turn freely
constexpr double kApart = 1e-6;            // mm: exceeds rounding
constexpr std::size_t kMaxRowsTried = 60;  // rows at which a copy is tried
constexpr int kEvenRows = 20;              // rows added beside obstacles
/// For more copies than this, a place is searched only from near the last copy of the same item on,
/// in fewer rows: all else was tried for that one.
constexpr std::size_t kManyCopies = 150, kMaxRowsOfMany = 30;
constexpr std::size_t kMaxRowsInHaste = 4;
constexpr int kOrdersTried = 8;         // if the cloth ends
constexpr double kMinStepShare = 1e-3;  // of the strip's width

/// Places copies one after the other.
class FirstNest {
public:
    /// @param byBoxes  keep boxes apart: for shapes whose overlap only exact arithmetic detects
    FirstNest(const Problem& problem, const NestOptions& options, bool byBoxes,
              const Progress& progress)
        : problem_(problem),
          options_(options),
          progress_(progress),
          byBoxes_(byBoxes),
          poses_(problem.copies.size()),
          owned_(poses_.size()),
          laid_(problem.width() / 8),
          nearest_(problem.items.size()) {}

    /// Returns the copy that found no room, or nothing.
    std::optional<std::size_t> lay(const std::vector<std::size_t>& order) {
        for (const std::size_t copy : order) {
            const Item& item = problem_.itemOf(copy);
            const auto pose = item.isFixed ? problem_.copies[copy].start : bestPose(copy);
            if (progress_.isCancelled()) {
                return std::nullopt;
            }
            if (!pose) {
                return copy;
            }
            poses_[copy] = *pose;
            const Shape& shape = shapeOf(item, *pose, owned_[copy]);
            laid_.add({&shape, pose->x, pose->y});
        }
        return std::nullopt;
    }

    Found found() const { return {poses_, laid_.end()}; }

private:
    bool areMany() const { return poses_.size() > kManyCopies; }
    bool isHasty() const { return options_.isHasty(); }

    /// Where the search for a place starts: the left of a copy's box.
    double from(std::size_t copy, const Shape& shape) const {
        const double last = nearest_[static_cast<std::size_t>(problem_.copies[copy].item)];
        if (isHasty() && std::isinf(problem_.stretches.back().to)) {  // behind all others
            return std::max(problem_.low, laid_.end());
        }
        return std::max(problem_.low, areMany() ? last - (shape.box.right - shape.box.left) : 0);
    }

    /// Over all angles and rows, the place that ends first, then lowest.
    std::optional<Pose> bestPose(std::size_t copy) {
        const Item& item = problem_.itemOf(copy);
        std::optional<Pose> best;
        double end = HUGE_VAL, left = 0;
        const bool inHaste = isHasty();
        const int turns = item.tolerance > 0 && !inHaste ? kTurnsTried : 0;
        for (std::size_t v = 0; v < item.variants.size() && !(inHaste && best); ++v) {
            for (int k = -turns; k <= turns; ++k) {
                Pose pose{static_cast<int>(v), turns > 0 ? item.tolerance * k / turns : 0};
                Shape own;
                const Shape& shape = shapeOf(item, pose, own);
                const double first = from(copy, shape);
                for (const double y : rowsFor(item, shape, pose, first)) {
                    if (progress_.isCancelled()) {
                        return best;
                    }
                    pose.y = y;
                    pose.x = leftmost(copy, shape, pose, first - shape.box.left, end);
                    if (pose.x + shape.box.right < end) {
                        end = pose.x + shape.box.right;
                        left = pose.x + shape.box.left;
                        best = pose;
                    }
                }
            }
        }
        nearest_[static_cast<std::size_t>(problem_.copies[copy].item)] = left;
        return best || item.tolerance == 0 ? best : upright(copy);
    }

    /// For a copy that only fits between the rotations tried: finest steps, beyond the others.
    std::optional<Pose> upright(std::size_t copy) const {
        const Item& item = problem_.itemOf(copy);
        const double right = std::max(problem_.low, laid_.end()) + kApart;
        std::optional<Pose> best;
        double least = HUGE_VAL;
        for (std::size_t v = 0; v < item.variants.size(); ++v) {
            for (int k = -180; k <= 180; ++k) {
                Shape own;
                Pose pose{static_cast<int>(v), item.tolerance * k / 180};
                const Shape& shape = shapeOf(item, pose, own);
                const double height = shape.box.top - shape.box.bottom;
                pose.y = problem_.low - shape.box.bottom;
                if (height < least && moveInside(problem_, item, shape, HUGE_VAL, pose)) {
                    pose.x = leftmost(copy, shape, pose, right - shape.box.left, HUGE_VAL);
                    if (pose.x < HUGE_VAL) {
                        least = height;
                        best = pose;
                    }
                }
            }
        }
        return best;
    }

    /// Allowed rows where it touches the edges, or the boxes of others from above or below.
    std::vector<double> rowsFor(const Item& item, const Shape& shape, const Pose& pose,
                                double from) const {
        const double bottom = shape.box.bottom, top = shape.box.top;
        const Track track = tracksOf(item, pose).y;
        if (std::isinf(track.step)) {
            return {track.offset};
        }
        const double low = problem_.low, most = problem_.high - (top - bottom);
        std::set<double> rows{low, most};
        const auto add = [&](double y, const Box& box) {
            rows.insert(y + box.top);
            rows.insert(y + box.bottom - (top - bottom));
            rows.insert(y + box.bottom);
        };
        laid_.forEach(areMany() ? from : -HUGE_VAL, HUGE_VAL,
                      [&](const Laid& laid) { add(laid.y, laid.shape->box); });
        for (const Obstacle& obstacle : problem_.obstacles) {
            add(0, obstacle.shape.box);
        }
        for (int k = 1; k < kEvenRows && !problem_.obstacles.empty(); ++k) {
            rows.insert(low + (most - low) * k / kEvenRows);
        }
        if (track.step > 0 && (most - low) / track.step < static_cast<double>(kMaxRowsTried)) {
            for (int k = 0; low + k * track.step <= most; ++k) {
                rows.insert(low + k * track.step);
            }
        }
        std::set<double> places;
        for (const double row : rows) {
            double y = row - bottom;
            if (row >= low && row <= most &&
                moveBetween(track, bottom, top, low, problem_.high, y)) {
                places.insert(y);
            }
        }
        std::vector<double> list(places.begin(), places.end());
        const std::size_t limit = isHasty()   ? kMaxRowsInHaste
                                  : areMany() ? kMaxRowsOfMany
                                              : kMaxRowsTried;
        if (list.size() > limit) {  // evenly chosen, including the edges
            for (std::size_t k = 0; k < limit; ++k) {
                list[k] = list[k * (list.size() - 1) / (limit - 1)];
            }
            list.resize(limit);
        }
        return list;
    }

    /// The leftmost place along a row from there on, skipping past the boxes that it hits; infinite
    /// if there is no place that ends before `enough`.
    double leftmost(std::size_t copy, const Shape& shape, const Pose& row, double from,
                    double enough) const {
        const Item& item = problem_.itemOf(copy);
        const Track track = tracksOf(item, row).x;
        double x = nextAlong(problem_, track, shape, from);
        while (x + shape.box.right < enough && !progress_.isCancelled()) {
            double next = HUGE_VAL;
            laid_.forEach(x + shape.box.left, x + shape.box.right, [&](const Laid& laid) {
                const double after = laid.right() - shape.box.left + (byBoxes_ ? kApart : 0);
                if (after < next && doMeet(shape, *laid.shape, laid.x - x, laid.y - row.y)) {
                    next = after;
                }
            });
            Pose pose = row;
            pose.x = x;
            const Obstacle* obstacle =
                next == HUGE_VAL ? obstacleUnder(copy, shape, pose) : nullptr;
            if (next == HUGE_VAL && !obstacle) {
                return x;
            }
            const double tenth = x + std::max((shape.box.right - shape.box.left) / 10,
                                              kMinStepShare * problem_.width());
            const double after = std::min(next, tenth);
            if (obstacle && x + shape.box.left > obstacle->shape.box.right + problem_.width()) {
                return HUGE_VAL;
            }
            const double further =
                nextAlong(problem_, track, shape, after > x ? after : std::nextafter(x, HUGE_VAL));
            // On a track the closest place may be this one again.
            x = further > x ? further : nextAlong(problem_, track, shape, x + 2 * kApart);
        }
        return HUGE_VAL;
    }

    bool doMeet(const Shape& a, const Shape& b, double dx, double dy) const {
        return byBoxes_ ? b.box.bottom + dy < a.box.top + kApart &&
                              b.box.top + dy > a.box.bottom - kApart
                        : doCollide(a, b, dx, dy);
    }

    const Obstacle* obstacleUnder(std::size_t copy, const Shape& shape, const Pose& pose) const {
        const auto item = static_cast<std::size_t>(problem_.copies[copy].item);
        const double left = pose.x + shape.box.left, right = pose.x + shape.box.right;
        const auto under = std::ranges::find_if(problem_.obstacles, [&](const Obstacle& obstacle) {
            return obstacle.shape.box.left < right && obstacle.shape.box.right > left &&
                   obstacle.isFor[item] &&
                   doCollide(bareOf(shape), obstacle.shape, -pose.x, -pose.y);
        });
        if (under != problem_.obstacles.end()) {
            return &*under;
        }
        return byBoxes_ ? nest::obstacleUnder(problem_, copy, pose) : nullptr;
    }

    const Problem& problem_;
    const NestOptions& options_;
    const Progress& progress_;
    bool byBoxes_;
    std::vector<Pose> poses_;
    std::vector<Shape> owned_;
    LaidAlong laid_;
    std::vector<double> nearest_;  ///< start of the last copy of each item
};

/// The fixed copies first, then the largest.
std::vector<std::size_t> orderOf(const Problem& problem) {
    std::vector<std::size_t> order(problem.copies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto rankOf = [&problem](std::size_t copy) {
        const Item& item = problem.itemOf(copy);
        return item.isFixed ? HUGE_VAL : item.variants[0].shape.hullRoot;
    };
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return rankOf(a) > rankOf(b); });
    return order;
}

/// A first valid nest: the largest copies first, each as far to the left as possible.
/// Errors: PageTooSmall naming the item of a copy that finds no room; Cancelled.
Result<Found> firstNest(const Problem& problem, const NestInstance& instance,
                        const NestOptions& options, const Progress& progress) {
    const auto isHasty = [&options] { return options.isHasty(); };
    auto order = orderOf(problem);
    const auto isMovable = [&](std::size_t copy) { return !problem.itemOf(copy).isFixed; };
    std::optional<std::size_t> failed;
    std::vector<Pose> poses;
    for (int k = 0; k < (isHasty() ? 1 : kOrdersTried); ++k) {
        for (const bool byBoxes : {false, true}) {
            FirstNest nest(problem, options, byBoxes, progress);
            failed = nest.lay(order);
            if (progress.isCancelled()) {
                return Error{ErrorCode::Cancelled};
            }
            const Found found = nest.found();
            if (!failed && isValid(problem, found.poses, found.length)) {
                return found;
            }
            if (failed) {
                poses = found.poses;
                break;
            }
        }
        if (!failed) {
            break;
        }
        // Try the copy that found no room first.
        const auto first = std::ranges::find_if(order, isMovable);
        const auto at = std::ranges::find(order, *failed);
        if (first == at) {
            break;
        }
        std::rotate(first, at, at + 1);
    }
    if (!poses.empty() && !isHasty()) {
        if (auto found = crowdedNest(problem, poses, options, progress)) {
            return *std::move(found);
        }
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
    }
    const auto movable = std::ranges::find_if(order, isMovable);
    const std::size_t copy = failed.value_or(movable == order.end() ? order.front() : *movable);
    const auto item = static_cast<std::size_t>(problem.copies[copy].item);
    return Error{ErrorCode::PageTooSmall, Subject::piece(instance.items[item].name), kNoRoom};
}

}  // namespace
}  // namespace toile::nest

namespace toile {
namespace {

constexpr int kCompressEvery = 5;  // rounds, if exploring makes no progress
constexpr int kMaxSearches = 64;

}  // namespace

struct Nester::State {
    NestInstance instance;
    NestOptions options;
    nest::Problem problem;
    std::vector<std::unique_ptr<nest::Search>> searches;
    NestResult best;

    void take(const nest::Found& found) {
        best.placements.clear();
        for (std::size_t copy = 0; copy < found.poses.size(); ++copy) {
            best.placements.push_back(nest::placementOf(problem, copy, found.poses[copy]));
        }
        best.length = found.poses.empty() ? 0 : found.length + problem.low;
        while (best.length - problem.low < found.length) {
            best.length = std::nextafter(best.length, HUGE_VAL);
        }
        best.use = best.length > 0 ? problem.area / (instance.width * best.length) : 0;
        best.valid = nest::isValid(problem, found.poses, found.length);
        best.optimal = found.poses.empty() || !(found.length > problem.leastLength * (1 + 1e-12));
    }

    /// Runs the searches in parallel, as many at once as there are threads.
    void run(bool mayCompress, const Progress& progress) {
        std::atomic<std::size_t> next{0};
        const auto work = [&] {
            for (std::size_t k = next++; k < searches.size(); k = next++) {
                searches[k]->run(options.evaluations, mayCompress, progress);
            }
        };
        const int wanted = options.threads > 0
                               ? options.threads
                               : static_cast<int>(std::thread::hardware_concurrency());
        std::vector<std::future<void>> others;
        for (int k = 1; k < std::min(wanted, static_cast<int>(searches.size())); ++k) {
            others.push_back(std::async(std::launch::async, work));
        }
        work();
        for (auto& other : others) {
            other.get();
        }
    }
};

std::vector<geometry::Polygon> placedRings(const NestItem& item, const NestPlacement& placement) {
    const Eigen::Vector2d way = nest::wayOf(placement.angle);
    std::vector<geometry::Polygon> rings = item.rings;
    for (geometry::Polygon& ring : rings) {
        for (Eigen::Index k = 0; k < ring.rows(); ++k) {
            const double x = placement.mirrored ? -ring(k, 0) : ring(k, 0), y = ring(k, 1);
            ring(k, 0) = way.x() * x - way.y() * y + placement.x;
            ring(k, 1) = way.y() * x + way.x() * y + placement.y;
        }
    }
    return rings;
}

Result<Nester> Nester::make(NestInstance instance, const NestOptions& options,
                            const Progress& progress) {
    auto problem = nest::makeProblem(instance, options, progress);
    if (!problem) {
        return problem.error();
    }
    auto state = std::make_unique<State>();
    state->instance = std::move(instance);
    state->options = options;
    state->problem = std::move(*problem);
    const auto start = nest::firstNest(state->problem, state->instance, options, progress);
    if (!start) {
        return start.error();
    }
    const int count = std::clamp(options.searches, 1, kMaxSearches);
    for (int k = 0; k < count; ++k) {
        state->searches.push_back(std::make_unique<nest::Search>(
            state->problem, *start, nest::Random(options.seed, static_cast<std::uint64_t>(k), 0)));
    }
    state->take(*start);
    return Nester(std::move(state));
}

Nester::Nester(std::unique_ptr<State> state) : state_(std::move(state)) {}
Nester::~Nester() = default;
Nester::Nester(Nester&&) noexcept = default;
Nester& Nester::operator=(Nester&&) noexcept = default;

const NestInstance& Nester::instance() const {
    return state_->instance;
}

const NestResult& Nester::best() const {
    return state_->best;
}

void Nester::step(const Progress& progress) {
    NestResult& best = state_->best;
    if (best.optimal) {
        ++best.rounds;
        return;
    }
    state_->run(best.rounds % kCompressEvery == kCompressEvery - 1, progress);
    if (progress.isCancelled()) {
        return;
    }
    ++best.rounds;
    auto& searches = state_->searches;
    const nest::Found shortest = (*std::ranges::min_element(searches, {}, [](const auto& s) {
                                     return s->best().length;
                                 }))->best();
    for (auto& search : searches) {
        search->adopt(shortest);
    }
    if (shortest.length + state_->problem.low < best.length) {
        state_->take(shortest);
    }
}

}  // namespace toile
