// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/units.h"
#include "core/geometry/polygon.h"
#include "core/marker/cloth_marker.h"
#include "core/marker/laid_pieces.h"
#include "core/nest/exact_overlap.h"
#include "core/nest/nest.h"
#include "core/pattern/line_settings.h"

namespace toile {
namespace {

using cloth::LaidPiece;
using geometry::Polygon;

constexpr const char* kSplice =
    translatable("%1 is not laid: it is %2 mm across, the cloth %3 mm; splice it at %4 mm");
constexpr const char* kNoLine = translatable("%1 is not laid: its outline crosses itself");

Polygon withoutRepeats(const Polygon& line) {
    Polygon kept(line.rows(), 2);
    Eigen::Index count = 0;
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        if (line.row(k) != line.row((k + 1) % line.rows())) {
            kept.row(count++) = line.row(k);
        }
    }
    return kept.topRows(count);
}

bool isLayable(const Polygon& line) {
    return line.rows() > 2 && line.allFinite() && std::abs(geometry::signedAreaOf(line)) > 0 &&
           !nest::doRingsCross({line});
}

/// How wide it is across the cloth at the best of its angles.
double leastAcross(const NestItem& item) {
    constexpr int kSteps = 180;
    double least = HUGE_VAL;
    for (const double angle : item.angles) {
        for (int k = -kSteps; k <= kSteps; ++k) {
            const double turn = angle + std::min(item.tolerance, kPi) * k / kSteps;
            const Eigen::VectorXd y = placedRings(item, {0, turn, false, 0, 0}).front().col(1);
            least = std::min(least, y.maxCoeff() - y.minCoeff());
        }
    }
    return least;
}

}  // namespace

struct MarkerNester::State {
    std::shared_ptr<const Pattern> pattern;
    MarkerSettings settings;
    std::vector<LaidPiece> laid;  ///< one per item of the instance
    std::optional<Nester> nester;
    ClothMarker best;

    const PatternPiece& pieceOf(const LaidPiece& piece) const {
        return pattern->pieces[static_cast<std::size_t>(piece.piece)];
    }

    /// Those that are kept get items of their own, in front, so that they are laid first.
    void addItems(const LaidPiece& piece, const std::vector<KeptCopy>& kept,
                  NestInstance& instance) {
        const NestItem item = cloth::itemOf(pieceOf(piece), piece.isImage, settings);
        const PieceId id = cloth::idOnCloth(*pattern, piece.piece);
        LaidPiece rest = piece;
        rest.numbers.clear();
        for (const int number : piece.numbers) {
            const auto found = std::ranges::find(kept, CopyKey{id, number}, &KeptCopy::copy);
            if (found == kept.end()) {
                rest.numbers.push_back(number);
                continue;
            }
            NestItem& fixed = instance.items.emplace_back(item);
            fixed.fixed = cloth::nestPlacementOf(found->placement);
            laid.push_back(piece);
            laid.back().numbers = {number};
            laid.back().isKept = true;
        }
        if (!rest.numbers.empty()) {
            NestItem& added = instance.items.emplace_back(item);
            added.demand = static_cast<int>(rest.numbers.size());
            laid.push_back(std::move(rest));
        }
    }

    /// What is too large for the cloth is not laid, and named.
    /// @return whether anything was left out that could be the reason for the error
    bool leaveOut(const Error& error, NestInstance& instance) {
        const double room = instance.width - 2 * settings.border;
        bool isAny = false;
        std::string noted;
        for (std::size_t i = instance.items.size(); i-- > 0;) {
            const NestItem& item = instance.items[i];
            if (item.fixed || item.name != error.subject.name) {
                continue;
            }
            const double across = leastAcross(item);
            const double splice = std::max(room - AllowanceWidths{}.seam, 0.0);
            if (!isAny) {
                best.notes.push_back(worded(
                    kSplice, {item.name, figure(across), figure(instance.width), figure(splice)}));
            }
            isAny = true;
            instance.items.erase(instance.items.begin() + static_cast<std::ptrdiff_t>(i));
            laid.erase(laid.begin() + static_cast<std::ptrdiff_t>(i));
        }
        return isAny;
    }

    void take() {
        const NestResult& result = nester->best();
        best.rounds = result.rounds;
        best.isOptimal = result.optimal;
        best.length = result.length;
        best.use = result.use;
        best.copies.clear();
        std::vector<std::size_t> next(laid.size());
        for (const NestPlacement& placement : result.placements) {
            const auto item = static_cast<std::size_t>(placement.item);
            const LaidPiece& piece = laid[item];
            LaidCopy& copy = best.copies.emplace_back();
            copy.key = {cloth::idOnCloth(*pattern, piece.piece), piece.numbers[next[item]++]};
            copy.piece = piece.piece;
            copy.isImage = piece.isImage;
            copy.isKept = piece.isKept;
            copy.yield = piece.yield;
            copy.placement = cloth::placementOf(placement, piece.isImage);
        }
        ClothPart roll;
        roll.outline.resize(4, 2);
        roll.outline << 0, 0, best.length, 0, best.length, best.width, 0, best.width;
        best.parts = {roll};
    }
};

Result<MarkerNester> MarkerNester::make(std::shared_ptr<const Pattern> pattern,
                                        const std::string& material, const Fabric& fabric,
                                        const MarkerSettings& settings,
                                        const std::vector<KeptCopy>& kept,
                                        const Progress& progress) {
    auto state = std::make_unique<State>();
    state->pattern = std::move(pattern);
    state->settings = settings;
    state->best.material = material;
    state->best.width = settings.width > 0 ? settings.width : fabric.width;
    state->best.width *= settings.isFolded ? 0.5 : 1;
    NestInstance instance;
    instance.name = material.empty() ? state->pattern->name : material;
    instance.width = state->best.width;
    for (const LaidPiece& piece :
         cloth::laidPieces(*state->pattern, material, settings, state->best.notes)) {
        const PatternPiece& of = state->pieceOf(piece);
        if (isLayable(withoutRepeats(edgeOf(of)))) {
            state->addItems(piece, kept, instance);
        } else if (!piece.isImage) {
            state->best.notes.push_back(worded(kNoLine, {of.name}));
        }
    }
    NestOptions options;
    options.gap = settings.gap;
    options.border = settings.border;
    options.seed = settings.seed;
    while (!state->nester) {
        auto made = Nester::make(instance, options, progress);
        if (made) {
            state->nester = std::move(*made);
        } else if (made.error().code != ErrorCode::PageTooSmall ||
                   made.error().subject.kind != Subject::Kind::Piece ||
                   !state->leaveOut(made.error(), instance)) {
            return made.error();
        }
    }
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
    state_->nester->step(progress);
    state_->take();
}

}  // namespace toile
