// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/cut_adviser.h"
#include "app/session/part_naming.h"
#include "core/tailor/handles.h"

namespace toile::app {

class Document;
class DocumentChange;
class Workspace;

/// Cuts that Toile proposes for one piece, from when a person asks for them until they are closed:
/// what is known of each, which are to be made, which is selected, and where handles have been
/// moved. None of it is a step of the history: what is not made leaves no trace. What is made is
/// the user's. Follows edits of the garment: asks again while the piece is there, else closes.
/// GUI thread only.
class CutProposals : public QObject {
    Q_OBJECT

public:
    enum class State { Closed, Asking, Known };

    explicit CutProposals(Workspace& workspace);
    ~CutProposals() override;

    /// Asks for the selected piece, else for the first that cannot lie flat, else for the largest;
    /// of one that was cut for the whole of it. Nothing where no garment is open. What no cut can
    /// open has a `problem`.
    void open();
    void close();

    State state() const { return state_; }
    bool isOpen() const { return state_ != State::Closed; }
    /// As it is before the cuts; null where closed.
    const std::shared_ptr<const Piece>& piece() const { return question_.piece; }
    /// As it is called.
    QString pieceName() const;
    double fraction() const { return adviser_.fraction(); }
    bool isSolving() const { return adviser_.isSolving(); }
    /// Why nothing is known; mostly empty.
    const QString& problem() const { return problem_; }

    /// In the order in which they were advised, as moved by hand.
    const CutAdvice& advice() const { return advice_; }
    /// The same as cuts alone.
    const std::vector<UserCut>& lines() const { return lines_; }
    bool isTaken(std::size_t cut) const { return taken_[cut]; }
    void setTaken(std::size_t cut, bool taken);
    std::size_t takenCount() const;
    /// Whether the predicted figures are about lines that have been moved since.
    bool isStale(std::size_t cut) const { return cut >= staleFrom_; }
    const std::optional<std::size_t>& selected() const { return selected_; }
    void select(std::optional<std::size_t> cut);

    /// The strain that is enough: the stated one, else the fabric's least limit where one is known.
    std::optional<double> enough() const { return question_.options.enoughStrain; }
    const std::optional<double>& statedEnough() const { return stated_; }
    /// Ticks what is needed for it; nothing is searched for, and moved handles stay.
    void stateEnough(std::optional<double> strain);
    bool isFrontSwapped() const { return question_.options.isFrontSwapped; }
    void swapFront();

    /// Makes those to be made, as one step of the history, and closes.
    void makeTaken();
    /// Makes one alone, as a step of its own; the others stay.
    void make(std::size_t cut);

    /// Moves handles; null where closed.
    const CutShaper* shaper() const { return shaper_.get(); }
    /// What a drag begins with; each `moveTo` moves from there. @param point  of the cut
    void beginMove(std::size_t cut, int point);
    void moveTo(const Eigen::Vector3d& place);
    void endMove();
    void cancelMove();
    bool isMoving() const { return moving_.has_value(); }
    bool hasMoves() const { return !moves_.empty(); }
    /// Takes the last move of a handle back. @return false where there is none
    bool takeMoveBack();

signals:
    /// There are proposals to be shown, or to be looked at again.
    void opened();
    void closed();
    /// Other proposals, figures or lines, or others are to be made.
    void changed();
    /// Another one is selected.
    void selectionChanged();

private:
    struct Moving {
        std::size_t cut;
        int point;
        std::vector<UserCut> before;
        bool hasMoved = false;
    };

    void onChanged(const DocumentChange& what);
    void follow();
    void ask(AdviceQuestion question);
    void take(const CutAdvice& advice);
    void put(const CutAdvice& advice);
    /// Takes these lines over as those of the advice.
    void setLines(std::vector<UserCut> lines);
    void solve();
    void remove(std::size_t cut);
    bool isDeclined(const std::string& name) const;
    std::optional<double> fabricLimit() const;
    /// The first that is not as it was advised.
    std::size_t firstOther(const std::vector<UserCut>& lines) const;

    Workspace& workspace_;
    Document& document_;
    State state_ = State::Closed;
    AdviceQuestion question_;
    std::optional<double> stated_;
    CutAdvice advice_;
    std::vector<UserCut> lines_;
    std::vector<AdvisedCut> advised_;  ///< as they were before any handle was moved
    std::vector<char> taken_;
    std::vector<std::string> declined_;  ///< names of those that are not to be made
    std::optional<std::size_t> selected_;
    std::size_t staleFrom_ = 0;
    QString problem_;
    std::unique_ptr<CutShaper> shaper_;
    std::optional<Moving> moving_;
    std::vector<std::vector<UserCut>> moves_;  ///< the lines before each
    std::size_t awaited_ = 0;  ///< cuts that were made here and are not in the garment yet
    PartNaming names_;
    QTimer soon_;
    CutAdviser adviser_;
};

}  // namespace toile::app
