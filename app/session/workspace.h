// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/document/document.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/reference_finder.h"
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
    /// Those that find what mirrors the cuts that a person has drawn, one after the other.
    JobRunner& mirroring() { return mirroring_; }
    /// That which sews the pattern, as it was when it was begun.
    JobRunner& proving() { return proving_; }
    /// All of them.
    std::vector<JobRunner*> runners() { return {&mirroring_, &jobs_, &proving_, &writing_}; }
    bool isBusy() const {
        return mirroring_.isBusy() || jobs_.isBusy() || proving_.isBusy() || writing_.isBusy();
    }
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
    /// How files are read, divided and cut; of those that are being read, if any are.
    const LoadOptions& loading() const;
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
    /// Changes cuts and joins; pieces that no change touches stay as they are, flat or not.
    /// @param text  what was done, for the undo menu
    void changeSeams(const QString& text, std::function<void(SeamsFile&)> change, int gesture = -1);
    /// Reads the pattern that the pieces are to be compared with, and shows it over them. Nothing
    /// changes where it cannot be read, where nothing is open, or while something is being opened.
    /// @param path  absolute
    void openReference(const std::filesystem::path& path);
    /// Compares with no pattern any more.
    void closeReference();
    /// Takes cuts and ease from a seams file. Nothing changes where it cannot be read.
    /// @return notes: what of it is not known
    Result<Problems> readSeams(const std::filesystem::path& path);
    /// Writes the cuts and the ease that were stated as a seams file.
    Result<void> writeSeams(const std::filesystem::path& path) const;
    /// Makes a cut, the name aside, which it gets here: "cut 3", "dart 1". One that turns out to be
    /// impossible, or to open nothing, is `refused` and leaves no step. Where edits are mirrored
    /// its mirror image is made in the same step: both, or neither where one of them cannot be.
    /// What has no mirror image, or none that is known, is made alone, and that is `noted`.
    /// On a large garment the image is found on another thread, and the cut made when it is there:
    /// in the order in which cuts were asked for, whatever is edited meanwhile.
    /// @param cut    its points in mm, as the pieces are
    /// @param piece  that it is drawn on, for the words of the history
    /// @param text   what is done, with %1 for the piece; empty: the usual words
    void addCut(UserCut cut, std::optional<int> piece = {}, const QString& text = {});
    /// Cuts these pieces open where they cannot lie flat (`openingCuts`): the cuts are the person's
    /// from then on. What cannot be opened is `refused`. On large pieces they are found on another
    /// thread.
    void cutOpen(const std::vector<int>& pieces);
    /// Cuts that Toile proposes, while a person looks at them.
    CutProposals& proposals() { return *proposals_; }
    /// The pattern sewn back together.
    PatternProof& proof() { return *proof_; }
    /// Makes cuts as one step of the history: the person's from then on. They keep their names, but
    /// for a number where another cut has it. Those that cannot be made are `refused`.
    /// @param cuts  their points in mm, as the pieces are
    /// @param gesture  as for Document::edit
    void makeCuts(const QString& text, std::vector<UserCut> cuts, int gesture = -1);
    /// Cuts once around the tube at a place of a piece (`loopAround`), made as by `addCut`. Where
    /// there is none it is `refused`. On large pieces it is found on another thread.
    void cutAround(int piece, const SurfacePoint& place);
    /// Lets a dart go on as a seam, by a cut from its tip to the outline (`cutBeyondDart`), made as
    /// by `addCut`. What points at no edge is `refused`.
    /// @param seam an index into Garment::seams
    void dartToSeam(int seam);
    /// Whether a seam is one that a cut made of a dart.
    bool isSeamOfDart(int seam) const;
    /// Takes that cut back: the dart is there again.
    void seamToDart(int seam);
    /// Joins the cloth on both sides of a seam: a cut of the user's is taken back, two pieces that
    /// the garment's division made become one. What cannot be is `refused`: the edge of a hem, a
    /// cut of Toile's own, sides that do not fit vertex by vertex.
    /// @param seam an index into Garment::seams
    void joinSeam(int seam);
    /// Takes a cut of the user's back; where edits are mirrored its mirror image too, as does
    /// joining the seam that it made.
    void removeCut(CutId id);
    /// Takes a join back, the first of this name: the seam is there again.
    void removeJoin(const std::string& name);
    /// Says how much longer a seam's left side is meant to be, as a part of the right; none: as
    /// the 3D lengths have it. Nothing is read or flattened again; a later reading keeps it.
    void setEase(int seam, std::optional<double> ease);
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
    /// A cut or a join that was drawn by hand.
    struct Trial {
        std::string name;
        std::string image{};  ///< the mirror image that was made of it; or empty
    };

    /// A cut, and the garment that it was drawn on.
    struct DrawnCut {
        UserCut cut;
        std::shared_ptr<const Garment> garment;
        SeamsFile seams{};  ///< that say the unit of the file
        PieceResults results{};
        std::shared_ptr<const Symmetry> symmetry{};  ///< null: none is known
        bool isMirrored = false;
        QString text{};  ///< what is done

        std::optional<UserCut> image(const Progress& progress = Progress()) const;
    };

    /// A change of how files are read, divided and cut.
    struct LoadingChange {
        QString text;
        std::function<void(LoadOptions&)> change;
        int gesture = -1;  ///< as for Document::edit
    };

    void startOpening();
    void startReading(std::unique_ptr<Job> job);
    /// Nothing is read any more: the garment is as it was.
    void stopReading();
    bool isReading() const { return opening_.isActive() || jobs_.isUnderWay(reading_); }
    /// Works out what is not there, unless something is being read.
    void follow();
    void followAge();

    /// Without cuts there is nothing to divide by.
    static void divideByWhatIsThere(LoadOptions& loading);
    void changeLoading(LoadingChange change);
    template <class Value>
    void setLoadingField(const QString& text, Value LoadOptions::*field, const Value& value);
    std::optional<Error> objectionTo(const Garment& garment, DocumentState& rest);
    void sayRefused(const Error& why);
    void makeCut(const DrawnCut& drawn, std::optional<UserCut> image);
    /// That makes a seam of a dart.
    std::optional<CutId> cutBeyond(int seam) const;
    /// Finds cuts in pieces of the garment, at once where that is quick.
    /// @param find  `Result<std::vector<UserCut>>(Progress&)`; holds what it looks at
    void findCuts(const QString& text, bool isQuick,
                  std::function<Result<std::vector<UserCut>>(Progress&)> find,
                  std::function<void(std::vector<UserCut>)> found);
    /// What was searched for is of a garment that is no more.
    void sayOvertaken();
    /// Takes cuts in, named, as one step; those that cannot be made are refused.
    void takeCuts(const QString& text, std::vector<UserCut> cuts);
    std::function<void(SeamsFile&)> removalOf(std::vector<CutId> cuts) const;

    template <class Value>
    void setOption(const QString& text, Value FlattenOptions::*field, Value value);
    void onChanged(const DocumentChange& what);
    void onStopped(bool failed);

    Document document_;
    JobRunner mirroring_, jobs_, proving_, writing_;
    std::function<void()> afterWriting_;
    Recompute recompute_{document_, jobs_};
    ReferenceFinder reference_{document_};
    Opening opening_;
    LineSettings newLines_{};
    /// For what is being opened, where that is not known before it is there.
    std::vector<LoadingChange> forOpening_;
    std::vector<Trial> onTrial_;  ///< until it has turned out that they can be
    bool isImageRefused_ = false;
    JobRunner::Ticket reading_ = 0;
    int step_ = 0;                           ///< of the history
    PatternAge age_ = PatternAge::UpToDate;  ///< as it was told last
    std::unique_ptr<CutProposals> proposals_;
    std::unique_ptr<PatternProof> proof_;
};

}  // namespace toile::app
