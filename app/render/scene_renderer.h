// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

#include "app/document/view_state.h"
#include "app/render/gl_support.h"
#include "app/render/gpu_mesh.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/render/shader_program.h"
#include "core/garment/fabric.h"

namespace toile::app {

/// The visible content, independent of how it is drawn.
struct SceneContent {
    std::shared_ptr<const Scene> scene{};  ///< may be null
    /// Replaces the scene's own reference lines; null: keep them.
    std::shared_ptr<const ReferenceLines> reference{};
    SheetPlaces places{};
    std::set<int> selection{};
    std::optional<int> seam{};
    /// Selected stretches of outlines. Vertices are not drawn.
    std::vector<Feature> marks{};
    std::optional<Feature> hover{};  ///< the hovered feature; vertices are not drawn
    /// The pattern sewn back together; ignored if it is of another scene. May be null.
    std::shared_ptr<const SewnCloth> sewn{};
    /// Its limits are the ends of strain scales.
    Fabric fabric = fabricPresets().front();
    double squareSide = 10;  ///< of the checkerboard, mm
    /// Fixed ends of the colour scale, to make pictures comparable; nullopt: those of scene and
    /// fabric.
    std::optional<OverlayScale> scale{};
};

/// Base of both views' renderers: one mesh, the piece table, colour maps, programs for cloth and
/// lines, and the backdrop. Independent of widgets, so that it can draw into any framebuffer. All
/// calls except the setters need the context current.
class SceneRenderer {
public:
    virtual ~SceneRenderer();

    /// Creates programs and textures. @return an error message; empty if successful
    QString initialize();
    /// Frees all GPU resources. Call before the context is destroyed.
    void release();

    /// Sets the content; the next frame uploads the changes.
    void show(SceneContent content);
    const SceneContent& content() const { return content_; }
    void setHover(const std::optional<Feature>& hover) { content_.hover = hover; }

    int meshUploads() const { return mesh_.uploads(); }
    /// Totals since construction.
    const FrameCounts& counts() const { return counts_; }

protected:
    struct Frame {
        glm::mat4 viewProjection;
        ViewState view;
        RenderStyle style;
        int width, height;  ///< device pixels
        float pixelRatio;
        float millimetresPerPixel = 0;  ///< on the sheet, device pixels; 0 if it varies
    };

    struct ProgramFiles {
        std::vector<std::string_view> cloth, lines, glyphs;
    };

    SceneRenderer();

    virtual ProgramFiles programFiles() const = 0;
    /// The mesh and lines of this view.
    virtual const MeshIndices& meshOf(const Scene& scene) const = 0;
    virtual const LineRuns& linesOf(const Scene& scene) const = 0;
    /// In the order of the mesh's triangles.
    virtual std::vector<FaceValues> faceValues(const Scene& scene) const = 0;
    /// Called while the cloth or line program is bound.
    virtual void setOwnUniforms(ShaderProgram&) {}
    /// Whether the cloth hides content behind it.
    virtual bool isInDepth() const { return false; }
    /// Whether the cloth is flat, so that flat lines are drawn.
    virtual bool isSheet() const { return false; }
    /// Frees GPU resources of a derived renderer.
    virtual void releaseOwn() {}

    /// Updates the GPU's copy. @return whether there is something to draw
    bool synchronize(const ViewState& view);
    /// Sets the cloth uniforms and textures shared by the views; leaves the program bound.
    ShaderProgram& beginCloth(const Frame& frame);
    /// Paints the principal strains if the overlay shows them.
    /// @param millimetresPerPixel scale of the cloth, logical pixels; a typical one in perspective
    void paintCrosses(const Frame& frame, float depthShift, double millimetresPerPixel);
    /// Paints outlines (selected ones again, wider), wireframe, and seams and reference panels if
    /// enabled. The selection and the hovered feature come last.
    /// @param depthShift lifts lines off the cloth, see Camera3D::depthShift
    void paintLines(const Frame& frame, float depthShift);
    /// Paints omitted parts of the files as faint edges in place.
    /// @param depthShift negative: a shell's other surface must not show through the cloth
    void paintLeftOut(const Frame& frame, float depthShift);
    void paintBackdrop(const Frame& frame);
    ShaderProgram& backdropProgram() { return *backdrop_; }

    /// Changes whenever the scene or its placement changes.
    int contentNumber() const { return contentNumber_; }

    /// The sewn cloth of the scene; null if there is none.
    const SewnCloth* sewn() const {
        return content_.sewn && content_.sewn->scene == content_.scene ? content_.sewn.get()
                                                                       : nullptr;
    }

    bool isReady_ = false;  ///< a context is available
    FrameCounts counts_;
    GpuMesh mesh_{counts_};
    SceneContent content_;

private:
    OverlayScale scaleOf(Overlay overlay) const;
    void bindColourMap(Overlay overlay);
    /// Binds the program and sets the uniforms common to all programs.
    void begin(ShaderProgram& program, const Frame& frame);
    /// True if the triangles' own values are available; uploads them on the first call.
    bool hasFaceTable();
    ShaderProgram& beginLines(const Frame& frame, float depthShift);
    void paintWireframe(const Frame& frame);
    /// For selected and hovered pieces; widths in logical pixels.
    void paintChosenOutlines(const Frame& frame, float selected, float hovered);
    void paintSeams(const Frame& frame);
    void paintReferenceLines(const Frame& frame);
    void paintExactOutlines(const Frame& frame);
    /// Cutting lines, notches and internal lines, as far as they are enabled.
    void paintCuttingLines(const Frame& frame);
    void paintHighlight(const Frame& frame, float depthShift, const Feature& feature, bool hovered);
    void drawFeature(const Feature& feature);
    void setLine(const QColor& colour, float width, bool selectedOnly, const Frame& frame);

    TableTexture faces_{counts_}, pieces_{counts_};
    GpuGlyphs glyphs_{counts_};
    /// The cloth whose triangle values and glyphs are on the GPU; does not keep its garment alive.
    std::weak_ptr<const SceneCloth> facesOf_, glyphsOf_;
    bool facesFit_ = false;
    GpuLines overLines_{counts_}, fileLines_{counts_};
    bool sceneChanged_ = false, clothChanged_ = false, tableChanged_ = false,
         referenceChanged_ = false;
    bool sewnChanged_ = false;
    bool pieceColours_ = true;
    Overlay overlay_ = Overlay::None;  ///< the overlay of the piece table
    int contentNumber_ = 0;
    std::unique_ptr<ShaderProgram> cloth_, lines_, backdrop_, glyph_;
    GLuint divergingMap_ = 0, sequentialMap_ = 0;
    GLuint emptyArray_ = 0;  ///< the core profile requires a bound vertex array
};

}  // namespace toile::app
