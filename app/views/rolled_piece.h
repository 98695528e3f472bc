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

/// A piece that is walked along a seam of another (`SeamRoll`): where it is now, and how the
/// pattern view paints that. Each step costs no more than the outlines of both.
class RolledPiece {
public:
    /// None where the seam is sewn to nothing, or a side of it is not flat.
    /// Cost: linear in the two outlines.
    static std::optional<RolledPiece> of(const Document& document, int seam);

    int seam() const { return seam_; }
    /// Of the pattern: the one that lies on the sheet, and the one that rolls along it.
    const PatternPiece& lying() const { return pieceAt(seamOf().left.piece); }
    const PatternPiece& rolling() const { return pieceAt(seamOf().right.piece); }
    bool isItself() const { return seamOf().left.piece == seamOf().right.piece; }
    /// Shares of its notches, from its start to its end.
    const std::vector<double>& notches() const { return notches_; }

    /// To a share of the seam, in [0, 1].
    void rollTo(double share);
    double share() const { return share_; }
    const RolledPlace& now() const { return now_; }
    /// What is walked of the whole seam then.
    WalkedLengths whole() const { return roll_.at(1).walked; }
    /// How far along its left side the two touch, as a part of that.
    double along() const;

    /// Around all of the way, on the sheet, mm.
    Eigen::AlignedBox2d wayOnSheet(const SheetPlaces& places) const;
    void paint(QPainter& painter, const RenderStyle& style, const Camera2D& camera,
               const SheetPlaces& places) const;

private:
    RolledPiece(const Document& document, int seam, SeamRoll roll);

    const Seam& seamOf() const { return roll_.seam(); }
    const PatternPiece& pieceAt(int piece) const {
        return pattern_->pieces[static_cast<std::size_t>(piece)];
    }
    /// Strokes at notches of a piece, from the seam line into the cloth.
    std::vector<Points2> strokesOf(const PatternPiece& piece, bool ofSeamOnly) const;

    int seam_;
    int colour_;  ///< its number (`pieceColour`)
    SeamRoll roll_;
    std::shared_ptr<const Pattern> pattern_;
    std::vector<double> notches_;
    std::vector<Points2> lyingStrokes_, rollingStrokes_;
    double share_ = 0;
    RolledPlace now_;
};

/// Where the two touch, on the screen.
void paintSeamDot(QPainter& painter, const RenderStyle& style, const QPointF& at);

}  // namespace toile::app
