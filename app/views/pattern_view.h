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

/// The dashed places of pieces that cannot lie flat, right of those that do: as large as their
/// cloth, with the name, what is the matter and a button for what helps.
class PiecePlaces {
public:
    /// Brings the places to what the document shows. Cost: linear in the triangles of such pieces,
    /// once for each garment.
    void follow(const Document& document, const SheetPlaces& sheet);
    /// What a piece's button says; pieces without one have none.
    void setButtons(std::map<int, QString> buttons) { buttons_ = std::move(buttons); }
    bool isEmpty() const { return places_.empty(); }
    /// On the sheet, mm; empty where the piece has none.
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

    /// Of the place's button, logical pixels; none where it has none or is too small for it.
    std::optional<QRectF> buttonOf(const Place& place, const QRectF& box, const QFont& font) const;

    std::shared_ptr<const Garment> garment_;
    PieceResults results_;
    std::vector<Place> all_;     ///< without names and boxes
    std::vector<Place> places_;  ///< that are seen
    std::map<int, QString> buttons_;
};

/// The outlines of pieces as they lay when the pattern was last up to date: pale in the place of
/// those that edits have changed, until these are flattened.
class OldOutlines {
public:
    /// Remembers what is up to date. Cost: linear in the outlines.
    void follow(const Document& document, const SheetPlaces& sheet);
    /// Whether any of the pieces that were there waits to be flattened in another shape.
    bool isAny(const Document& document) const;
    void paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
               const Document& document) const;

private:
    struct Outline {
        std::shared_ptr<const Piece> piece;
        Points2 points;  ///< on the sheet, mm
    };

    /// Those of pieces that are no more, while others wait.
    std::vector<const Outline*> shown(const Document& document) const;

    std::vector<Outline> outlines_;
};

/// The flat pieces at true proportions as they lie on the sheet, with rulers along two edges, grain
/// arrows and names: a drag that no tool takes moves the sheet, the wheel zooms to the cursor.
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
    /// Paints a piece that is walked along a seam; null: none.
    void setRolled(std::shared_ptr<const RolledPiece> rolled);
    const RolledPiece* rolled() const { return rolled_.get(); }
    /// Shows all of its way. Precondition: there is one.
    void frameRolled();
    /// The dashed places of pieces that are not flat, and what their buttons say.
    const PiecePlaces& piecePlaces() const { return others_; }
    void setHelp(std::map<int, QString> buttons);

signals:
    /// The button at the place of a piece that is not flat was pressed.
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
