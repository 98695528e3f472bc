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
#include <utility>
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

/// The open garment: the user's decisions (`state`), and the values computed from them (`derived`).
/// These belong to the present state if `isCurrent`, otherwise to an earlier one until a job has
/// computed new ones (`show`). All values are immutable and shared, so that a snapshot for a job
/// is cheap. A change of the state is a step of the history (`edit`); selection and view are not.
/// Every change emits `changed` once. GUI thread only.
class Document : public QObject {
    Q_OBJECT

public:
    using Selection = std::set<int>;  ///< indices into Garment::pieces

    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    const DocumentState& state() const { return state_; }
    /// Null if nothing is open.
    const std::shared_ptr<const Garment>& garment() const { return derived_.garment; }
    /// One per piece, in the garment's order, null if not flattened yet; empty until the first
    /// flattening is done.
    const PieceResults& results() const { return derived_.results; }
    /// The content of the views. May be null.
    const std::shared_ptr<const Scene>& scene() const { return derived_.scene; }
    const Derived& derived() const { return derived_; }
    /// True if the garment is that of the present state.
    bool isCurrent() const { return derived_.inputs == state_.inputs; }
    /// True if every piece is flattened as the state asks, too.
    bool isFlattened() const;
    /// True if the state was flattened before, though the results may be lost.
    bool wasFlattened() const { return wasFlat_; }
    const LoadOptions& loading() const { return state_.inputs.loading; }
    const FlattenOptions& options() const { return state_.options; }
    const Fabric& fabric() const { return state_.fabric; }
    /// The fabric of a piece: that of its material, or the garment's.
    const Fabric& fabricOf(int piece) const;
    /// One per piece.
    const std::vector<PieceSettings>& settings() const { return settings_; }
    /// Colour numbers of the pieces, and of one.
    std::vector<int> colours() const;
    int colourOf(int piece) const;

    const Selection& selection() const { return selection_; }
    /// The selected seam, an index into Garment::seams.
    std::optional<int> seam() const { return seam_; }
    /// The selected stretch of outline or vertex.
    const std::optional<Feature>& mark() const { return mark_; }
    /// The feature under the pointer, in either view.
    const std::optional<Feature>& hover() const { return hover_; }
    const ViewState& view() const { return view_; }
    /// Changes whenever other pieces or other options are asked for: results begun before are stale
    /// then.
    std::uint64_t revision() const { return revision_; }

    /// Null if the piece is not flattened yet.
    const PieceResult* result(int piece) const;
    /// Places of the labels and grain lines, found on demand.
    MarkPlaces& marks() const { return marks_; }
    /// Null if the piece is not flat.
    const PatternPiece* patternPiece(int piece) const;
    /// How the reference pattern lies on the pattern that is shown; null if there is none, or if
    /// that has not been worked out yet.
    const ReferenceMatch* reference() const;
    /// How far the piece is from its piece of the reference pattern, if one is open, or else from
    /// the panel of its own file.
    std::optional<ReferenceFit> referenceFit(int piece) const;
    /// The proof found last, of this pattern or an earlier one; null if there is none.
    const std::shared_ptr<const ShownProof>& proof() const { return proof_; }
    /// True if that proves the pattern as it is now.
    bool isProofCurrent() const;
    /// Cloth that is being sewn, without a proof yet; null if nothing is.
    const std::shared_ptr<const ShownProof>& sewing() const { return sewing_; }
    /// True if that is, or becomes, a proof of the pattern as it is now.
    bool isOfThisPattern(const ShownProof& shown) const;
    int pieceCount() const;
    Selection everyPiece() const;
    int seamCount() const;
    bool isSelected(int piece) const { return selection_.count(piece) != 0; }
    /// Short name for titles: the file's name, or the first one and the number of the others.
    QString title() const;

    /// Steps for undo and redo. Use `edit` to push one.
    QUndoStack& history() { return history_; }
    const QUndoStack& history() const { return history_; }

    /// Opens another document: history and selections are cleared.
    /// @param derived  its garment, and what else is known of it
    void open(DocumentState state, Derived derived);
    /// Makes `next` the state: one step of the history, or none if no garment is open. Does nothing
    /// if the state is already the same. Known results are shown at once.
    /// @param text     for the undo menu: "Move piece"
    /// @param gesture  edits with the same number (`newGesture`) become one step; -1: a step of its
    ///                 own
    void edit(const QString& text, DocumentState next, int gesture = -1);
    /// Changes one member of the state.
    template <class Value>
    void edit(const QString& text, Value DocumentState::*field, std::type_identity_t<Value> value,
              int gesture = -1) {
        DocumentState next = state_;
        next.*field = std::move(value);
        edit(text, std::move(next), gesture);
    }
    /// A number for the edits of one drag.
    int newGesture() { return ++gestures_; }

