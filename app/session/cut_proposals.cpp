// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/cut_proposals.h"

#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/session/workspace.h"
#include "app/text/error_text.h"
#include "app/text/proposed_name.h"
#include "core/assemble/cut_pieces.h"
#include "core/garment/garment.h"
#include "core/project/piece_names.h"
#include "core/project/piece_settings.h"
#include "core/tailor/mesh_lines.h"
#include "core/toile/pipeline.h"

namespace toile::app {

namespace {

constexpr int kAfterMove = 700;  // ms, until a moved cut is flattened again

AdviceQuestion questionOf(const Garment& garment, const std::shared_ptr<const Piece>& whole,
                          const std::vector<UserCut>& own = {}) {
    return {whole, own, garment.files[static_cast<std::size_t>(whole->file)]};
}

/// The whole piece before its cuts, with the user's own cuts.
AdviceQuestion wholeOf(const Garment& garment, const std::shared_ptr<const Piece>& piece) {
    for (const CutRecord& record : garment.cutRecords) {
        if (record.whole == piece ||
            std::ranges::find(record.pieces, piece) != record.pieces.end()) {
            return questionOf(garment, record.whole, record.requested);
        }
    }
    return questionOf(garment, piece);
}

/// The same whole piece in another version of the garment; none if it is gone.
std::optional<AdviceQuestion> wholeWith(const Garment& garment, PieceId id) {
    for (const CutRecord& record : garment.cutRecords) {
        if (record.whole->id == id) {
            return questionOf(garment, record.whole, record.requested);
        }
    }
    const auto piece =
        std::ranges::find(garment.pieces, id, [](const auto& one) { return one->id; });
    return piece == garment.pieces.end() ? std::nullopt
                                         : std::optional(questionOf(garment, *piece));
}

std::vector<UserCut> linesOf(const CutAdvice& advice) {
    std::vector<UserCut> lines;
    for (const AdvisedCut& cut : advice.cuts) {
        lines.push_back(cut.what.cut);
    }
    return lines;
}

}  // namespace

CutProposals::CutProposals(Workspace& workspace)
    : workspace_(workspace),
      document_(workspace.document()),
      asking_(
          [](const AdviceQuestion& asked, Progress& progress) {
              AdviceOptions options = asked.options;
              options.borders = fileBorders(*asked.piece, *asked.file->soup);
              return adviseCuts(asked.piece, asked.own, options, progress);
          },
          [this](const Attempt<CutAdvice>& made, const AdviceQuestion&, bool) {
              problem_ = made.answer ? QString() : faultText(made.fault);
              take(made.answer.value_or(CutAdvice{}));
          }),
      solving_(
          [](const Trial& trial, Progress& progress) {
              const auto& [question, advice] = *trial.cuts;
              return solvedStrain(question.piece, question.own, advice, trial.count, trial.options,
                                  progress);
          },
          [this](const Attempt<Result<StrainFigures>>& made, const Trial& trial, bool) {
              counts_.erase(counts_.begin());
              solveNext();
              if (made.answer && *made.answer) {  // otherwise the prediction stays
                  takeSolved(trial.count, **made.answer);
              }
              emit changed();
          }) {
    soon_.setSingleShot(true);
    soon_.setInterval(kAfterMove);
    connect(&soon_, &QTimer::timeout, this, &CutProposals::solve);
    connect(&document_, &Document::opened, this, [this] { nameOf_ = nullptr; });
    connect(&document_, &Document::opened, this, &CutProposals::close);
    connect(&document_, &Document::changed, this, &CutProposals::onChanged);
    connect(&workspace_, &Workspace::refused, this, [this] {
        if (awaited_ > 0) {
            ask(question_);  // propose the refused cut again
        }
    });
}

CutProposals::~CutProposals() = default;

void CutProposals::open() {
    const auto garment = document_.garment();
    if (!garment || garment->pieces.empty()) {
        return;
    }
    const auto& pieces = garment->pieces;
    const auto selected = document_.selection();
    auto meant = std::ranges::find_if(pieces, [](const auto& one) { return isOpenable(*one); });
    if (!selected.empty()) {
        meant = pieces.begin() + *selected.begin();
    } else if (meant == pieces.end()) {
        meant = std::ranges::max_element(
            pieces, {}, [](const auto& one) { return one->defect ? -1 : wornArea(*one); });
    }
    AdviceQuestion question = wholeOf(*garment, *meant);
    if (isOpen() && question.piece == piece() && question.own == question_.own) {
        emit opened();  // unchanged
        return;
    }
    if (!isOpen()) {  // start with the settings of automatic cuts
        stated_ = document_.loading().enoughStrain;
        question_.options.isFrontSwapped = document_.loading().isFrontSwapped;
    }
    declined_.clear();
    question.options = {isFrontSwapped(), stated_ ? stated_ : fabricLimit()};
    ask(std::move(question));
    emit opened();
}

void CutProposals::close() {
    if (!isOpen()) {
        return;
    }
    cancelSolving();
    asking_.forget();
    soon_.stop();
    state_ = State::Closed;
    question_ = {};
    put({});
    shaper_.reset();
    emit closed();
}

QString CutProposals::pieceName() const {
    return piece() ? QString::fromStdString(piece()->name) : QString();
}

std::optional<double> CutProposals::fabricLimit() const {
    const Fabric& fabric = document_.fabric();
    const double least = std::min(fabric.warp.most, fabric.weft.most);
    return hasLimits(fabric) && least > 0 ? std::optional(least) : std::nullopt;
}

void CutProposals::ask(AdviceQuestion question) {
    if (!shaper_ || shaper_->piece() != question.piece) {
        shaper_ = std::make_unique<CutShaper>(question.piece);
    }
    question_ = std::move(question);
    problem_.clear();
    cancelSolving();
    asking_.forget();
    soon_.stop();
    moving_.reset();
    moves_.clear();
    awaited_ = 0;
    if (piece()->defect && !isOpenable(*piece())) {
        problem_ =
            tr("No cuts can be proposed for this piece. %1").arg(errorText(*piece()->defect));
        take({});
        return;
    }
    state_ = State::Asking;
    asking_.ask(question_);
    emit changed();
}

void CutProposals::take(const CutAdvice& advice) {
    state_ = State::Known;
    put(advice);
    solve();
}

void CutProposals::put(const CutAdvice& advice) {
    advice_ = advice;
    for (AdvisedCut& cut : advice_.cuts) {
        cut.what.cut.name = proposedName(cut.what.cut.name);
        cut.what.cut.evidence = wordingText(cut.evidence).toStdString();
    }
    markNeeded(advice_, enough());  // the strain may have been stated since
    advised_ = advice_.cuts;
    lines_ = linesOf(advice_);
    moving_.reset();
    moves_.clear();
    awaited_ = 0;
    staleFrom_ = lines_.size();
    taken_.clear();
    for (const AdvisedCut& cut : advice_.cuts) {
        taken_.push_back(cut.isNeeded && !isDeclined(cut.what.cut.name) ? 1 : 0);
    }
    selected_.reset();
    emit changed();
    emit selectionChanged();
}

void CutProposals::solve() {
    if (state_ != State::Known || awaited_ > 0) {
        return;
    }
    cancelSolving();
    for (std::size_t k = 0; k < std::min(kSolvedAhead, advice_.cuts.size()); ++k) {
        if (!advice_.cuts[k].solved) {
            counts_.push_back(k + 1);
        }
    }
    if (!counts_.empty()) {
        trial_ = {std::make_shared<const std::pair<AdviceQuestion, CutAdvice>>(question_, advice_),
                  document_.options()};
        solveNext();
        emit changed();
    }
}

void CutProposals::solveNext() {
    if (!counts_.empty()) {
        trial_.count = counts_.front();
        solving_.ask(trial_);
    }
}

void CutProposals::takeSolved(std::size_t count, const StrainFigures& figures) {
    const std::size_t cut = count - 1;
    advice_.cuts[cut].solved = figures;
    if (!isStale(cut)) {
        advised_[cut].solved = figures;
    }
}

void CutProposals::cancelSolving() {
    counts_.clear();
    solving_.forget();
}

void CutProposals::onChanged(const DocumentChange& what) {
    if (nameOf_ && document_.isCurrent()) {
        // After all listeners have handled this change.
        QMetaObject::invokeMethod(this, &CutProposals::nameParts, Qt::QueuedConnection);
    }
    if (!isOpen()) {
        return;
    }
    if (!document_.garment()) {
        close();
    } else if (what.hasOtherPieces()) {
        follow();
    } else if (awaited_ > 0 && document_.isCurrent()) {  // it was refused
        ask(question_);
    } else if (what.touches(&DocumentState::fabric) && !stated_) {
        stateEnough(std::nullopt);
    }
}

void CutProposals::follow() {
    auto now = wholeWith(*document_.garment(), piece()->id);
    if (!now) {
        close();
        return;
    }
    now->options = question_.options;
    // Only the cut applied here is new: the other proposals stay.
    const bool isOurs = now->piece == piece() && now->own.size() == question_.own.size() + awaited_;
    if (*now == question_) {
        return;
    }
    if (isOurs && awaited_ > 0 && hasMoves()) {
        awaited_ = 0;
        question_ = std::move(*now);
        solve();
    } else {
        ask(std::move(*now));
    }
}

void CutProposals::setTaken(std::size_t cut, bool taken) {
    if (isTaken(cut) == taken) {
        return;
    }
    taken_[cut] = taken ? 1 : 0;
    std::erase(declined_, lines_[cut].name);
    if (!taken) {
        declined_.push_back(lines_[cut].name);
    }
    emit changed();
}

bool CutProposals::isDeclined(const std::string& name) const {
    return std::ranges::find(declined_, name) != declined_.end();
}

std::size_t CutProposals::takenCount() const {
    return static_cast<std::size_t>(std::ranges::count(taken_, 1));
}

void CutProposals::select(std::optional<std::size_t> cut) {
    if (cut != selected_) {
        selected_ = cut;
        emit selectionChanged();
    }
}

void CutProposals::stateEnough(std::optional<double> strain) {
    stated_ = strain;
    if (!isOpen()) {
        return;
    }
    question_.options.enoughStrain = stated_ ? stated_ : fabricLimit();
    const std::vector<AdvisedCut> before = advice_.cuts;
    markNeeded(advice_, enough());
    for (std::size_t k = 0; k < before.size(); ++k) {
        const AdvisedCut& cut = advice_.cuts[k];
        if (cut.isNeeded != before[k].isNeeded) {
            taken_[k] = cut.isNeeded && !isDeclined(cut.what.cut.name) ? 1 : 0;
        }
    }
    emit changed();
}

void CutProposals::swapFront() {
    if (isOpen()) {
        AdviceQuestion question = question_;
        question.options.isFrontSwapped = !question.options.isFrontSwapped;
        ask(std::move(question));
    }
}

void CutProposals::makeTaken() {
    if (state_ != State::Known || takenCount() == 0) {
        return;
    }
    std::vector<UserCut> cuts;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
        if (isTaken(k)) {
            cuts.push_back(lines_[k]);
        }
    }
    awaitParts();
    close();
    workspace_.cuts().makeAll(tr("Make proposed cuts"), std::move(cuts), gesture_);
}

