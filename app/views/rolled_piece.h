// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "app/render/camera.h"
#include "app/render/scene.h"
#include "core/pattern/pattern.h"
#include "core/pattern/walk.h"

class QPainter;
class QPointF;

namespace toile::app {

class Document;
struct RenderStyle;

/// A piece walked along a seam of another (`SeamRoll`): its current place, and how the pattern view
/// paints it. Each step is linear in both outlines.
class RolledPiece {
public:
    /// Nullopt if the seam has no partner, or a side of it is not flat.
    /// Cost: linear in the two outlines.
    static std::optional<RolledPiece> of(const Document& document, int seam);

    int seam() const { return seam_; }
    /// The pattern piece that stays on the sheet, and the one that rolls along it.
    const PatternPiece& lying() const { return pieceAt(seamOf().left.piece); }
    const PatternPiece& rolling() const { return pieceAt(seamOf().right.piece); }
    bool isItself() const { return seamOf().left.piece == seamOf().right.piece; }
    /// Notch positions as shares of the seam, from its start to its end.
    const std::vector<double>& notches() const { return notches_; }

    /// Rolls to a share of the seam, in [0, 1].
    void rollTo(double share);
    double share() const { return share_; }
    const RolledPlace& now() const { return now_; }
    /// The lengths walked at the end of the seam.
    WalkedLengths whole() const { return roll_.at(1).walked; }
    /// Position of the contact point along the left side, as a share of it.
    double along() const;

    /// Bounding box of the whole walk on the sheet, mm.
    Eigen::AlignedBox2d wayOnSheet(const SheetPlaces& places) const;
    void paint(QPainter& painter, const RenderStyle& style, const Camera2D& camera,
               const SheetPlaces& places) const;

private:
    RolledPiece(const Document& document, int seam, SeamRoll roll);

    const Seam& seamOf() const { return roll_.seam(); }
    const PatternPiece& pieceAt(int piece) const {
        return pattern_->pieces[static_cast<std::size_t>(piece)];
    }
    /// Notch strokes of a piece, from the seam line into the cloth.
    std::vector<Points2> strokesOf(const PatternPiece& piece, bool ofSeamOnly) const;

    int seam_;
    int colour_;  ///< colour number (`pieceColour`)
    SeamRoll roll_;
    std::shared_ptr<const Pattern> pattern_;
    std::vector<double> notches_;
    std::vector<Points2> lyingStrokes_, rollingStrokes_;
    double share_ = 0;
    RolledPlace now_;
};

/// Paints the contact point on the screen.
void paintSeamDot(QPainter& painter, const RenderStyle& style, const QPointF& at);

}  // namespace toile::app
