// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/marker/cloth_items.h"
#include "core/marker/cloth_marker.h"
#include "core/marker/cloth_parts.h"
#include "core/marker/laid_pieces.h"
#include "core/nest/nest.h"

namespace toile {
namespace {

/// No fewer are laid: of folded cloth two come of each.
std::int64_t leastCopies(const Pattern& pattern, const std::string& material,
                         const MarkerSettings& settings) {
    std::int64_t cut = 0;
    for (const PatternPiece& piece : pattern.pieces) {
        if (cloth::materialOnCloth(pattern, piece) == material && piece.outline.rows() > 2) {
            cut += std::int64_t{std::max(piece.quantity, 0)} * std::max(settings.garments, 0);
        }
    }
    return settings.isFolded ? cut / 2 : cut;
}

/// A first nest, after as many tries as something has to give way.
Result<Nester> firstNest(cloth::ClothItems& items, const NestOptions& options,
                         const Progress& progress) {
    while (true) {
        auto made = Nester::make(items.instance(), options, progress);
        if (made || !items.giveWay(made.error())) {
            return made;
        }
    }
}

}  // namespace

struct MarkerNester::State {
    cloth::ClothItems items;
    Nester nester;
    ClothMarker best;

    void take() {
        const NestResult& result = nester.best();
        best.rounds = result.rounds;
        best.isOptimal = result.optimal;
        best.length = result.length;
        best.copies.clear();
        std::vector<std::size_t> next(items.itemCount());
        for (const NestPlacement& placed : result.placements) {
            const auto item = static_cast<std::size_t>(placed.item);
            best.copies.push_back(items.copyOf(item, next[item]++, placed));
        }
        best.copies.insert(best.copies.end(), items.onTop().begin(), items.onTop().end());
        cloth::measureOn(items.parts(), items.pattern(), best);
    }
};

Result<MarkerNester> MarkerNester::make(std::shared_ptr<const Pattern> pattern,
                                        const std::string& material, const Fabric& fabric,
                                        const MarkerSettings& settings,
                                        const std::vector<KeptCopy>& kept, const Progress& progress,
                                        int threads) {
    const std::string& name = material.empty() ? pattern->name : material;
    if (auto error = wrongCopies(name, leastCopies(*pattern, material, settings))) {
        return *std::move(error);
    }
    cloth::ClothItems items(std::move(pattern), material, fabric, settings, kept);
    NestOptions options;
    options.gap = settings.gap;
    options.border = settings.border;
    options.seed = settings.seed;
    options.threads = threads;
    auto nester = firstNest(items, options, progress);
    if (!nester) {
        return nester.error();
    }
    ClothMarker best;
    best.material = material;
    best.isRoll = settings.hides.empty() && !settings.sheet;
    best.areHides = !settings.hides.empty();
    best.width = items.width();
    best.isWhole = items.isWhole();
    best.notes = items.notes();
    auto state =
        std::make_unique<State>(State{std::move(items), std::move(*nester), std::move(best)});
    state->take();
    return MarkerNester(std::move(state));
}

MarkerNester::MarkerNester(std::unique_ptr<State> state) : state_(std::move(state)) {}
MarkerNester::~MarkerNester() = default;
MarkerNester::MarkerNester(MarkerNester&&) noexcept = default;
MarkerNester& MarkerNester::operator=(MarkerNester&&) noexcept = default;

const ClothMarker& MarkerNester::best() const {
    return state_->best;
}

void MarkerNester::step(const Progress& progress) {
    state_->nester.step(progress);
    state_->take();
}

}  // namespace toile
