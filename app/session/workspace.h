// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/document/document.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/reference_finder.h"
#include "app/session/cut_editor.h"
#include "app/session/opening.h"
#include "app/session/recompute.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/formats.h"

namespace toile::app {

class CutProposals;
class PatternProof;

/// Whether the pattern is that of the garment: if not, whether an update is running.
enum class PatternAge { UpToDate, Renewed, OutOfDate };

/// What a person can ask of the open garment, without any widget: opening, cutting, flattening,
/// writing. All that is asked for becomes a step of the document's history at once; what follows
/// from it is worked out by one job (Recompute). Reading files comes before that: what is to be
/// opened (Opening), or read again; steps of the history do not disturb it. A reading that is
/// cancelled or fails leaves the garment as it was. Files are written beside all this. GUI thread
/// only.
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
    /// That which sews the pattern, as it was when it was begun.
    JobRunner& proving() { return proving_; }
    /// All of them.
    std::vector<JobRunner*> runners() { return {&cuts_.searches(), &jobs_, &proving_, &writing_}; }
    bool isBusy() { return std::ranges::any_of(runners(), &JobRunner::isBusy); }
    /// The person wants what is running stopped: cuts that are not made yet, else what changes the
    /// document, else what is sewn, else what is written.
    void cancel();
    /// Takes the last step back; where cuts are not made yet, the last of these; where proposed
    /// cuts were moved, the last move.
    void undo();
    bool canUndo() const;
    /// Calls it once what is being written is written, and not where that fails; at once where
    /// nothing is. A later call takes the place of an earlier one.
    void whenWritten(std::function<void()> then);
    /// Cancels, writes to the end and waits: nothing is heard of the jobs any more.
    void shutdown();
    /// True while another garment is being read, to replace the open one.
    bool isOpening() const { return opening_.isActive(); }
    /// How files are read, divided and cut; of those that are being read, if any are.
    const LoadOptions& loading() const;
    /// A change of how files are read, divided and cut.
    struct LoadingChange {
        QString text;
        std::function<void(LoadOptions&)> change;
        int gesture = -1;  ///< as for Document::edit
    };
    void changeLoading(LoadingChange change);
    /// The files of the document's garment.
    Paths openPaths() const;

    /// Reads the files as one garment and flattens it. Whatever ran before is cancelled. Files
    /// other than those before begin anew: the unit, the up axis, what the files are, cuts and ease
    /// that were stated, and what automatic cuts were told, were said about another garment.
    void open(Paths files);
    /// How the lines of garments that are opened from now on are drawn; a project says so itself.
    void setNewLines(LineSettings lines) { newLines_ = std::move(lines); }
    /// Runs a job that reads what is to be opened and, when it is done, calls one of the two that
    /// follow. Whatever ran before is cancelled; changes of the reading wait until it is open.
    void openBy(std::unique_ptr<Job> reading);
    /// @param open  makes what was read the document; called at once, or not before the person has
    ///              agreed to lose what was edited while it was read (`askBeforeLeaving`)
    void arrived(std::function<void()> open);
    void notOpened();
    /// What asks whether the open garment may go, and calls its argument where it may.
    void askBeforeLeaving(Opening::Ask ask) { opening_.setAsk(std::move(ask)); }
    /// Reads the open garment's files again, as they are on the disk now.
    void reload();
    /// Reads an open garment again with these options.
    void setLoading(LoadOptions loading);
    /// Unit of the files; none: guessed. Reads an open garment again where that is a change.
    void setUnit(std::optional<FileUnit> unit);
    /// The axis that points up in the files; none: guessed. As setUnit.
    void setUpAxis(std::optional<UpAxis> up);
    /// What the files are, and what is done with them before. As setUnit.
    void setPreparing(Preparation preparing);
    /// The same while a person tries values: one step of the history. @param gesture  as for
    /// Document::edit
    void tryPreparing(Preparation preparing, int gesture);
    /// By what files are divided. As setUnit.
    void setSplit(SplitMode split);
    /// Whether pieces that are no disks are cut open. As setUnit.
    void setAutoCut(bool on);
    /// As tailors do also makes automatic cuts where there were none.
    void setCutStyle(CutStyle style);
    /// Whether vertices that lie on each other are joined. As setUnit.
    void setWeld(bool on);
    /// Whether both sides of the slits inside pieces are made one. As setUnit.
    void setCloseSlits(bool on);
    /// Reads the pattern that the pieces are to be compared with, and shows it over them. Nothing
    /// changes where it cannot be read, where nothing is open, or while something is being opened.
    /// @param path  absolute
    void openReference(const std::filesystem::path& path);
    /// Compares with no pattern any more.
    void closeReference();
    /// The cuts and joins that the user asks for.
    CutEditor& cuts() { return cuts_; }
    /// The cuts that Toile proposes.
    CutProposals& proposals() { return *proposals_; }
    /// The pattern sewn back together.
    PatternProof& proof() { return *proof_; }
    void setMethod(Method method);
    void setQuality(Quality quality);
    void setBoundarySolver(BoundarySolver solver);

