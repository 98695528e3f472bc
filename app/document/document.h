// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>

#include "app/document/document_change.h"
#include "app/document/view_state.h"
#include "core/pipeline/pipeline.h"

namespace toile {

class GarmentFlattener;
struct Scene;

/// The open garment: the one place that holds its state. Everything it hands out is a finished,
/// immutable, shared value, so that a snapshot for a job costs nothing and old states can be kept.
/// GUI thread only. Every setter that changes something emits `changed` once.
class Document : public QObject {
    Q_OBJECT

public:
    using Selection = std::set<int>;  ///< indices into Garment::pieces

    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// Null where nothing is open.
    const std::shared_ptr<const Garment>& garment() const { return garment_; }
    /// One per piece, in the garment's order; empty until the first flattening is done.
    const PieceResults& results() const { return results_; }
    /// What the views draw, made of garment and results by the job that made them. May be null.
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    const FlattenOptions& options() const { return options_; }
    /// What is kept of one flattening for the next, as long as the garment is of the same files;
    /// thread-safe, for the jobs.
    const std::shared_ptr<GarmentFlattener>& flattener() const { return flattener_; }
    const Selection& selection() const { return selection_; }
    /// The selected seam: an index into Garment::seams; none where no seam is selected.
    std::optional<int> seam() const { return seam_; }
    const ViewState& view() const { return view_; }
    /// Goes up when the garment or the options change: results begun before are stale then.
    std::uint64_t revision() const { return revision_; }

    int pieceCount() const;
    int seamCount() const;
    bool isSelected(int piece) const { return selection_.count(piece) != 0; }
    /// Short name for titles: the file's name, or the first and how many more.
    QString title() const;

    /// Opens a garment: results and selections are cleared.
    void setGarment(std::shared_ptr<const Garment> garment, std::shared_ptr<const Scene> scene);
    /// @param results one per piece of the present garment
    void setResults(PieceResults results, std::shared_ptr<const Scene> scene);
    void setOptions(const FlattenOptions& options);
    /// Indices outside the garment are left out.
    void setSelection(Selection selection);
    void toggleSelected(int piece);
    /// An index outside the garment selects no seam.
    void setSeam(std::optional<int> seam);
    /// Says how much longer a seam's left side is meant to be, as a part of the right; none: as
    /// the 3D lengths have it. Pieces, results, scene and selection stay as they are.
    /// @param seam an index into Garment::seams; not of a free edge
    void setSeamEase(int seam, std::optional<double> ease);
    void setOverlay(Overlay overlay);
    void setWireframe(bool on);
    void setDesignerOutline(bool on);

signals:
    void changed(toile::DocumentChanges what);

private:
    void changeView(bool ViewState::*field, bool on);

    std::shared_ptr<const Garment> garment_;
    PieceResults results_;
    std::shared_ptr<const Scene> scene_;
    FlattenOptions options_;
    std::shared_ptr<GarmentFlattener> flattener_;
    Selection selection_;
    std::optional<int> seam_;
    ViewState view_;
    std::uint64_t revision_ = 0;
};

}  // namespace toile
