// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <memory>
#include <optional>
#include <set>

#include "app/document/document_change.h"
#include "app/render/render_style.h"

class QPainter;

namespace toile {

class Document;
class SceneRenderer;
struct Scene;
struct SeamScene;

/// A view of the document's scene: selection by click, navigation by drag and wheel, and the
/// bookkeeping of a GL widget. Derived views say what a drag does and how to paint. Holds a camera
/// and nothing of the garment.
class SceneView : public QOpenGLWidget {
    Q_OBJECT

public:
    ~SceneView() override;

    /// Shows the selected pieces; where there are none the selected seam, else everything.
    void frameSelection();
    /// Shows both sides of the selected seam; does nothing where none is selected.
    void frameSeam();
    void frameAll();
    /// True once the present scene is on the screen: for pictures made by the program itself.
    bool isUpToDate() const;
    /// Why nothing can be drawn; empty where all is well.
    const QString& problem() const { return problem_; }
    SceneRenderer& renderer() { return *renderer_; }

protected:
    SceneView(Document& document, std::unique_ptr<SceneRenderer> renderer, QWidget* parent);

    enum class Drag { Turn, Shift };

    virtual void setCameraViewport(double width, double height) = 0;
    /// @param pieces never empty
    virtual void framePieces(const std::set<int>& pieces) = 0;
    /// @return false where nothing of the seam is drawn
    virtual bool frameLines(const SeamScene& seam) = 0;
    virtual void drag(Drag kind, const QPointF& delta) = 0;
    virtual void zoom(const QPointF& at, double factor) = 0;
    virtual std::optional<int> pieceAt(const QPointF& at) const = 0;
    virtual void paintScene(const RenderStyle& style, int width, int height, double ratio) = 0;
    virtual void paintText(QPainter& painter, const RenderStyle& style) = 0;

    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

    const Scene* scene() const;
    Document& document_;

private:
    void onChanged(DocumentChanges what);
    void releaseGl();
    void select(const QPointF& at, Qt::KeyboardModifiers modifiers);
    std::set<int> everyPiece() const;

    std::unique_ptr<SceneRenderer> renderer_;
    std::shared_ptr<const Scene> painted_;
    QString problem_;
    QPointF pressed_, last_;
    bool dragging_ = false;
    /// Until the camera is moved by hand everything stays framed, whatever size the view takes.
    bool followsAll_ = true;
};

}  // namespace toile
