// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "core/base/units.h"
#include "core/geometry/polygon.h"
#include "core/marker/cloth_marker.h"
#include "core/marker/cloth_parts.h"
#include "core/marker/laid_pieces.h"
#include "core/marker/stripes.h"
#include "core/nest/item_rings.h"
#include "core/nest/nest.h"
#include "core/pattern/line_settings.h"

namespace toile {
namespace {

using cloth::LaidPiece;
using geometry::Polygon;

constexpr const char* kSplice =
    translatable("%1 is not laid: it is %2 mm across, the cloth %3 mm; splice it at %4 mm");
constexpr const char* kNoRoomOnce = translatable("%1 is not laid: there is no room left for it");
constexpr const char* kNoRoom =
    translatable("%1 is not laid %2 times: there is no room left for it");
constexpr const char* kFitsNowhere = translatable("%1 is not laid: it fits on no sheet or hide");
constexpr const char* kNoLine = translatable("%1 is not laid: its outline crosses itself");

constexpr double kGapRounding = 0.002;  // mm: by which shapes with a gap may come out larger

/// How long and how wide it is on the cloth, each at the best of its angles.
Eigen::Vector2d leastSides(const NestItem& item) {
    constexpr int kSteps = 180;
    Eigen::Vector2d least(HUGE_VAL, HUGE_VAL);
    for (const double angle : item.angles) {
        for (int k = -kSteps; k <= kSteps; ++k) {
            const double turn = angle + std::min(item.tolerance, kPi) * k / kSteps;
            const Polygon line = placedRings(item, {0, turn, false, 0, 0}).front();
            const Eigen::RowVector2d sides = line.colwise().maxCoeff() - line.colwise().minCoeff();
            least = least.cwiseMin(sides.transpose());
        }
    }
    return least;
}

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

}  // namespace

struct MarkerNester::State {
    std::shared_ptr<const Pattern> pattern;
    MarkerSettings settings;
    std::vector<LaidPiece> laid;     ///< one per item of the instance
    std::vector<LaidCopy> onTop{};   ///< kept where others are, or where no cloth is
    std::vector<ClothPart> parts{};  ///< sheets or hides; none: a roll
    std::size_t copies = 0;          ///< that are to be laid
    std::optional<Nester> nester;
    ClothMarker best;

    const PatternPiece& pieceOf(int index) const {
        return pattern->pieces[static_cast<std::size_t>(index)];
    }

    LaidCopy copyOf(const LaidPiece& piece, int number, const Placement& placement) const {
        LaidCopy copy;
        copy.key = {cloth::idOnCloth(*pattern, piece.piece), number};
        copy.piece = piece.piece;
        copy.isImage = piece.isImage;
        copy.isKept = piece.isKept;
        copy.yield = piece.yield;
        copy.placement = placement;
        return copy;
    }