    /// Undoes, for good, the steps made since the shown garment was current, and makes `rest` the
    /// state in one step. If the user has undone steps since then, they are done again.
    void takeBack(DocumentState rest);

    /// Shows the results for the present state; no step of the history.
    /// @param settings  those of the state, with places for new pieces
    void show(Derived derived, SettingsById settings);
    DerivedCache& cache() { return cache_; }
    /// Shows how a reference pattern lies, for as long as it and the pattern stay the same; no step
    /// of the history.
    void showReference(std::shared_ptr<const ReferenceMatch> found);

    /// Shows a proof; no step of the history.
    void showProof(std::shared_ptr<const ShownProof> proof);
    /// Shows cloth that is being sewn in place of the proof; null: no more.
    void showSewing(std::shared_ptr<const ShownProof> sewing);

    /// Sets how pieces are flattened.
    /// @param text  for the undo menu; empty: the usual text
    void setOptions(const FlattenOptions& options, const QString& text = {});
    /// Sets how the lines of the pattern are drawn. Does nothing if no garment is open.
    /// @param text, gesture  as for `edit`
    void setLines(LineSettings lines, const QString& text, int gesture = -1);
    /// Only one kind of thing is selected at a time: pieces, a seam, or a mark. Selecting one
    /// deselects the others; selecting nothing of a kind keeps them.

    /// Ignores indices outside the garment.
    void setSelection(Selection selection);
    void toggleSelected(int piece);
    /// An index outside the garment selects no seam.
    void setSeam(std::optional<int> seam);
    /// Selects a stretch of outline or a vertex; a feature of another kind, or outside the garment,
    /// selects none.
    /// @param seam  the seam of the stretch, selected with it because lists show only seams
    void setMark(const std::optional<Feature>& mark, std::optional<int> seam = {});
    void selectNothing() { select({}, {}, {}); }
    /// Sets the feature under the pointer; none if it is outside the garment.
    void setHover(const std::optional<Feature>& hover);
    /// Sets how much longer the left side of a seam is meant to be, as a part of the right; none:
    /// as in 3D. Pieces, results, scene and selection stay.
    /// @param seam     an index into Garment::seams; not of a free edge
    /// @param gesture  as for `edit`
    void setSeamEase(int seam, std::optional<double> ease, int gesture = -1);
    /// Sets whether the stated ease of a seam is drawn: its longer side is that much longer in the
    /// pattern.
    void setEaseDrawn(int seam, bool drawn);
    /// Sets the view; no step of the history.
    void setView(const ViewState& view);
    void setView(bool ViewState::*field, bool on);
    void setOverlay(Overlay overlay);

signals:
    /// Another document is open; `changed` follows.
    void opened();
    void changed(const toile::app::DocumentChange& what);
    /// `hover` has changed, and nothing else.
    void hovered();

private:
    friend class StateStep;

    /// Swaps the state with `other`.
    void exchange(DocumentState& other, bool& wasFlat);
    /// The results for the state, if they are known; else the shown ones.
    Derived knownOf(const DocumentState& state);
    /// @return the results shown before
    Derived showOther(Derived derived);
    void keepSelection(const Derived& before);
    void refreshSettings(bool otherPieces);
    void tell(const DocumentState& stateBefore, const Derived& before, unsigned parts = 0);
    bool isInGarment(const Feature& feature) const;
    bool isInGarment(std::optional<int> seam) const;
    void select(Selection pieces, std::optional<int> seam, std::optional<Feature> mark);
    /// Announces the part if the value differs.
    template <class Value>
    void set(Value& field, std::type_identity_t<Value> value, DocumentChange::Part part);

    DocumentState state_;
    Derived derived_;
    DerivedCache cache_;
    std::vector<PieceSettings> settings_;  ///< of the pieces shown
    QUndoStack history_;
    int gestures_ = 0;
    int currentAt_ = 0;  ///< step of the history that the shown garment belongs to
    bool takesBack_ = false;
    bool wasFlat_ = false;
    Selection selection_;
    std::optional<int> seam_;
    std::optional<Feature> mark_, hover_;
    ViewState view_;
    std::shared_ptr<const ReferenceMatch> reference_;  ///< found last; may be out of date
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
