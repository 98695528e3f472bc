// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/actions/history_budget.h"
#include "app/actions/opening.h"
#include "app/actions/upkeep.h"
#include "app/document/document.h"
#include "app/jobs/job_runner.h"

namespace toile {

struct MadeGarment;

/// What a person can ask of the open garment, without any widget: opening, cutting, flattening,
/// writing. What is quick becomes a step of the document's history at once; what is slow a job,
/// and a step when that is done. Of the jobs that make the document what it is, one at a time is
/// wanted, the first of these that there is:
///
///     reading     what is to be opened (Opening); steps of the history do not disturb it
///     granting    the first of the wishes that wait; a step begins it anew
///     following   what the present state lacks, flat pieces or a scene (Upkeep)
///
/// A reading or a wish that is cancelled or fails leaves the garment as it was, and what it had
/// taken the place of follows. Files are written beside all this. GUI thread only.
class Workspace : public QObject {
    Q_OBJECT

public:
    using Paths = Opening::Paths;

    explicit Workspace(QObject* parent = nullptr);
    ~Workspace() override;

    Document& document() { return document_; }
    /// The jobs that make the document what it is.
    JobRunner& jobs() { return jobs_; }
    /// Those that write files of it, as it was when they were begun: no edit touches them.
    JobRunner& writing() { return writing_; }
    /// The person wants what is running stopped: what changes the document, else what is written.
    void cancel();
    /// Calls it once what is being written is written, and not where that fails; at once where
    /// nothing is. A later call takes the place of an earlier one.
    void whenWritten(std::function<void()> then);
    /// Cancels, writes to the end and waits: nothing is heard of the jobs any more.
    void shutdown();
    /// How files are read, divided and cut, all wishes that wait included.
    LoadOptions loading() const;
    /// The files of the document's garment.
    Paths openPaths() const;

    /// Reads the files as one garment and flattens it. Whatever ran before is cancelled. Files
    /// other than those before begin anew: the unit, the up axis, cuts and ease that were stated
    /// were said about another garment.
    void open(Paths files);
    /// Runs a job that reads what is to be opened and, when it is done, calls one of the two that
    /// follow. Whatever ran before is cancelled; changes of the reading wait until it is open.
    void openBy(std::unique_ptr<Job> reading);
    /// @param open  makes what was read the document; called at once, or not before the person has
    ///              agreed to lose what was edited while it was read (`askBeforeLeaving`)
    void arrived(std::function<void()> open);
    void notOpened();
    /// What asks whether the open garment may go, and calls its argument where it may.
    void askBeforeLeaving(Opening::Ask ask) { opening_.setAsk(std::move(ask)); }
    /// Whether a change of the open garment is on its way that is no step of the history yet.
    bool hasWishes() const { return !wishes_.empty() && !opening_.isActive(); }
    /// Reads the open garment's files again, as they are on the disk now.
    void reload();
    /// Reads an open garment again with these options.
    void setLoading(LoadOptions loading);
    /// Unit of the files; none: guessed. Reads an open garment again where that is a change.
    void setUnit(std::optional<LengthUnit> unit);
    /// The axis that points up in the files; none: guessed. As setUnit.
    void setUpAxis(std::optional<UpAxis> up);
    /// By what files are divided. As setUnit.
    void setSplit(SplitMode split);
    /// Whether pieces that are no disks are cut open. As setUnit.
    void setAutoCut(bool on);
    /// Whether vertices that lie on each other are joined. As setUnit.
    void setWeld(bool on);
    /// Changes cuts and ease; pieces that no change touches stay as they are, flat or not.
    /// Changes follow one another: one that is asked for while another is on its way waits for it.
    /// @param text  what was done, for the undo menu
    void changeSeams(const QString& text, std::function<void(SeamsFile&)> change);
    /// Takes cuts and ease from a seams file. Nothing changes where it cannot be read.
    /// @return notes: what of it is not known
    Result<Problems> readSeams(const std::filesystem::path& path);
    /// Writes the cuts and the ease that were stated as a seams file.
    Result<void> writeSeams(const std::filesystem::path& path) const;
    /// Makes a cut, the name aside, which it gets here: "cut 3", "dart 1". One that cannot be made,
    /// or would open nothing, is `refused` and leaves no step.
    /// @param cut  its points in mm, as the pieces are
    void addCut(UserCut cut);
    /// Joins the cloth on both sides of a seam: a cut of the user's is taken back, two pieces that
    /// the garment's division made become one. What cannot be is `refused`: the edge of a hem, a
    /// cut of Toile's own, sides that do not fit vertex by vertex.
    /// @param seam an index into Garment::seams
    void joinSeam(int seam);
    /// Takes a cut of the user's back.
    void removeCut(CutId id);
    /// Takes a join back, the first of this name: the seam is there again.
    void removeJoin(const std::string& name);
    /// Says how much longer a seam's left side is meant to be, as a part of the right; none: as
    /// the 3D lengths have it. Nothing is read or flattened again; a later reading keeps it.
    void setEase(int seam, std::optional<double> ease);
    void setMethod(Method method);
    void setQuality(Quality quality);
    void setBoundarySolver(BoundarySolver solver);

