// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <type_traits>
#include <vector>

#include "app/document/document_change.h"
#include "app/document/document_state.h"
#include "app/document/history.h"
#include "app/document/mark_places.h"
#include "app/document/view_state.h"
#include "core/quality/piece_quality.h"

namespace toile {
struct PatternPiece;
}  // namespace toile

namespace toile::app {

struct ShownProof;

/// The open garment: the one place that holds what a person has decided (`state`), and what is
/// shown of all that follows from it (`derived`): of this state where it is there (`isCurrent`),
/// else of an earlier one until somebody has worked it out (`show`). Everything it hands out is a
/// finished, immutable, shared value, so that a snapshot for a job costs nothing. A change of the
/// state is a step of the history (`edit`); selection and view are not. GUI thread only. Everything
/// that changes something emits `changed` once.
class Document : public QObject {
    Q_OBJECT

public:
    using Selection = std::set<int>;  ///< indices into Garment::pieces

    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    const DocumentState& state() const { return state_; }
    /// Null where nothing is open.
    const std::shared_ptr<const Garment>& garment() const { return derived_.garment; }
    /// One per piece, in the garment's order, null where not flattened yet; empty until the first
    /// flattening is done.
    const PieceResults& results() const { return derived_.results; }
    /// What the views draw. May be null.
    const std::shared_ptr<const Scene>& scene() const { return derived_.scene; }
    const Derived& derived() const { return derived_; }
    /// Whether the garment is that of the present state.
    bool isCurrent() const { return derived_.inputs == state_.inputs; }
    /// Whether every piece is flat, too, as the state has it.
    bool isFlattened() const;
    /// Whether it was so before, and has only been forgotten since.
    bool wasFlattened() const { return wasFlat_; }
    const LoadOptions& loading() const { return state_.inputs.loading; }
    const FlattenOptions& options() const { return state_.options; }
    const Fabric& fabric() const { return state_.fabric; }
    /// What a piece is cut from: that of its material, or the garment's own.
    const Fabric& fabricOf(int piece) const;
    /// One per piece.
    const std::vector<PieceSettings>& settings() const { return settings_; }
    /// Numbers of the pieces' colours, and of one.
    std::vector<int> colours() const;
    int colourOf(int piece) const;

    const Selection& selection() const { return selection_; }
    /// The selected seam: an index into Garment::seams; none where no seam is selected.
    std::optional<int> seam() const { return seam_; }
    /// The selected stretch of outline or vertex.
    const std::optional<Feature>& mark() const { return mark_; }
    /// What the pointer is on in one of the views.
    const std::optional<Feature>& hover() const { return hover_; }
    const ViewState& view() const { return view_; }
    /// Another number whenever other pieces or other options are asked for: results begun before
    /// are stale then.
    std::uint64_t revision() const { return revision_; }

    /// Null where the piece is not flattened yet.
    const PieceResult* result(int piece) const;
    /// What has been found out about the present state's labels and grain lines.
    MarkPlaces& marks() const { return marks_; }
    /// Null where the piece is not flat.
    const PatternPiece* patternPiece(int piece) const;
    /// How the reference pattern lies on the pattern that is shown; null where there is none, or
    /// as long as nobody has found out.
    const ReferenceMatch* reference() const;
    /// How far the piece is from what it is compared with: its piece of the reference pattern,
    /// where one is open, else the panel of its own file. None where there is nothing to say.
    std::optional<ReferenceFit> referenceFit(int piece) const;
    /// The pattern sewn back together and measured, this one or an earlier one; null: nobody has.
    const std::shared_ptr<const ShownProof>& proof() const { return proof_; }
    /// Whether that is of the pattern as it is now, or of the one that was sewn in its place.
    bool isProofCurrent() const;
    /// Cloth on its way there, which has no proof yet; null: nothing is being sewn.
    const std::shared_ptr<const ShownProof>& sewing() const { return sewing_; }
    /// Whether it is, or will be, a proof of the pattern as it is now.
    bool isOfThisPattern(const ShownProof& shown) const;
    int pieceCount() const;
    Selection everyPiece() const;
    int seamCount() const;
    bool isSelected(int piece) const { return selection_.count(piece) != 0; }
    /// Short name for titles: the file's name, or the first and how many more.
    QString title() const;

    /// The steps done and undone. Do not push: see `edit`.
    QUndoStack& history() { return history_; }
    const QUndoStack& history() const { return history_; }

    /// Opens another document: history and selections are cleared.
    /// @param derived  its garment, and what else has been worked out
    void open(DocumentState state, Derived derived);
    /// Makes `next` the state: one step of the history, or none if no garment is open. Does nothing
    /// if the state is the same already. What follows from it is shown at once if it is known.
    /// @param text     what was done, for the undo menu: "Move piece"
    /// @param gesture  edits with the same number, see `newGesture`, become one step; -1: alone
    void edit(const QString& text, DocumentState next, int gesture = -1);
    /// For the edits of a drag to come.
    int newGesture() { return ++gestures_; }

    /// Takes the steps back, for good, that were made since the garment shown was that of the
    /// state, and makes one step of what is to stay of them. Steps back are done again.
    void takeBack(DocumentState rest);