void CutProposals::awaitParts() {
    cutPiece_ = piece()->id;
    nameOf_ = advice_.nameOf;
    gesture_ = document_.newGesture();
}

void CutProposals::nameParts() {
    if (!document_.isCurrent()) {
        return;  // edited since: wait for the next garment
    }
    const auto nameOf = std::exchange(nameOf_, nullptr);
    const auto garment = document_.garment();
    const QUndoStack& history = document_.history();
    const auto* step = history.command(history.index() - 1);
    if (!nameOf || !garment || !step || step->id() != gesture_) {
        return;  // undone, or followed by another step
    }
    const auto record = std::ranges::find(garment->cutRecords, cutPiece_,
                                          [](const CutRecord& one) { return one.whole->id; });
    if (record == garment->cutRecords.end() || record->pieces.size() < 2) {
        return;
    }
    const std::string prefix = garment->uncut.size() > 1 ? record->whole->name + ", " : "";
    DocumentState next = document_.state();
    for (std::size_t k = 0; k < garment->pieces.size(); ++k) {
        const auto& piece = garment->pieces[k];
        if (std::ranges::find(record->pieces, piece) == record->pieces.end()) {
            continue;
        }
        if (const std::string name = nameOf(*piece); !name.empty()) {
            next.labels = withName(std::move(next.labels), *garment, static_cast<int>(k),
                                   prefix + proposedPartName(name));
        }
    }
    document_.edit(step->text(), std::move(next), gesture_);
}

