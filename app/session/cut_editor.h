// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/jobs/job_runner.h"
#include "core/cut/surface_point.h"
#include "core/toile/pipeline.h"

namespace toile::app {

class Workspace;

/// The cuts, joins and ease that the user asks for. Each request is one step of the history. A cut
/// that turns out to be impossible is taken back and `refused`. GUI thread only.
class CutEditor : public QObject {
    Q_OBJECT

public:
    /// `workspace` outlives this.
    explicit CutEditor(Workspace& workspace);

    /// The jobs that search for cuts and for their mirror images, one after the other.
    JobRunner& searches() { return searches_; }
    const JobRunner& searches() const { return searches_; }

    /// Makes a cut and names it: "cut 3", "dart 1". If edits are mirrored, its mirror image is made
    /// in the same step: both, or neither if one of them is impossible. A cut without a known
    /// mirror image is made alone, which is `noted`. On a large garment the image is searched for
    /// on another thread, and cuts are made in the order in which they were asked for.
    /// @param cut    its points in mm, as the pieces are
    /// @param piece  the piece that it is drawn on, for the history
    /// @param text   for the undo menu, with %1 for the piece; empty: the usual text
    void add(UserCut cut, std::optional<int> piece = {}, const QString& text = {});
    /// Makes cuts as one step of the history. They keep their names, with a number if another cut
    /// has the same name; the others are named after their kind.
    /// @param cuts     their points in mm, as the pieces are
    /// @param gesture  as for Document::edit
    void makeAll(const QString& text, std::vector<UserCut> cuts, int gesture = -1);
    /// Cuts these pieces open where they cannot lie flat (`openingCuts`); searches on another
    /// thread if the pieces are large.
    void openPieces(const std::vector<int>& pieces);
    /// Cuts once around the tube at a place of a piece (`loopAround`); as `openPieces`.
    void cutAround(int piece, const SurfacePoint& place);
    /// Extends a dart to a seam by a cut from its tip to the outline (`cutBeyondDart`).
    /// @param seam an index into Garment::seams
    void dartToSeam(int seam);
    /// Whether a seam is one that a cut made of a dart.
    bool isSeamOfDart(int seam) const { return cutBeyond(seam).has_value(); }
    /// Removes that cut: the dart is there again.
    void seamToDart(int seam);
    /// Joins the cloth on both sides of a seam: removes the user's cut there, or makes one piece of
    /// two that the garment was divided into. Refuses hems, automatic cuts, and sides that do not
    /// fit vertex by vertex.
    /// @param seam an index into Garment::seams
    void joinSeam(int seam);
    /// Removes a cut of the user's, and its mirror image if edits are mirrored.
    void remove(CutId id);
    /// Removes the first join of this name: the seam is there again.
    void removeJoin(const std::string& name);
    /// Changes cuts and joins; pieces that no change touches stay as they are, flat or not.
    /// @param text  for the undo menu
    void change(const QString& text, std::function<void(SeamsFile&)> edit, int gesture = -1);
    /// Takes cuts and ease from a seams file. Nothing changes if it cannot be read.
    /// @return notes: unknown parts of the file
    Result<Problems> readSeams(const std::filesystem::path& path);
    /// Writes cuts and ease as a seams file.
    Result<void> writeSeams(const std::filesystem::path& path) const;

    /// Why a new cut or join is impossible in this garment; `rest` is then the state without it.
    std::optional<Error> objectionTo(const Garment& garment, DocumentState& rest);
    /// Emits `refused`.
    void refuse(const Error& why);

signals:
    /// A request cannot be carried out, and why; nothing has changed.
    void refused(const QString& sentence);
    /// Something was done otherwise than might be expected.
    void noted(const QString& sentence);

private:
    /// A new cut or join that may turn out to be impossible.
    struct Pending {
        std::string name;
        std::string image{};  ///< its mirror image; or empty
    };

    /// A cut, and the garment that it was drawn on.
    struct DrawnCut {
        UserCut cut;
        std::shared_ptr<const Garment> garment;
        SeamsFile seams{};  ///< that state the unit of the file
        PieceResults results{};
        std::shared_ptr<const Symmetry> symmetry{};  ///< null: none is known
        bool isMirrored = false;
        QString text{};  ///< for the undo menu

        std::optional<UserCut> image(const Progress& progress = Progress()) const;
    };

    /// Null if there is no garment that can be cut now.
    std::shared_ptr<const Garment> openGarment() const;
    void make(const DrawnCut& drawn, std::optional<UserCut> image);
    /// The cut that makes a seam of a dart.
    std::optional<CutId> cutBeyond(int seam) const;
    /// Searches for cuts in pieces of the garment, at once if that is quick.
    /// @param find  holds what it looks at
    void search(const QString& text, bool isQuick,
                std::function<Result<std::vector<UserCut>>(Progress&)> find,
                std::function<void(std::vector<UserCut>)> found);
    void refuseStale();
    std::function<void(SeamsFile&)> removalOf(std::vector<CutId> cuts) const;

    Workspace& workspace_;
    Document& document_;
    JobRunner searches_;
    std::vector<Pending> pending_;  ///< while the document is not current
    bool isImageRefused_ = false;
};

}  // namespace toile::app