    /// Takes the last step back, or what was asked for last and is still on its way.
    void undo();
    void redo();
    bool canUndo() const;
    bool canRedo() const;
    /// What `undo` would take back.
    QString undoText() const;
    /// What old states may take in memory (HistoryBudget).
    HistoryBudget& historyBudget() { return budget_; }

    /// Flattens all pieces, those that are flat already too. While a garment is being read or cut,
    /// flattening follows by itself.
    void flattenAgain();
    /// Whether edits are followed by a flattening of what they changed; on at first. Opening is
    /// always.
    void setAutoFlatten(bool on);
    bool autoFlatten() const { return upkeep_.isAutomatic(); }
    /// True where there are results to write.
    bool canExport() const;
    /// Writes the pattern as it is now, whatever is edited meanwhile; several one after the other.
    /// Requires canExport. The ending chooses the format.
    void exportTo(const std::filesystem::path& path);

signals:
    /// `loading` is another now, or another wish is on its way, or none.
    void loadingChanged();
    void exported(const QString& path);
    /// What was asked for cannot be done, and why; nothing has changed.
    void refused(const QString& sentence);

private:
    /// A change of the reading options that takes a job. The first in the queue is on its way.
    struct Wish {
        QString text;
        std::function<void(LoadOptions&)> change;
        bool reads;  ///< also where the options are the same
        /// What is wrong with what came of it, so that it is not to be; may be empty.
        std::function<std::optional<Error>(const Garment&)> objection{};
    };

    void startOpening();
    /// Nothing is read any more and no wish waits: the garment is as it was.
    void stopChanging();
    /// Whether there is a reading or a wish.
    bool isChanging() const { return opening_.isActive() || !wishes_.empty(); }
    /// Runs a job for a reading or a wish in place of whatever runs.
    void begin(std::unique_ptr<Job> job);
    /// Begins what comes next, unless something is on its way.
    void follow();

    /// Without cuts there is nothing to divide by.
    static void divideByWhatIsThere(LoadOptions& loading);
    void wish(Wish wish);
    template <class Value>
    void wishFor(const QString& text, Value LoadOptions::*field, const Value& value);
    void grantWish();
    void onGranted(const LoadOptions& loading, MadeGarment made);

    void changeOptions(const QString& text, const FlattenOptions& options);
    void onChanged(DocumentChanges what);
    void onFailed();
    void onCancelled();

    Document document_;
    HistoryBudget budget_{document_};
    JobRunner jobs_{document_};
    JobRunner writing_{document_};
    std::function<void()> afterWriting_;
    Upkeep upkeep_{document_, jobs_};
    Opening opening_;
    std::deque<Wish> wishes_;
    JobRunner::Ticket change_ = 0;  ///< the reading, or the granting of the first wish
};

}  // namespace toile