    /// Shows what was worked out for the present state; no step of the history.
    /// @param settings  with places for pieces that had none
    void show(Derived derived, SettingsById settings);
    DerivedCache& cache() { return cache_; }
    /// Shows what was found out of a reference pattern, for as long as it and the pattern are the
    /// same; no step of the history.
    void showReference(std::shared_ptr<const ReferenceMatch> found);

    /// Shows the pattern sewn back together; no step of the history.
    void showProof(std::shared_ptr<const ShownProof> proof);
    /// Shows cloth on its way there in its place; null: it is so no more.
    void showSewing(std::shared_ptr<const ShownProof> sewing);

    /// How pieces are to be flattened: a step of the history where a garment is open.
    /// @param text  what was done, for the undo menu; empty: the usual words
    void setOptions(const FlattenOptions& options, const QString& text = {});
    /// How the lines of the pattern are drawn: a step of the history. Nothing where no garment is
    /// open.
    /// @param text, gesture  as for `edit`
    void setLines(LineSettings lines, const QString& text, int gesture = -1);
    /// How the pattern is proved: a step of the history where a garment is open.
    /// @param text, gesture  as for `edit`
    void setProofPlan(ProofPlan plan, const QString& text, int gesture = -1);
    /// One thing is selected at a time: pieces, a seam, or a mark. Whatever is selected drops the
    /// others; nothing in its place leaves them.

    /// Indices outside the garment are left out.
    void setSelection(Selection selection);
    void toggleSelected(int piece);
    /// An index outside the garment selects no seam.
    void setSeam(std::optional<int> seam);
    /// Selects a stretch of outline or a vertex; one outside the garment, or of another kind,
    /// selects none.
    /// @param seam  that it is a stretch of: selected with it, since lists know seams alone
    void setMark(const std::optional<Feature>& mark, std::optional<int> seam = {});
    void selectNothing() { select({}, {}, {}); }
    /// Says what the pointer is on; what is outside the garment is nothing.
    void setHover(const std::optional<Feature>& hover);
    /// Says how much longer a seam's left side is meant to be, as a part of the right; none: as
    /// the 3D lengths have it. Pieces, results, scene and selection stay as they are. A step of the
    /// history.
    /// @param seam an index into Garment::seams; not of a free edge
    /// @param gesture  as for `edit`
    void setSeamEase(int seam, std::optional<double> ease, int gesture = -1);
    /// Says whether the stated ease of a seam is drawn: its longer side is that much longer in the
    /// pattern. A step of the history.
    void setEaseDrawn(int seam, bool drawn);
    /// What is painted; no step of the history.
    void setView(const ViewState& view);
    void setView(bool ViewState::*field, bool on);
    void setOverlay(Overlay overlay);

signals:
    /// Another document is open. `changed` follows.
    void opened();
    void changed(const toile::app::DocumentChange& what);
    /// `hover` is another; nothing else has changed.
    void hovered();

private:
    friend class StateStep;

    /// The state becomes `other` and the other way round.
    void exchange(DocumentState& other, bool& wasFlat);
    /// What is known already to follow from the state; what is shown else.
    Derived knownOf(const DocumentState& state);
    /// @return what was shown before
    Derived showOther(Derived derived);
    void keepSelection(const Derived& before);
    void refreshSettings(bool otherPieces);
    void tell(const DocumentState& stateBefore, const Derived& before, unsigned parts = 0);
    bool isInGarment(const Feature& feature) const;
    bool isInGarment(std::optional<int> seam) const;
    void select(Selection pieces, std::optional<int> seam, std::optional<Feature> mark);
    /// Announces the part if that is another value.
    template <class Value>
    void set(Value& field, std::type_identity_t<Value> value, DocumentChange::Part part);

    DocumentState state_;
    Derived derived_;
    DerivedCache cache_;
    std::vector<PieceSettings> settings_;  ///< of the pieces shown
    QUndoStack history_;
    int gestures_ = 0;
    int currentAt_ = 0;  ///< step of the history that the garment shown is of
    bool takesBack_ = false;
    bool wasFlat_ = false;
    Selection selection_;
    std::optional<int> seam_;
    std::optional<Feature> mark_, hover_;
    ViewState view_;
    std::shared_ptr<const ReferenceMatch> reference_;  ///< found last; may be of what is no more
    std::shared_ptr<const ShownProof> proof_;          ///< likewise
    std::shared_ptr<const ShownProof> sewing_;         ///< likewise
    std::uint64_t revision_ = 0;
    mutable MarkPlaces marks_;  ///< follows from the state
};

/// Names as the user has given them.

/// Precondition: the piece is of the garment.
QString pieceName(const Document& document, int piece);
QString seamName(const Document& document, int seam);
/// "front", or "3 pieces".
QString nameOfPieces(const Document& document, const std::vector<int>& pieces);
/// A step of the history with the names of its pieces: "Move front".
/// @param text  with %1 for the names: "Move %1"
QString stepOf(const Document& document, const QString& text, const std::vector<int>& pieces);

}  // namespace toile::app
