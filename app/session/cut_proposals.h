// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/base/worker.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/garment.h"
#include "core/tailor/cut_advice.h"
#include "core/tailor/handles.h"

namespace toile::app {

class Document;
class DocumentChange;
class Workspace;

/// A piece to propose cuts for.
struct AdviceQuestion {
    std::shared_ptr<const Piece> piece{};
    std::vector<UserCut> own{};                ///< cuts that are made in any case, mm
    std::shared_ptr<const SourceFile> file{};  ///< of the piece; cuts follow its borders
    AdviceOptions options{};                   ///< without borders

    bool operator==(const AdviceQuestion&) const = default;
};

/// Cuts that Toile proposes for one piece: the figures of each cut, ticks, selection, and moved
/// handles. None of this is in the history; cuts that are made become the user's own. Computes new
/// proposals when the garment is edited, and closes when the piece is gone. GUI thread only.
class CutProposals : public QObject {
    Q_OBJECT

public:
    enum class State { Closed, Asking, Known };

    explicit CutProposals(Workspace& workspace);
    ~CutProposals() override;

    /// Proposes cuts for the selected piece, else for the first that cannot lie flat, else for the
    /// largest; for the whole piece if it was cut. Does nothing if no garment is open. There is a
    /// `problem` if no cut can open the piece.
    void open();
    void close();

    State state() const { return state_; }
    bool isOpen() const { return state_ != State::Closed; }
    /// The piece before its cuts; null if closed.
    const std::shared_ptr<const Piece>& piece() const { return question_.piece; }
    /// The name of the piece.
    QString pieceName() const;
    double fraction() const { return asking_.progress() ? asking_.progress()->fraction() : 0; }
    bool isSolving() const { return !counts_.empty(); }
    /// Why there are no proposals; usually empty.
    const QString& problem() const { return problem_; }

    /// The proposals in their order, with moved handles.
    const CutAdvice& advice() const { return advice_; }
    /// Only their cuts.
    const std::vector<UserCut>& lines() const { return lines_; }
    bool isTaken(std::size_t cut) const { return taken_[cut]; }
    void setTaken(std::size_t cut, bool taken);
    std::size_t takenCount() const;
    /// True if the line has moved since its figures were predicted.
    bool isStale(std::size_t cut) const { return cut >= staleFrom_; }
    const std::optional<std::size_t>& selected() const { return selected_; }
    void select(std::optional<std::size_t> cut);

    /// The strain to stop at: the stated one, else the smaller limit of the fabric, if known.
    std::optional<double> enough() const { return question_.options.enoughStrain; }
    const std::optional<double>& statedEnough() const { return stated_; }
    /// Ticks the cuts needed for it, without a new search; moved handles stay.
    void stateEnough(std::optional<double> strain);
    bool isFrontSwapped() const { return question_.options.isFrontSwapped; }
    void swapFront();

    /// Makes the ticked cuts as one step of the history, and closes.
    void makeTaken();
    /// Applies one cut as a step of its own; the other proposals stay.
    void make(std::size_t cut);

    /// Moves handles; null if closed.
    const CutShaper* shaper() const { return shaper_.get(); }
    /// Begins a drag; each `moveTo` starts from there. @param point  of the cut
    void beginMove(std::size_t cut, int point);
    void moveTo(const Eigen::Vector3d& place);
    void endMove();
    void cancelMove();
    bool isMoving() const { return moving_.has_value(); }
    bool hasMoves() const { return !moves_.empty(); }
    /// Undoes the last move of a handle. @return false if there is none
    bool takeMoveBack();

signals:
    /// Show the proposals, or bring them to the front.
    void opened();
    void closed();
    /// Proposals, figures, lines or ticks have changed.
    void changed();
    /// The selection has changed.
    void selectionChanged();

private:
    struct Moving {
        std::size_t cut;
        int point;
        std::vector<UserCut> before;
        bool hasMoved = false;
    };

    /// The piece to flatten with the first `count` cuts made.
    struct Trial {
        std::shared_ptr<const std::pair<AdviceQuestion, CutAdvice>> cuts;
        FlattenOptions options{};
        std::size_t count = 0;

        bool operator==(const Trial&) const = default;
    };

    void onChanged(const DocumentChange& what);
    void follow();
    void ask(AdviceQuestion question);
    void take(const CutAdvice& advice);
    void put(const CutAdvice& advice);
    /// Makes these the lines of the proposals.
    void setLines(std::vector<UserCut> lines);
    void solve();
    void solveNext();
    void takeSolved(std::size_t count, const StrainFigures& figures);
    void cancelSolving();
    /// The parts of the piece get the names that the proposal has for them, when they exist.
    void awaitParts();
    /// In the same step of the history as the cuts.
    void nameParts();
    void remove(std::size_t cut);
    bool isDeclined(const std::string& name) const;
    std::optional<double> fabricLimit() const;
    /// The first line that was moved.
    std::size_t firstOther(const std::vector<UserCut>& lines) const;

    Workspace& workspace_;
    Document& document_;
    State state_ = State::Closed;
    AdviceQuestion question_;
    std::optional<double> stated_;
    CutAdvice advice_;
    std::vector<UserCut> lines_;
    std::vector<AdvisedCut> advised_;  ///< as proposed, before any handle was moved
    std::vector<char> taken_;
    std::vector<std::string> declined_;  ///< names of unticked ones
    std::optional<std::size_t> selected_;
    std::size_t staleFrom_ = 0;
    QString problem_;
    std::unique_ptr<CutShaper> shaper_;
    std::optional<Moving> moving_;
    std::vector<std::vector<UserCut>> moves_;  ///< the lines before each
    std::size_t awaited_ = 0;                  ///< applied cuts that the garment does not have yet
    PieceId cutPiece_{};                       ///< whose parts get names
    std::function<std::string(const Piece&)> nameOf_;  ///< of a part; null: none is awaited
    int gesture_ = -1;                                 ///< of the step that cut it
    QTimer soon_;
    Trial trial_;
    std::vector<std::size_t> counts_;  ///< to flatten, the next one first
    Follower<AdviceQuestion, CutAdvice> asking_;
    Follower<Trial, Result<StrainFigures>> solving_;
};

}  // namespace toile::app
