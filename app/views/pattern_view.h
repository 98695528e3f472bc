// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "app/render/camera.h"
#include "app/render/scene.h"
#include "app/views/name_labels.h"
#include "app/views/reference_gaps.h"
#include "app/views/scene_view.h"
#include "core/garment/garment.h"
#include "core/garment/piece.h"

class QPainter;

namespace toile::app {

class Document;
class RolledPiece;
class SheetMap;

struct RenderStyle;

/// Dashed frames for pieces without a flat shape, to the right of the flat ones. Each is as large
/// as its cloth and shows the name, the problem and a button with a remedy.
class PiecePlaces {
public:
    /// Updates the frames from the document. Cost: linear in the triangles of such pieces, once for
    /// each garment.
    void follow(const Document& document, const SheetPlaces& sheet);
    /// Sets the button text per piece; other pieces have no button.
    void setButtons(std::map<int, QString> buttons) { buttons_ = std::move(buttons); }
    bool isEmpty() const { return places_.empty(); }
    /// On the sheet, mm; empty if the piece has no frame.
    Eigen::AlignedBox2d boxOf(int piece) const;
    void paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
               const Document& document) const;

    struct Hit {
        int piece = -1;
        bool onButton = false;
    };
    std::optional<Hit> hitAt(const QPointF& at, const SheetMap& onScreen, const QFont& font) const;

private:
    struct Place {
        int piece = -1;
        double side = 0;  ///< mm
        QString name, words;
        Eigen::AlignedBox2d box{};
    };

    /// The frame's button, logical pixels; nullopt without one or if it does not fit.
    std::optional<QRectF> buttonOf(const Place& place, const QRectF& box, const QFont& font) const;

    std::shared_ptr<const Garment> garment_;
    PieceResults results_;
    std::vector<Place> all_;     ///< all frames, without names and boxes
    std::vector<Place> places_;  ///< the visible ones
    std::map<int, QString> buttons_;
};

/// The outlines of pieces from the last up-to-date pattern. Drawn pale for pieces changed by edits
/// until those are flattened again.
class OldOutlines {
public:
    /// Stores the outlines of up-to-date pieces. Cost: linear in the outlines.
    void follow(const Document& document, const SheetPlaces& sheet);
    /// Whether an old outline is shown: a changed piece is not flattened yet.
    bool isAny(const Document& document) const;
    void paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
               const Document& document) const;

private:
    struct Outline {
        std::shared_ptr<const Piece> piece;
        Points2 points;  ///< on the sheet, mm
    };

    /// The outlines of pieces that no longer exist, while others wait to be flattened.
    std::vector<const Outline*> shown(const Document& document) const;

    std::vector<Outline> outlines_;
};

/// The flat pieces at true proportions on the sheet, with rulers along two edges, grain arrows and
/// names. Drags that no tool takes move the sheet; the wheel zooms to the cursor.
class PatternView : public SceneView {
    Q_OBJECT

public:
    PatternView(Document& document, ToolChoice& tools, QWidget* parent = nullptr);

    ViewKind kind() const override { return ViewKind::Pattern; }
    std::optional<SurfaceHit> hitAt(const QPointF& at) const override;
    bool answers() const override { return true; }
    std::optional<SeamHit> seamHitAt(const QPointF& at, double pixels,
                                     const SeamFilter& counts) const override;
    std::optional<QPointF> onScreen(int piece, int face,
                                    const Eigen::Vector3d& barycentric) const override;
    Eigen::Vector2d onSheet(const QPointF& at) const override;
    double pixelsPerMillimetre() const override { return camera_.pixelsPerMillimetre(); }

    const Camera2D& camera() const { return camera_; }
    /// Sets the piece that is walked along a seam; null: none.
    void setRolled(std::shared_ptr<const RolledPiece> rolled);
    const RolledPiece* rolled() const { return rolled_.get(); }
    /// Frames the whole walk. Precondition: `rolled()` is not null.
    void frameRolled();
    /// The dashed frames of pieces that are not flat, and their button texts.
    const PiecePlaces& piecePlaces() const { return others_; }
    void setHelp(std::map<int, QString> buttons);

signals:
    /// The user pressed the button in the frame of a piece that is not flat.
    void helpWanted(int piece);

protected:
    const LineRuns& lines() const override { return scene()->patternLines; }
    std::optional<QPointF> pointOnScreen(const LineVertex& vertex) const override;
    void setCameraViewport(double width, double height) override;
    void framePieces(const std::set<int>& pieces) override;
    bool frameLines(const SeamScene& seam) override;
    void frameSpot(const WorstSpot& spot, double radius) override;
    void panCamera(const QPointF& delta) override;
    void zoomCamera(const QPointF& at, double factor) override;
    void paintScene(const RenderStyle& style, int width, int height, double ratio) override;
    std::optional<SpotPlace> placeNow(const WorstSpot& spot) const override;
    void paintText(QPainter& painter, const RenderStyle& style) override;
    bool clickOnOverlay(const QPointF& at) override;

private:
    void follow();
    /// Where a point of a flat piece is on the screen.
    QPointF placed(int piece, const Eigen::Vector2d& point) const;

    Camera2D camera_;
    PiecePlaces others_;
    OldOutlines old_;
    ReferenceGaps gaps_;
    KeptNames names_;
    std::shared_ptr<const RolledPiece> rolled_;
};

}  // namespace toile::app