void CutProposals::make(std::size_t cut) {
    if (state_ != State::Known) {
        return;
    }
    const UserCut made = lines_[cut];
    cancelMove();
    remove(cut);
    ++awaited_;
    awaitParts();
    workspace_.cuts().makeAll(tr("Cut along %1").arg(QString::fromStdString(made.name)), {made},
                              gesture_);
}

void CutProposals::remove(std::size_t cut) {
    cancelSolving();
    const auto at = static_cast<std::ptrdiff_t>(cut);
    if (cut == 0) {
        advice_.before = advice_.cuts[0].predicted;
    }
    for (std::size_t k = 0; k < cut; ++k) {  // those before it were flattened without it
        advice_.cuts[k].solved.reset();
        advised_[k].solved.reset();
    }
    const auto drop = [at](auto& list) { list.erase(list.begin() + at); };
    drop(advice_.cuts);
    drop(lines_);
    drop(advised_);
    drop(taken_);
    for (auto& lines : moves_) {
        drop(lines);
    }
    for (std::size_t k = moves_.size(); k-- > 0;) {  // drop moves of the removed cut alone
        if (moves_[k] == (k + 1 < moves_.size() ? moves_[k + 1] : lines_)) {
            moves_.erase(moves_.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }
    staleFrom_ = firstOther(lines_);
    selected_.reset();
    emit changed();
    emit selectionChanged();
}

std::size_t CutProposals::firstOther(const std::vector<UserCut>& lines) const {
    const auto isAdvised = [](const UserCut& line, const AdvisedCut& cut) {
        return line == cut.what.cut;
    };
    return static_cast<std::size_t>(std::ranges::mismatch(lines, advised_, isAdvised).in1 -
                                    lines.begin());
}

void CutProposals::setLines(std::vector<UserCut> lines) {
    const std::size_t first =
        static_cast<std::size_t>(std::ranges::mismatch(lines, lines_).in1 - lines.begin());
    lines_ = std::move(lines);
    staleFrom_ = firstOther(lines_);
    for (std::size_t k = first; k < lines_.size(); ++k) {
        AdvisedCut& cut = advice_.cuts[k];
        const AdvisedCut& advised = advised_[k];
        const bool isMoved = lines_[k] != advised.what.cut;
        if (isMoved && cut.what.cut != lines_[k]) {
            cut.length = lengthAlong(lines_[k]);
            cut.intake.reset();
        } else if (!isMoved) {
            cut.length = advised.length;
            cut.intake = advised.intake;
        }
        cut.what.cut = lines_[k];
        cut.solved = isStale(k) ? std::nullopt : advised.solved;
    }
    cancelSolving();
    soon_.start();
    emit changed();
}

void CutProposals::beginMove(std::size_t cut, int point) {
    moving_ = Moving{cut, point, lines_};
}

void CutProposals::moveTo(const Eigen::Vector3d& place) {
    if (moving_ && shaper_) {
        std::vector<UserCut> lines = moving_->before;
        shaper_->move(lines, moving_->cut, moving_->point, place);
        moving_->hasMoved = true;
        setLines(std::move(lines));
    }
}

void CutProposals::endMove() {
    if (moving_ && moving_->hasMoved && moving_->before != lines_) {
        moves_.push_back(std::move(moving_->before));
    }
    moving_.reset();
    emit changed();
}

void CutProposals::cancelMove() {
    if (moving_ && moving_->hasMoved) {
        setLines(std::move(moving_->before));
    }
    moving_.reset();
}

bool CutProposals::takeMoveBack() {
    if (moves_.empty()) {
        return false;
    }
    cancelMove();
    std::vector<UserCut> before = std::move(moves_.back());
    moves_.pop_back();
    setLines(std::move(before));
    return true;
}

}  // namespace toile::app
