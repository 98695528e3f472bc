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

/// Whether the pattern is up to date with the garment; if not, whether an update is running.
enum class PatternAge { UpToDate, Renewed, OutOfDate };

/// Everything that the user can do with the open garment, without widgets: open, cut, flatten,
/// write. Each request is one step of the document's history at once, and one job derives what
/// follows from it (Recompute). Reading files comes first (Opening, `reload`): steps of the history
/// do not disturb it, and if it is cancelled or fails, the garment stays. Files are written beside
/// all this. GUI thread only.
class Workspace : public QObject {
    Q_OBJECT

public:
    using Paths = Opening::Paths;

    explicit Workspace(QObject* parent = nullptr);
    ~Workspace() override;

    Document& document() { return document_; }
    /// Jobs that read and derive the document.
    JobRunner& jobs() { return jobs_; }
    /// Jobs that write files of the document as it was when they began.
    JobRunner& writing() { return writing_; }
    /// The job that sews the pattern as it was when it began.
    JobRunner& proving() { return proving_; }
    /// All runners.
    std::vector<JobRunner*> runners() { return {&cuts_.searches(), &jobs_, &proving_, &writing_}; }
    bool isBusy() { return std::ranges::any_of(runners(), &JobRunner::isBusy); }
    /// Cancels searches for cuts, else jobs that change the document, else sewing, else writing.
    void cancel();
    /// Undoes the last request: the last cut that is still searched for, else the last moved handle
    /// of a proposed cut, else the last step.
    void undo();
    bool canUndo() const;
    /// Calls `then` after all files are written, but not if that fails; at once if nothing is
    /// being written. A later call replaces an earlier one.
    void whenWritten(std::function<void()> then);
    /// Cancels all jobs, finishes writing and waits; nothing is announced any more.
    void shutdown();
    /// True while another garment is being read to replace the open one.
    bool isOpening() const { return opening_.isActive(); }
    /// How files are read, divided and cut; for the files that are being read, if any.
    const LoadOptions& loading() const;
    /// A change of how files are read, divided and cut.
    struct LoadingChange {
        QString text;
        std::function<void(LoadOptions&)> change;
        int gesture = -1;  ///< as for Document::edit
    };
    void changeLoading(LoadingChange change);
    /// Files of the open garment.
    Paths openPaths() const;

    /// Reads the files as one garment and flattens it. Cancels whatever is running. Other files
    /// start with default settings of reading: unit, up axis, kind of files, cuts, ease and
    /// automatic cuts of the previous garment are cleared.
    void open(Paths files);
    /// How lines of newly opened garments are drawn; projects have their own setting.
    void setNewLines(LineSettings lines) { newLines_ = std::move(lines); }
    /// Runs a job that reads a garment and then calls one of the next two functions. Cancels
    /// whatever is running; changes of the reading wait until it is open.
    void openBy(std::unique_ptr<Job> reading);
    /// @param open  opens the garment that was read; called at once, or after the user agrees to
    /// lose edits
    ///              made while it was read (`askBeforeLeaving`)
    void arrived(std::function<void()> open);
    void notOpened();
    /// Sets the question whether the open garment may be closed; it calls its argument if so.
    void askBeforeLeaving(Opening::Ask ask) { opening_.setAsk(std::move(ask)); }
    /// Reads the open garment's files again from the disk.
    void reload();
    /// Reads an open garment again with these options.
    void setLoading(LoadOptions loading);
    /// Unit of the files; none: guessed. Reads an open garment again if that is a change.
    void setUnit(std::optional<FileUnit> unit);
    /// The axis that points up in the files; none: guessed. As setUnit.
    void setUpAxis(std::optional<UpAxis> up);
    /// The kind of the files, and how they are prepared. As setUnit.
    void setPreparing(Preparation preparing);
    /// The same while the user tries values: one step of the history. @param gesture  as for
    /// Document::edit
    void tryPreparing(Preparation preparing, int gesture);
    /// How files are divided into pieces. As setUnit.
    void setSplit(SplitMode split);
    /// Whether pieces that are not disks are cut open. As setUnit.
    void setAutoCut(bool on);
    /// The style of automatic cuts; styles of tailors switch automatic cuts on.
    void setCutStyle(CutStyle style);
    /// Whether coincident vertices are joined. As setUnit.
    void setWeld(bool on);
    /// Whether slits inside pieces are closed. As setUnit.
    void setCloseSlits(bool on);
    /// Reads the reference pattern and shows it over the pieces. Nothing changes if it cannot be
    /// read, if nothing is open, or while something is being opened.
    /// @param path  absolute
    void openReference(const std::filesystem::path& path);
    /// Removes the reference pattern.
    void closeReference();
    /// The cuts and joins that the user asks for.
    CutEditor& cuts() { return cuts_; }
    /// The cuts that Toile proposes.
    CutProposals& proposals() { return *proposals_; }
    /// Proofs of the pattern.
    PatternProof& proof() { return *proof_; }
    void setMethod(Method method);
    void setQuality(Quality quality);
    void setBoundarySolver(BoundarySolver solver);

    /// Flattens all pieces again. While a garment is being read or cut, that follows automatically.
    void flattenAgain();
    /// Whether edits are flattened automatically, as by default. Opened garments always are.
    void setAutoFlatten(bool on);
    bool autoFlatten() const { return recompute_.isAutomatic(); }
    /// Suspends flattening while the user tries values that change the whole garment, until it is
    /// resumed or requested.
    void holdFlattening(bool held);
    /// Whether the pattern is up to date.
    PatternAge patternAge() const;
    /// True if there are results to write, with a flat piece among them.
    bool canExport() const;
    /// Writes the pattern as it is now; several files one after the other. Requires canExport. The
    /// ending of the path chooses the format.
    /// @param only  the pieces to write; none: all, here and in the two functions below
    void exportTo(const std::filesystem::path& path, const ExportOptions& options = {},
                  const Document::Selection& only = {});
    /// The beginning of the file that would be written now. Requires canExport.
    JobRunner::Ticket beginFile(FormatId format, const ExportOptions& options,
                                const Document::Selection& only,
                                std::function<void(const std::string&)> done);
    /// Draws the pattern as in files and on paper. Requires canExport.
    JobRunner::Ticket drawPattern(std::function<void(std::shared_ptr<const DrawnPattern>)> done,
                                  const Document::Selection& only = {});

signals:
    /// `patternAge` has changed.
    void patternAged(toile::app::PatternAge age);
    /// `loading` has changed.
    void loadingChanged();
    /// @param checked  the result of reading the file back; may be empty
    void exported(const QString& path, const QString& checked);
    /// The request is impossible, and why; nothing has changed.
    void refused(const QString& sentence);
    /// Something was done differently than might be expected.
    void noted(const QString& sentence);

private:
    void startOpening();
    void startReading(std::unique_ptr<Job> job);
    /// Stops reading; the garment stays.
    void stopReading();
    bool isReading() const { return opening_.isActive() || jobs_.isUnderWay(reading_); }
    /// Derives missing results, unless something is being read.
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
    /// Changes for a garment that is being opened by `openBy`.
    std::vector<LoadingChange> forOpening_;
    JobRunner::Ticket reading_ = 0;
    int step_ = 0;                           ///< of the history
    PatternAge age_ = PatternAge::UpToDate;  ///< as announced last
    std::unique_ptr<CutProposals> proposals_;
    std::unique_ptr<PatternProof> proof_;
};

}  // namespace toile::app