    /// Flattens all pieces, those that are flat already too. While a garment is being read or cut,
    /// flattening follows by itself.
    void flattenAgain();
    /// Whether edits are followed by a flattening of what they changed; on at first. Opening is
    /// always.
    void setAutoFlatten(bool on);
    bool autoFlatten() const { return recompute_.isAutomatic(); }
    /// Holds flattening back while a person tries values that change the whole garment, until it is
    /// let go, or asked for.
    void holdFlattening(bool held);
    /// How the pattern stands to what was edited since.
    PatternAge patternAge() const;
    /// True where there are results to write, and a flat piece among them.
    bool canExport() const;
    /// Writes the pattern as it is now, whatever is edited meanwhile; several one after the other.
    /// Requires canExport. The ending chooses the format.
    /// @param only  the pieces that are written; none: all, here and in the two below
    void exportTo(const std::filesystem::path& path, const ExportOptions& options = {},
                  const Document::Selection& only = {});
    /// The beginning of the file as it would be written now. Requires canExport.
    JobRunner::Ticket beginFile(FormatId format, const ExportOptions& options,
                                const Document::Selection& only,
                                std::function<void(const std::string&)> done);
    /// Draws it as files and paper would have it. Requires canExport.
    JobRunner::Ticket drawPattern(std::function<void(std::shared_ptr<const DrawnPattern>)> done,
                                  const Document::Selection& only = {});

signals:
    /// `patternAge` has changed.
    void patternAged(toile::app::PatternAge age);
    /// `loading` has changed.
    void loadingChanged();
    /// @param checked  what reading it again has found, for a person; may be empty
    void exported(const QString& path, const QString& checked);
    /// What was asked for cannot be done, and why; nothing has changed.
    void refused(const QString& sentence);
    /// Something was done otherwise than might be expected.
    void noted(const QString& sentence);

private:
    void startOpening();
    void startReading(std::unique_ptr<Job> job);
    /// Nothing is read any more: the garment is as it was.
    void stopReading();
    bool isReading() const { return opening_.isActive() || jobs_.isUnderWay(reading_); }
    /// Works out what is not there, unless something is being read.
    void follow();
    void followAge();

    template <class Value>
    void setLoadingField(const QString& text, Value LoadOptions::*field, const Value& value);

    template <class Value>
    void setOption(const QString& text, Value FlattenOptions::*field, Value value);
    void onChanged(const DocumentChange& what);
    void onStopped(bool failed);

    Document document_;
    JobRunner jobs_, proving_, writing_;
    std::function<void()> afterWriting_;
    Recompute recompute_{document_, jobs_};
    ReferenceFinder reference_{document_};
    Opening opening_;
    CutEditor cuts_{*this};
    LineSettings newLines_{};
    /// For what is being opened, where that is not known before it is there.
    std::vector<LoadingChange> forOpening_;
    JobRunner::Ticket reading_ = 0;
    int step_ = 0;                           ///< of the history
    PatternAge age_ = PatternAge::UpToDate;  ///< as it was told last
    std::unique_ptr<CutProposals> proposals_;
    std::unique_ptr<PatternProof> proof_;
};

}  // namespace toile::app
