// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/nest.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <thread>
#include <utility>

#include "core/nest/problem.h"
#include "core/nest/search.h"
#include "core/nest/start.h"

namespace toile {
namespace {

constexpr int kCompressEvery = 5;  // rounds, where exploring is stuck
constexpr int kMostSearches = 64;

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

    /// The searches side by side, as many at once as there are threads.
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
    const auto start = nest::firstNest(state->problem, state->instance, progress);
    if (!start) {
        return start.error();
    }
    const int count = std::clamp(options.searches, 1, kMostSearches);
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
