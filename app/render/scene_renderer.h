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

/// What is to be seen, however it is drawn.
struct SceneContent {
    std::shared_ptr<const Scene> scene{};  ///< may be null
    /// In the place of the scene's own reference lines; null: these.
    std::shared_ptr<const ReferenceLines> reference{};
    SheetPlaces places{};
    std::set<int> selection{};
    std::optional<int> seam{};
    /// Stretches of outlines that are selected. Vertices are left out.
    std::vector<Feature> marks{};
    std::optional<Feature> hover{};  ///< what the pointer is on; a vertex is left out
    /// The pattern sewn back together; of another scene it is not drawn. May be null.
    std::shared_ptr<const SewnCloth> sewn{};
    /// Its limits end the colours of strain overlays.
    Fabric fabric = fabricPresets().front();
    double squareSide = 10;  ///< of the checkerboard, mm
    /// The ends of the overlay's colours, for pictures that are to be compared; none: those of
    /// scene and fabric.
    std::optional<OverlayScale> scale{};
};

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

    /// The next frame uploads what has changed.
    void show(SceneContent content);
    const SceneContent& content() const { return content_; }
    void setHover(const std::optional<Feature>& hover) { content_.hover = hover; }

    int meshUploads() const { return mesh_.uploads(); }
    /// Since the renderer was made.
    const FrameCounts& counts() const { return counts_; }

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
        std::vector<std::string_view> cloth, lines, glyphs;
    };

    SceneRenderer();

    virtual ProgramFiles programFiles() const = 0;
    /// The mesh and lines of this view.
    virtual const MeshIndices& meshOf(const Scene& scene) const = 0;
    virtual const LineRuns& linesOf(const Scene& scene) const = 0;
    /// In the order of the mesh's triangles.
    virtual std::vector<FaceValues> faceValues(const Scene& scene) const = 0;
    /// Of the programs for cloth and lines alike, while they are bound.
    virtual void setOwnUniforms(ShaderProgram&) {}
    /// Whether the cloth hides what lies behind it.
    virtual bool isInDepth() const { return false; }
    /// Whether the cloth lies flat: lines that do too are drawn.
    virtual bool isSheet() const { return false; }
    /// Frees what a derived renderer has on the GPU.
    virtual void releaseOwn() {}

    /// Brings the GPU's copy up to date. @return whether there is something to draw
    bool synchronize(const ViewState& view);
    /// Sets uniforms and textures that cloth needs in either view; leaves the program bound.
    ShaderProgram& beginCloth(const Frame& frame);
    /// The principal strains, where the overlay shows them.
    /// @param millimetresPerPixel of the cloth, logical pixels; in depth a typical one
    void paintCrosses(const Frame& frame, float depthShift, double millimetresPerPixel);
    /// Outlines, the selected ones once more and wider, the wireframe, seams and the reference
    /// panels where asked for, and over everything what is selected of them or under the pointer.
    /// @param depthShift lifts lines off the cloth, see Camera3D::depthShift
    void paintLines(const Frame& frame, float depthShift);
    /// What was left out of the files, as faint edges where it was.
    /// @param depthShift below nothing: a shell's other surface must not show through the cloth
    void paintLeftOut(const Frame& frame, float depthShift);
    void paintBackdrop(const Frame& frame);
    ShaderProgram& backdropProgram() { return *backdrop_; }

    /// Of the scene and of where it lies: another number whenever one of them has changed.
    int contentNumber() const { return contentNumber_; }

    /// The sewn cloth of the scene; null where there is none.
    const SewnCloth* sewn() const {
        return content_.sewn && content_.sewn->scene == content_.scene ? content_.sewn.get()
                                                                       : nullptr;
    }

    bool isReady_ = false;  ///< there is a context that it can draw in
    FrameCounts counts_;
    GpuMesh mesh_{counts_};
    SceneContent content_;

private:
    OverlayScale scaleOf(Overlay overlay) const;
    void bindColourMap(Overlay overlay);
    /// Binds it, with what all programs of the scene have to know.
    void begin(ShaderProgram& program, const Frame& frame);
    /// True where the triangles' own values are there to be looked up; uploads them when first
    /// asked for.
    bool hasFaceTable();
    ShaderProgram& beginLines(const Frame& frame, float depthShift);
    void paintWireframe(const Frame& frame);
    /// Of the pieces that are selected or under the pointer; widths in logical pixels.
    void paintChosenOutlines(const Frame& frame, float selected, float hovered);
    void paintSeams(const Frame& frame);
    void paintReferenceLines(const Frame& frame);
    void paintExactOutlines(const Frame& frame);
    /// Cutting lines, notches and internal lines, as far as they are to be seen.
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
    Overlay overlay_ = Overlay::None;  ///< that the piece table is of
    int contentNumber_ = 0;
    std::unique_ptr<ShaderProgram> cloth_, lines_, backdrop_, glyph_;
    GLuint divergingMap_ = 0, sequentialMap_ = 0;
    GLuint emptyArray_ = 0;  ///< core profile draws nothing without a vertex array
};

}  // namespace toile::app
