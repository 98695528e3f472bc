// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <set>

#include <glm/mat4x4.hpp>

#include "app/document/view_state.h"
#include "app/render/gl_support.h"
#include "app/render/gpu_lines.h"
#include "app/render/gpu_mesh.h"
#include "app/render/render_style.h"

class QOpenGLShaderProgram;

namespace toile {

/// What the two views' renderers share: one mesh, the piece table, the colour maps, the programs
/// for cloth and lines, the backdrop. Knows nothing of widgets, so that the same picture can be
/// drawn into any framebuffer. All calls but the setters need the context current.
class SceneRenderer {
public:
    virtual ~SceneRenderer();

    /// Makes programs and textures. @return what went wrong, as a sentence; empty if nothing
    QString initialize();
    /// Frees everything on the GPU. Before the context goes.
    void release();

    /// The next frame uploads it. May be null.
    void setScene(std::shared_ptr<const Scene> scene);
    void setSelection(std::set<int> selection);
    void setSeam(std::optional<int> seam) { seam_ = seam; }

    int meshUploads() const { return mesh_.uploads(); }

protected:
    struct Frame {
        glm::mat4 viewProjection;
        ViewState view;
        RenderStyle style;
        int width, height;  ///< device pixels
        float pixelRatio;
        float millimetresPerPixel = 0;  ///< of the sheet, device pixels; 0 where that varies
    };

    struct ProgramFiles {
        std::vector<std::string_view> cloth, lines;
    };

    SceneRenderer();

    virtual ProgramFiles programFiles() const = 0;
    virtual void upload(Gl& gl, const Scene& scene, GpuMesh& mesh, GpuLines& lines) = 0;
    virtual const LineRuns& lineRuns(const Scene& scene) const = 0;

    /// Brings the GPU's copy up to date. @return whether there is something to draw
    bool synchronize();
    /// Sets uniforms and textures that cloth needs in either view; leaves the program bound.
    QOpenGLShaderProgram& beginCloth(const Frame& frame);
    /// Outlines, the selected ones once more and wider, the wireframe and the designer's outlines
    /// where asked for, and the selected seam over everything.
    /// @param depthShift lifts lines off the cloth, in depth units
    void paintLines(const Frame& frame, float depthShift);
    void paintBackdrop(const Frame& frame);
    QOpenGLShaderProgram& backdropProgram() { return *backdrop_; }

    Gl* gl_ = nullptr;
    GpuMesh mesh_;
    std::shared_ptr<const Scene> scene_;

private:
    void uploadPieceTable();
    void uploadColourMaps();
    void bindPieceTable();
    QOpenGLShaderProgram& beginLines(const Frame& frame, float depthShift);
    void paintWireframe(const Frame& frame);
    void paintDesignerLines(const Frame& frame);
    void paintSeam(const Frame& frame, float depthShift);
    void setLine(const QColor& colour, float width, bool selectedOnly, const Frame& frame);

    std::set<int> selection_;
    std::optional<int> seam_;
    GpuLines overLines_;
    bool sceneChanged_ = false, tableChanged_ = false;
    std::unique_ptr<QOpenGLShaderProgram> cloth_, lines_, backdrop_;
    GLuint pieceTable_ = 0;
    GLuint divergingMap_ = 0, sequentialMap_ = 0;
    GLuint emptyArray_ = 0;  ///< core profile draws nothing without a vertex array
};

}  // namespace toile
