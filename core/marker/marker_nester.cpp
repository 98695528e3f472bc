// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/marker/cloth_fit.h"
#include "core/marker/cloth_marker.h"
#include "core/marker/laid_pieces.h"
#include "core/nest/item_rings.h"
#include "core/nest/nest.h"
#include "core/pattern/line_settings.h"

namespace toile {
namespace {

constexpr const char* kSplice = translatable(
    "%1 is not placed: it is %2 mm across, but the cloth only %3 mm; splice it at %4 mm");
constexpr const char* kNoRoomOnce =
    translatable("%1 is not placed: no room is left; use more cloth");
constexpr const char* kNoRoom =
    translatable("%2 copies of %1 are not placed: no room is left; use more cloth");
constexpr const char* kFitsNowhere = translatable(
    "%1 is not placed: it fits on no sheet or hide; divide it by a cut, or use larger ones");
constexpr const char* kNoLine =
    translatable("%1 is not placed: its outline crosses itself; divide it by a cut");

}  // namespace
}  // namespace toile

namespace toile::cloth {

/// Items to lay on a cloth, reduced until all fit: copies placed by the user, and others. Items
/// that are too large or too many are left out, with a note.
class ClothItems {
public:
    /// @param pattern  from `patternOnCloth`
    ClothItems(std::shared_ptr<const Pattern> pattern, const std::string& material,
               const Fabric& fabric, const MarkerSettings& settings,
               const std::vector<KeptCopy>& kept);

    /// For the nest: its items are those of `copyOf` until `giveWay` changes them.
    NestInstance instance() const;
    /// Makes room if there is none: leaves out the piece that the error names, or keeps it on
    /// top at the user's placement.  @return whether that could resolve the error
    bool giveWay(const Error& error);

    const Pattern& pattern() const { return *pattern_; }
    double width() const { return instance_.width; }
    std::size_t itemCount() const { return laid_.size(); }
    /// @param nth  index among the item's copies
    LaidCopy copyOf(std::size_t item, std::size_t nth, const NestPlacement& placed) const;
    /// Copies that the user placed over others or beyond the cloth, at their placement.
    const std::vector<LaidCopy>& onTop() const { return onTop_; }
    /// Sheets or hides; empty for a roll.
    const std::vector<ClothPart>& parts() const { return parts_; }
    /// Whether no copy is left out.
    bool isWhole() const { return isWhole_; }
    std::vector<Wording> notes() const;

private:
    const PatternPiece& pieceOf(const LaidPiece& piece) const {
        return pattern_->pieces[static_cast<std::size_t>(piece.piece)];
    }
    bool areHides() const { return !settings_.hides.empty(); }
    bool areSheets() const { return !areHides() && settings_.sheet; }

    void add(const LaidPiece& piece, const std::vector<KeptCopy>& kept);
    void erase(std::size_t item);
    bool leaveOutTooLarge(const std::string& name);
    void leaveOutOne(std::size_t item);
    bool leaveOut(const std::string& name);
    void leaveOutBeyondArea();
    bool layOnTop(const std::string& name);
    void note(const Wording& stated);

