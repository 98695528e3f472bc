// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <set>

#include <glm/mat4x4.hpp>

#include "app/document/view_state.h"
#include "app/render/gl_support.h"
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

    int meshUploads() const { return mesh_.uploads(); }

protected:
    struct Frame {
        glm::mat4 viewProjection;
        ViewState view;
        RenderStyle style;
        int width, height;  ///< device pixels
        float pixelRatio;
    };

    struct ProgramFiles {
        std::vector<std::string_view> cloth, lines;
    };

    SceneRenderer();

    virtual ProgramFiles programFiles() const = 0;
    virtual void uploadMesh(Gl& gl, const Scene& scene, GpuMesh& mesh) = 0;

    /// Brings the GPU's copy up to date. @return whether there is something to draw
    bool synchronize();
    /// Sets uniforms and textures that cloth needs in either view; leaves the program bound.
    QOpenGLShaderProgram& beginCloth(const Frame& frame);
    /// Outlines, the selected ones once more and wider, and the wireframe where asked for.
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

    std::set<int> selection_;
    bool sceneChanged_ = false, tableChanged_ = false;
    std::unique_ptr<QOpenGLShaderProgram> cloth_, lines_, backdrop_;
    GLuint pieceTable_ = 0;
    GLuint divergingMap_ = 0, sequentialMap_ = 0;
    GLuint emptyArray_ = 0;  ///< core profile draws nothing without a vertex array
};

}  // namespace toile