    /// Those that are kept get items of their own, in front, so that they are laid first.
    void addItems(const LaidPiece& piece, const std::vector<KeptCopy>& kept,
                  NestInstance& instance) {
        const PatternPiece& of = pieceOf(piece.piece);
        const NestItem item = cloth::itemOf(of, piece.isImage, settings);
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
            fixed.fixed = cloth::nestFormOf(of, piece.isImage).nestPlacement(found->placement);
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

    void erase(std::size_t item, NestInstance& instance) {
        instance.items.erase(instance.items.begin() + static_cast<std::ptrdiff_t>(item));
        laid.erase(laid.begin() + static_cast<std::ptrdiff_t>(item));
        best.isWhole = false;
    }

    bool areSheets() const { return !best.isRoll && !best.areHides; }

    /// What is too large for the cloth of itself: not laid, and named.
    bool leaveOutTooLarge(const std::string& name, NestInstance& instance) {
        const double rounding = settings.gap > 0 ? kGapRounding : 0;
        bool isAny = false;
        for (std::size_t i = instance.items.size(); i-- > 0;) {
            const NestItem& item = instance.items[i];
            if (item.fixed || item.name != name) {
                continue;
            }
            const Eigen::Vector2d sides = leastSides(item);
            // No border is kept from a fold.
            const double room = instance.width - (item.touchesEdge ? 1 : 2) * settings.border;
            const bool isTooWide = sides.y() > room - rounding;
            if (areSheets() &&
                (isTooWide || sides.x() > settings.sheet->x() - 2 * settings.border - rounding)) {
                note(worded(kFitsNowhere, {name}));
            } else if (!areSheets() && isTooWide) {
                const double splice = std::max(room - AllowanceWidths{}.seam, 0.0);
                note(worded(kSplice,
                            {name, figure(sides.y()), figure(instance.width), figure(splice)}));
            } else {
                continue;
            }
            erase(i, instance);
            isAny = true;
        }
        return isAny;
    }

    /// A copy less.
    void leaveOutOne(std::size_t item, NestInstance& instance) {
        ++missing[instance.items[item].name];
        best.isWhole = false;
        laid[item].numbers.pop_back();
        if (--instance.items[item].demand == 0) {
            erase(item, instance);
        }
    }

    /// Of a piece that finds no place: where sheets or hides are full one copy, else all.
    /// @return whether that could be the reason for the error
    bool leaveOut(const std::string& name, NestInstance& instance) {
        if (leaveOutTooLarge(name, instance)) {
            return true;
        }
        for (std::size_t i = instance.items.size(); i-- > 0;) {
            if (!instance.items[i].fixed && instance.items[i].name == name) {
                const bool isFull = best.areHides || (areSheets() && parts.size() < copies);
                if (areSheets() && !isFull) {
                    note(worded(kFitsNowhere, {name}));
                    erase(i, instance);
                    return true;
                }
                for (int k = isFull ? 1 : instance.items[i].demand; k > 0; --k) {
                    leaveOutOne(i, instance);
                }
                return true;
            }
        }
        return false;
    }

    /// Of copies that together are larger than all hides some are left out before anything is laid,
    /// of what is cut most often first, so that as many whole garments as can be remain.
    void leaveOutBeyondArea(NestInstance& instance) {
        for (std::size_t i = instance.items.size(); i-- > 0;) {
            if (i < instance.items.size()) {
                leaveOutTooLarge(std::string(instance.items[i].name), instance);
            }
        }
        double area = 0;
        for (const ClothPart& part : parts) {
            area += cloth::areaOf(part);
        }
        std::vector<double> areas;
        for (const NestItem& item : instance.items) {
            areas.push_back(std::abs(geometry::signedAreaOf(item.rings.front())));
            area -= item.fixed ? 0 : areas.back() * item.demand;
        }
        while (area < 0) {
            std::optional<std::size_t> most;
            for (std::size_t i = 0; i < instance.items.size(); ++i) {
                const NestItem& item = instance.items[i];
                if (!item.fixed && item.demand > 1 &&
                    (!most || item.demand >= instance.items[*most].demand)) {
                    most = i;
                }
            }
            if (!most) {
                return;
            }
            area += areas[*most];
            leaveOutOne(*most, instance);
        }
    }

    /// Of a piece and its image once.
    void note(const Wording& said) {
        if (std::ranges::find(best.notes, said) == best.notes.end()) {
            best.notes.push_back(said);
        }
    }

    /// A person may lay a copy on others or beyond the cloth: it stays there, and others make room.
    bool layOnTop(const std::string& name, NestInstance& instance) {
        bool isAny = false;
        for (std::size_t i = instance.items.size(); i-- > 0;) {
            const NestItem& item = instance.items[i];
            if (item.fixed && item.name == name) {
                const LaidPiece& piece = laid[i];
                const cloth::NestForm form = cloth::nestFormOf(pieceOf(piece.piece), piece.isImage);
                onTop.push_back(copyOf(piece, piece.numbers.front(), form.placement(*item.fixed)));
                instance.obstacles.push_back(
                    {name, placedRings(item, *item.fixed), {}, settings.gap});
                const bool wasWhole = best.isWhole;
                erase(i, instance);
                best.isWhole = wasWhole;
                isAny = true;
            }
        }
        return isAny;
    }

    std::vector<int> grades() const {
        std::vector<int> grades;
        for (const LaidPiece& piece : laid) {
            const auto found = settings.grades.find(pieceOf(piece.piece).name);
            grades.push_back(found == settings.grades.end() ? 0 : found->second);
        }
        return grades;
    }

    /// A first nest, after as many tries as something has to be left out.
    std::optional<Error> begin(NestInstance instance, int threads, const Progress& progress) {
        std::vector<Wording> ofStripes;
        if (!settings.matched.empty()) {
            cloth::matchStripes(*pattern, laid, settings, instance.items, ofStripes);
        }
        NestOptions options;
        options.gap = settings.gap;
        options.border = settings.border;
        options.seed = settings.seed;
        options.threads = threads;
        if (best.areHides) {
            leaveOutBeyondArea(instance);
        }
        while (!nester) {
            NestInstance onParts = instance;
            cloth::addParts(parts, grades(), onParts);
            auto made = Nester::make(std::move(onParts), options, progress);
            if (made) {
                nester = std::move(*made);
                break;
            }
            const Error& error = made.error();
            const std::string name = error.subject.name;
            const bool isPiece = error.subject.kind == Subject::Kind::Piece;
            const bool canGoOn =
                isPiece && (error.code == ErrorCode::PageTooSmall    ? leaveOut(name, instance)
                            : error.code == ErrorCode::MalformedFile ? layOnTop(name, instance)
                                                                     : false);
            if (!canGoOn) {
                return error;
            }
        }
        for (const auto& [name, count] : missing) {
            best.notes.push_back(count == 1 ? worded(kNoRoomOnce, {name})
                                            : worded(kNoRoom, {name, figure(count)}));
        }
        best.notes.insert(best.notes.end(), ofStripes.begin(), ofStripes.end());
        return std::nullopt;
    }

    void take() {
        const NestResult& result = nester->best();
        best.rounds = result.rounds;
        best.isOptimal = result.optimal;
        best.length = result.length;
        best.copies.clear();
        std::vector<std::size_t> next(laid.size());
        for (const NestPlacement& placed : result.placements) {
            const auto item = static_cast<std::size_t>(placed.item);
            const LaidPiece& piece = laid[item];
            const cloth::NestForm form = cloth::nestFormOf(pieceOf(piece.piece), piece.isImage);
            best.copies.push_back(
                copyOf(piece, piece.numbers[next[item]++], form.placement(placed)));
        }
        best.copies.insert(best.copies.end(), onTop.begin(), onTop.end());
        cloth::measureOn(parts, *pattern, best);
    }

    std::map<std::string, int> missing{};  ///< copies for which there is no room
};

Result<MarkerNester> MarkerNester::make(std::shared_ptr<const Pattern> pattern,
                                        const std::string& material, const Fabric& fabric,
                                        const MarkerSettings& settings,
                                        const std::vector<KeptCopy>& kept, const Progress& progress,
                                        int threads) {
    auto state = std::make_unique<State>();
    state->pattern = std::move(pattern);
    state->settings = settings;
    ClothMarker& best = state->best;
    best.material = material;
    best.isRoll = settings.hides.empty() && !settings.sheet;
    best.areHides = !settings.hides.empty();
    best.width = cloth::widthOnCloth(settings, fabric);
    NestInstance instance;
    instance.name = material.empty() ? state->pattern->name : material;
    instance.width = best.width;
    if (auto error = wrongCopies(instance.name, leastCopies(*state->pattern, material, settings))) {
        return *std::move(error);
    }
    for (const LaidPiece& piece :
         cloth::laidPieces(*state->pattern, material, settings, best.notes)) {
        const PatternPiece& of = state->pieceOf(piece.piece);
        if (nest::usableRings(cloth::itemOf(of, piece.isImage, settings))) {
            state->addItems(piece, kept, instance);
            state->copies += piece.numbers.size();
        } else {
            best.isWhole = false;
            state->note(worded(kNoLine, {of.name}));
        }
    }
    state->parts = cloth::clothParts(settings, state->copies);
    if (auto error = state->begin(std::move(instance), threads, progress)) {
        return *std::move(error);
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