    std::shared_ptr<const Pattern> pattern_;
    MarkerSettings settings_;
    NestInstance instance_;
    std::vector<LaidPiece> laid_;  ///< one per item of the instance
    std::vector<LaidCopy> onTop_;
    std::vector<ClothPart> parts_;
    std::size_t copies_ = 0;  ///< to lay in total
    bool isWhole_ = true;
    std::vector<Wording> notes_, ofStripes_;
    std::map<std::string, int> missing_;  ///< copies without room
};

ClothItems::ClothItems(std::shared_ptr<const Pattern> pattern, const std::string& material,
                       const Fabric& fabric, const MarkerSettings& settings,
                       const std::vector<KeptCopy>& kept)
    : pattern_(std::move(pattern)), settings_(settings) {
    instance_.name = material.empty() ? pattern_->name : material;
    instance_.width = widthOnCloth(settings, fabric);
    for (const LaidPiece& piece : laidPieces(*pattern_, material, settings, notes_)) {
        if (nest::usableRings(itemOf(pieceOf(piece), piece.isImage, settings))) {
            add(piece, kept);
            copies_ += piece.numbers.size();
        } else {
            isWhole_ = false;
            note(worded(kNoLine, {pieceOf(piece).name}));
        }
    }
    parts_ = clothParts(settings, copies_);
    if (!settings.matched.empty()) {
        matchStripes(*pattern_, laid_, settings, instance_.items, ofStripes_);
    }
    if (areHides()) {
        leaveOutBeyondArea();
    }
}

/// Kept copies become separate items at the front, so that they are laid first.
void ClothItems::add(const LaidPiece& piece, const std::vector<KeptCopy>& kept) {
    const NestItem item = itemOf(pieceOf(piece), piece.isImage, settings_);
    const NestForm form = nestFormOf(pieceOf(piece), piece.isImage);
    const PieceId id = idOnCloth(*pattern_, piece.piece);
    LaidPiece rest = piece;
    rest.numbers.clear();
    for (const int number : piece.numbers) {
        const auto found = std::ranges::find(kept, CopyKey{id, number}, &KeptCopy::copy);
        if (found == kept.end()) {
            rest.numbers.push_back(number);
            continue;
        }
        instance_.items.emplace_back(item).fixed = form.nestPlacement(found->placement);
        laid_.push_back(piece);
        laid_.back().numbers = {number};
        laid_.back().isKept = true;
    }
    if (!rest.numbers.empty()) {
        instance_.items.emplace_back(item).demand = static_cast<int>(rest.numbers.size());
        laid_.push_back(std::move(rest));
    }
}

NestInstance ClothItems::instance() const {
    std::vector<int> grades;
    for (const LaidPiece& piece : laid_) {
        const auto found = settings_.grades.find(pieceOf(piece).name);
        grades.push_back(found == settings_.grades.end() ? 0 : found->second);
    }
    NestInstance onParts = instance_;
    addParts(parts_, grades, onParts);
    return onParts;
}

LaidCopy ClothItems::copyOf(std::size_t item, std::size_t nth, const NestPlacement& placed) const {
    const LaidPiece& piece = laid_[item];
    LaidCopy copy;
    copy.key = {idOnCloth(*pattern_, piece.piece), piece.numbers[nth]};
    copy.piece = piece.piece;
    copy.isImage = piece.isImage;
    copy.isKept = piece.isKept;
    copy.yield = piece.yield;
    copy.placement = nestFormOf(pieceOf(piece), piece.isImage).placement(placed);
    return copy;
}

std::vector<Wording> ClothItems::notes() const {
    std::vector<Wording> all = notes_;
    for (const auto& [name, count] : missing_) {
        all.push_back(count == 1 ? worded(kNoRoomOnce, {name})
                                 : worded(kNoRoom, {name, figure(count)}));
    }
    all.insert(all.end(), ofStripes_.begin(), ofStripes_.end());
    return all;
}

/// Adds a note once for a piece and its image.
void ClothItems::note(const Wording& stated) {
    if (std::ranges::find(notes_, stated) == notes_.end()) {
        notes_.push_back(stated);
    }
}

bool ClothItems::giveWay(const Error& error) {
    const std::string name = error.subject.name;
    return error.subject.kind == Subject::Kind::Piece &&
           (error.code == ErrorCode::PageTooSmall    ? leaveOut(name)
            : error.code == ErrorCode::MalformedFile ? layOnTop(name)
                                                     : false);
}

void ClothItems::erase(std::size_t item) {
    instance_.items.erase(instance_.items.begin() + static_cast<std::ptrdiff_t>(item));
    laid_.erase(laid_.begin() + static_cast<std::ptrdiff_t>(item));
}

/// Leaves out items that are too large for an empty cloth, with a note.
bool ClothItems::leaveOutTooLarge(const std::string& name) {
    bool isAny = false;
    for (std::size_t i = instance_.items.size(); i-- > 0;) {
        const NestItem& item = instance_.items[i];
        if (item.fixed || item.name != name) {
            continue;
        }
        const Eigen::Vector2d sides = leastSides(item);
        const double room = roomAcross(item, width(), settings_);
        const bool isTooWide = sides.y() > room;
        if (areSheets() && (isTooWide || sides.x() > roomAlong(settings_))) {
            note(worded(kFitsNowhere, {name}));
        } else if (!areSheets() && isTooWide) {
            const double splice = std::max(room - AllowanceWidths{}.seam, 0.0);
            note(worded(kSplice, {name, figure(sides.y()), figure(width()), figure(splice)}));
        } else {
            continue;
        }
        erase(i);
        isWhole_ = false;
        isAny = true;
    }
    return isAny;
}

/// Removes one copy of an item.
void ClothItems::leaveOutOne(std::size_t item) {
    ++missing_[instance_.items[item].name];
    isWhole_ = false;
    laid_[item].numbers.pop_back();
    if (--instance_.items[item].demand == 0) {
        erase(item);
    }
}

/// Leaves out a piece without a place: one copy if sheets or hides are full, else all.
bool ClothItems::leaveOut(const std::string& name) {
    if (leaveOutTooLarge(name)) {
        return true;
    }
    for (std::size_t i = instance_.items.size(); i-- > 0;) {
        if (instance_.items[i].fixed || instance_.items[i].name != name) {
            continue;
        }
        const bool isFull = areHides() || (areSheets() && parts_.size() < copies_);
        if (areSheets() && !isFull) {
            note(worded(kFitsNowhere, {name}));
            isWhole_ = false;
            erase(i);
            return true;
        }
        for (int k = isFull ? 1 : instance_.items[i].demand; k > 0; --k) {
            leaveOutOne(i);
        }
        return true;
    }
    return false;
}

/// If the copies together are larger than all hides, leaves some out before laying, starting with
/// those cut most often, to keep as many whole garments as possible.
void ClothItems::leaveOutBeyondArea() {
    for (std::size_t i = instance_.items.size(); i-- > 0;) {
        if (i < instance_.items.size()) {
            leaveOutTooLarge(std::string(instance_.items[i].name));
        }
    }
    double area = 0;
    for (const ClothPart& part : parts_) {
        area += areaOf(part);
    }
    std::vector<double> areas;
    for (const NestItem& item : instance_.items) {
        areas.push_back(std::abs(geometry::signedAreaOf(item.rings.front())));
        area -= item.fixed ? 0 : areas.back() * item.demand;
    }
    while (area < 0) {
        std::optional<std::size_t> most;
        for (std::size_t i = 0; i < instance_.items.size(); ++i) {
            const NestItem& item = instance_.items[i];
            if (!item.fixed && item.demand > 1 &&
                (!most || item.demand >= instance_.items[*most].demand)) {
                most = i;
            }
        }
        if (!most) {
            return;
        }
        area += areas[*most];
        leaveOutOne(*most);
    }
}

/// Keeps copies that the user placed over others or beyond the cloth; other copies move away.
bool ClothItems::layOnTop(const std::string& name) {
    bool isAny = false;
    for (std::size_t i = instance_.items.size(); i-- > 0;) {
        const NestItem& item = instance_.items[i];
        if (item.fixed && item.name == name) {
            onTop_.push_back(copyOf(i, 0, *item.fixed));
            instance_.obstacles.push_back(
                {name, placedRings(item, *item.fixed), {}, settings_.gap});
            erase(i);
            isAny = true;
        }
    }
    return isAny;
}

}  // namespace toile::cloth

namespace toile {
namespace {

/// The least number of copies laid: on folded cloth each copy gives two.
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

/// Makes the first nest; retries as long as items can give way.
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
                                        int threads, std::optional<double> seconds) {
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
    options.hasteAfter = seconds.value_or(options.hasteAfter);
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
