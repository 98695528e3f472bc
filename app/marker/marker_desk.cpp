// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/marker/marker_desk.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/jobs/derivation.h"
#include "app/marker/cloth_drag.h"
#include "app/session/workspace.h"
#include "app/text/error_text.h"
#include "core/geometry/polygon.h"

namespace toile::app {

namespace {

constexpr int kMarkerPauseMilliseconds = 200;

/// Whether two pieces are equal in everything that affects their place on cloth.
bool liesAlike(const PatternPiece& one, const PatternPiece& other) {
    const Points2 &line = edgeOf(one), &otherLine = edgeOf(other);
    return one.id == other.id && one.name == other.name &&
           static_cast<const Cutting&>(one) == static_cast<const Cutting&>(other) &&
           one.mirror == other.mirror && line.rows() == otherLine.rows() && line == otherLine &&
           one.outline.rows() == other.outline.rows() && one.outline == other.outline &&
           one.notches.size() == other.notches.size();
}

bool liesAlike(const ClothGround& one, const ClothGround& other) {
    const Pattern &pattern = one.laid.wholePattern, &otherPattern = other.laid.wholePattern;
    return one.fabric == other.fabric && pattern.materials == otherPattern.materials &&
           std::ranges::equal(
               pattern.pieces, otherPattern.pieces,
               [](const auto& a, const auto& b) -> bool { return liesAlike(a, b); }) &&
           pattern.facings.size() == otherPattern.facings.size();
}

/// The sheet or hide under a moved copy; its own one if it is beyond all of them.
int partOf(const ClothMarker& marker, const Pattern& pattern, LaidCopy copy,
           const Placement& placement) {
    copy.placement = placement;
    const double middle = geometry::boxAround(laidOutline(pattern, copy)).center().x();
    for (std::size_t part = 0; part < marker.parts.size(); ++part) {
        const Eigen::AlignedBox2d box = geometry::boxAround(marker.parts[part].outline);
        if (box.min().x() <= middle && middle <= box.max().x()) {
            return static_cast<int>(part);
        }
    }
    return copy.sheet;
}

/// The misplaced ones among these copies of a marker.
std::vector<int> misplacedAmong(const Pattern& pattern, const ClothMarker& marker,
                                const MarkerSettings& settings, const std::vector<int>& copies) {
    ClothMarker some = marker;
    some.copies.clear();
    for (const int copy : copies) {
        some.copies.push_back(marker.copies[static_cast<std::size_t>(copy)]);
    }
    std::vector<int> misplaced;
    for (const int copy : misplacedCopies(pattern, some, settings)) {
        misplaced.push_back(copies[static_cast<std::size_t>(copy)]);
    }
    return misplaced;
}

/// Omits the text about a malformed file: the problem is in the settings.
QString searchProblem(const Error& problem) {
    return problem.code == ErrorCode::MalformedFile
               ? QString("%1: %2.").arg(QString::fromStdString(problem.subject.name),
                                        wordingText(problem.detail))
               : errorText(problem);
}

}  // namespace

MarkerDesk::MarkerDesk(Workspace& workspace, QObject* parent)
    : QObject(parent),
      workspace_(workspace),
      document_(workspace.document()),
      search_(this),
      grounds_(
          clothGround,
          [this](const auto& made, const PatternNow&, bool) {
              groundProblem_.reset();
              if (made.answer && *made.answer) {
                  takeGround(**made.answer);
              } else if (made.answer) {
                  groundProblem_ = made.answer->error();
              } else {
                  emit failed(faultText(made.fault));
              }
              emit changed();
          },
          {}, kMarkerPauseMilliseconds) {
    connect(&document_, &Document::opened, this, &MarkerDesk::onOpened);
    connect(&document_, &Document::changed, this, &MarkerDesk::onDocumentChanged);
    connect(&search_, &MarkerSearch::changed, this, &MarkerDesk::compose);
    connect(&search_, &MarkerSearch::failed, this, &MarkerDesk::failed);
    connect(&workspace_.jobs(), &JobRunner::idle, this, &MarkerDesk::askForGround);
}

MarkerDesk::~MarkerDesk() {
    search_.disconnect(this);
}

void MarkerDesk::begin() {
    isActive_ = true;
    askForGround();
}

void MarkerDesk::end() {
    isActive_ = false;
    grounds_.forget();
    ground_.reset();
    tried_.reset();
    search_.clear();
}

MarkerDesk::Stage MarkerDesk::stage() const {
    if (groundProblem_ || search_.problem()) {
        return Stage::Failed;
    }
    if (ground_) {
        return materials_.empty() ? Stage::Nothing : Stage::Laid;
    }
    const bool isComing =
        workspace_.canExport() && workspace_.patternAge() != PatternAge::OutOfDate;
    return isComing || workspace_.jobs().isBusy() ? Stage::Waiting : Stage::Nothing;
}

QString MarkerDesk::problem() const {
    switch (stage()) {
        case Stage::Nothing:
            if (workspace_.canExport()) {
                return tr("The pattern is out of date. Use Flatten > Flatten again.");
            }
            return document_.garment() ? tr("There are no flat pieces. Use Flatten > Flatten "
                                            "again, or cut the pieces that cannot lie flat.")
                                       : tr("Open a garment first.");
        case Stage::Waiting:
            return tr("Waiting for the pattern…");
        case Stage::Failed:
            return groundProblem_ ? errorText(*groundProblem_) : searchProblem(*search_.problem());
        case Stage::Laid:
            break;
    }
    if (isCurrent()) {
        return {};
    }
    if (!isRunning()) {
        return tr("The search stopped before it applied your settings. Press Start again.");
    }
    return marker_ ? QString() : tr("Placing the pieces…");
}

void MarkerDesk::setMaterial(const std::string& material) {
    if (material != material_) {
        material_ = material;
        tried_.reset();
        beginSearch(kFirstRounds);
        emit clothChanged();
    }
}

const Fabric& MarkerDesk::fabric() const {
    return fabricOf(material_, document_.state().materials, document_.fabric());
}

const MarkerPlan& MarkerDesk::plan() const {
    return document_.state().markers.of(material_);
}

void MarkerDesk::setSettings(const QString& text, const MarkerSettings& settings, int gesture) {
    if (document_.garment()) {
        MarkerPlan said = plan();
        said.settings = settings;
        store(text, std::move(said), gesture);
    }
}

void MarkerDesk::store(const QString& text, MarkerPlan next, int gesture) {
    document_.edit(text, &DocumentState::markers,
                   document_.state().markers.with(material_, std::move(next)), gesture);
}

bool MarkerDesk::canImprove() const {
    return stage() == Stage::Laid && isCurrent() && (!marker_->isOptimal || !plan_.kept.empty());
}

void MarkerDesk::improve() {
    isImproving_ = true;
    if (search_.order().plan.kept != plan_.kept) {
        beginSearch(std::nullopt);
    } else {
        search_.goOn();
    }
}

void MarkerDesk::startAgain() {
    beginSearch(rounds());
}

void MarkerDesk::tryPlacement(int copy, const Placement& placement) {
    tried_.emplace(marker_->copies[static_cast<std::size_t>(copy)].key, placement);
    compose();
}

void MarkerDesk::takeBack() {
    tried_.reset();
    compose();
}

void MarkerDesk::keep(int copy, Placement placement, const QString& text) {
    placement.turn = wrappedAngle(placement.turn);
    const LaidCopy& laid = marker_->copies[static_cast<std::size_t>(copy)];
    MarkerPlan said = plan();
    std::erase_if(said.kept, [&](const KeptCopy& kept) { return kept.copy == laid.key; });
    said.kept.push_back({laid.key, partOf(*marker_, *pattern(), laid, placement), placement});
    std::ranges::sort(said.kept, {}, [](const KeptCopy& kept) {
        return std::pair(kept.copy.piece.value, kept.copy.number);
    });
    tried_.reset();
    store(text.arg(nameOf(copy)), std::move(said));
}

void MarkerDesk::release(int copy) {
    const CopyKey key = marker_->copies[static_cast<std::size_t>(copy)].key;
    MarkerPlan said = plan();
    std::erase_if(said.kept, [&](const KeptCopy& kept) { return kept.copy == key; });
    store(tr("Release %1 on the cloth").arg(nameOf(copy)), std::move(said));
}

void MarkerDesk::releaseAll() {
    MarkerPlan said = plan();
    said.kept.clear();
    store(tr("Release all pieces on the cloth"), std::move(said));
}

QString MarkerDesk::nameOf(int copy) const {
    const int piece = marker_->copies[static_cast<std::size_t>(copy)].piece;
    return QString::fromStdString(pattern()->pieces[static_cast<std::size_t>(piece)].name);
}

void MarkerDesk::onOpened() {
    ground_.reset();
    material_.clear();
    plan_ = {};
    search_.clear();
}

void MarkerDesk::onDocumentChanged(const DocumentChange& what) {
    if (!isActive_ || !what.touchesContent()) {
        return;
    }
    askForGround();
    if (ground_ && plan() != plan_) {
        const bool otherSettings = !(plan().settings == plan_.settings);
        const bool otherCloth = otherSettings && (plan().settings.width != plan_.settings.width ||
                                                  plan().settings.sheet != plan_.settings.sheet ||
                                                  plan().settings.hides != plan_.settings.hides);
        plan_ = plan();
        tried_.reset();
        if (otherSettings || search_.isRunning() || search_.problem()) {
            beginSearch(rounds());
        } else {
            compose();
        }
        if (otherCloth) {
            emit clothChanged();
        }
    }
    emit changed();
}

/// Computes the ground once the document is flat and idle; ignores intermediate states.
void MarkerDesk::askForGround() {
    if (!isActive_) {
        return;
    }
    if (workspace_.canExport() && document_.isFlattened() && !workspace_.jobs().isBusy()) {
        grounds_.ask(PatternNow(document_, {}));
    } else {
        grounds_.forget();
        if (!workspace_.jobs().isBusy()) {
            ground_.reset();
            search_.clear();
        }
    }
    emit changed();
}

void MarkerDesk::takeGround(std::shared_ptr<const ClothGround> ground) {
    const bool isSame = ground_ && liesAlike(*ground_, *ground);
    ground_ = std::move(ground);
    if (isSame) {
        return;
    }
    materials_ = markerMaterials(ground_->laid.wholePattern);
    if (std::ranges::find(materials_, material_) == materials_.end()) {
        material_ = materials_.empty() ? std::string() : materials_.front();
    }
    beginSearch(rounds());
    emit clothChanged();
}

/// Continues a running search without limit.
std::optional<int> MarkerDesk::rounds() const {
    return isImproving_ && search_.isRunning() ? std::nullopt : std::optional(kFirstRounds);
}

MarkerOrder MarkerDesk::orderNow() const {
    MarkerOrder order{nullptr, material_, fabric(), plan()};
    const MarkerOrder& before = search_.order();
    // Keep the same pattern object if it is unchanged, so that the found layout stays visible.
    Pattern pattern = patternOnCloth(ground_->laid.wholePattern, order.plan.settings);
    const bool isSame =
        before.pattern &&
        std::ranges::equal(before.pattern->pieces, pattern.pieces,
                           [](const auto& a, const auto& b) -> bool { return liesAlike(a, b); });
    order.pattern = isSame ? before.pattern : std::make_shared<const Pattern>(std::move(pattern));
    return order;
}

void MarkerDesk::beginSearch(std::optional<int> rounds) {
    plan_ = plan();
    tried_.reset();
    isImproving_ = !rounds;
    if (!ground_ || materials_.empty()) {
        search_.clear();
    } else {
        search_.begin(orderNow(), rounds);
    }
}

/// During a drag on a roll or hides, checks only copies near the dragged one. The number of sheets
/// depends on all copies.
void MarkerDesk::findMisplaced() {
    const MarkerSettings& settings = plan_.settings;
    if (!tried_ || (settings.sheet && settings.hides.empty())) {
        othersOf_.reset();
        misplaced_ = misplacedCopies(*pattern(), *marker_, settings);
        return;
    }
    std::vector<Eigen::AlignedBox2d> boxes;
    std::size_t dragged = 0;
    for (const LaidCopy& copy : marker_->copies) {
        dragged = copy.key == tried_->first ? boxes.size() : dragged;
        boxes.push_back(geometry::boxAround(laidOutline(*pattern(), copy)));
    }
    std::vector<int> others, near;
    for (std::size_t copy = 0; copy < boxes.size(); ++copy) {
        if (copy != dragged) {
            others.push_back(static_cast<int>(copy));
        }
        if (boxes[copy].intersects(boxes[dragged])) {
            near.push_back(static_cast<int>(copy));
        }
    }
    if (othersOf_ != search_.best()) {
        othersOf_ = search_.best();
        misplacedOthers_ = misplacedAmong(*pattern(), *marker_, settings, others);
    }
    const std::vector<int> here = misplacedAmong(*pattern(), *marker_, settings, near);
    std::ranges::set_union(here, misplacedOthers_, std::back_inserter(misplaced_));
}

/// Combines the found layout with copies placed by hand.
void MarkerDesk::compose() {
    marker_.reset();
    misplaced_.clear();
    if (!tried_) {
        othersOf_.reset();
    }
    figures_ = {};
    if (search_.best() && pattern()) {
        marker_ = *search_.best();
        bool isByHand = false, isMoved = false;
        for (LaidCopy& copy : marker_->copies) {
            const auto kept = std::ranges::find(plan_.kept, copy.key, &KeptCopy::copy);
            copy.isKept = kept != plan_.kept.end();
            const bool isTried = tried_ && tried_->first == copy.key;
            const Placement place = isTried       ? tried_->second
                                    : copy.isKept ? kept->placement
                                                  : copy.placement;
            isByHand = isByHand || copy.isKept || isTried;
            isMoved = isMoved || !(place == copy.placement);
            copy.placement = place;
        }
        if (isMoved) {
            measureMoved(*pattern(), plan_.settings, *marker_);
        }
        if (isByHand || isMoved) {  // otherwise it has no misplaced copies
            findMisplaced();
        }
        figures_ = markerFigures(*pattern(), *marker_);
    }
    emit changed();
}

}  // namespace toile::app
