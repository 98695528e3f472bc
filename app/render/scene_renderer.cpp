// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/scene_renderer.h"

#include <QCoreApplication>
#include <QVector3D>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "app/render/colour_map.h"
#include "app/render/overlay_values.h"
#include "app/render/render_style.h"
#include "app/render/shader_program.h"

namespace toile::app {

namespace {

bool hasOwnFabrics(const SheetPlaces& places) {
    return std::ranges::any_of(
        places, [](const SheetPlace& place) -> bool { return place.fabric.has_value(); });
}

constexpr int kPieceTableUnit = 0, kColourMapUnit = 1, kFaceTableUnit = 2;

/// Widths in logical pixels.
constexpr float kOutlineWidth = 1.25F, kSelectedWidth = 3.0F, kWireWidth = 0.7F;
/// Under seam lines, whose colours stay visible on it.
constexpr float kSelectedHaloWidth = 8.0F, kHoveredHaloWidth = 6.0F;
/// The wireframe fades between these screen lengths of an edge: denser edges would cover the cloth.
constexpr int kGhostAlpha = 120;
constexpr float kWireFadesOut = 4.0F, kWireFadesIn = 12.0F;
constexpr float kSeamWidth = 4.0F, kSeamHaloWidth = 8.0F, kReferenceWidth = 1.5F;
constexpr float kPlainSeamWidth = 2.6F;  ///< free edges get half of it
constexpr float kHoveredShare = 0.7F;    ///< width of hover highlights, relative to the selection
constexpr float kHoveredPieceWidth = 2.4F;
constexpr float kDashPixels = 11.0F, kExactDashPixels = 6.0F, kExactWidth = 1.25F;
constexpr float kCuttingWidth = 1.8F, kNotchWidth = 1.6F, kInternalWidth = 1.6F;
/// Opacity of a seam that the cloth hides.
constexpr int kHiddenSeamAlpha = 75;
/// Minimum distance of glyphs; at most half as much again.
constexpr double kMinSpacing = 25;
/// Share of the glyph spacing that a stroke covers.
constexpr double kStrokeShare = 0.88;

GLuint makeColourMapTexture(const ColourMap& map) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, kColourMapSize, 1, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 map.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return texture;
}

}  // namespace

SceneRenderer::SceneRenderer() = default;

SceneRenderer::~SceneRenderer() = default;

QString SceneRenderer::initialize() {
    isReady_ = hasGl();
    if (!isReady_) {
        return QCoreApplication::translate(
            "SceneRenderer",
            "This view needs OpenGL 3.3, which the graphics driver does not offer.");
    }
    const ProgramFiles files = programFiles();
    QString problem;
    const std::pair<std::unique_ptr<ShaderProgram>&, std::vector<std::string_view>> programs[] = {
        {cloth_, files.cloth},
        {lines_, files.lines},
        {backdrop_, {"backdrop.vert", "backdrop.frag"}},
        {glyph_, files.glyphs}};
    for (const auto& [program, names] : programs) {
        if (program = loadProgram(names, problem); !program) {
            return QCoreApplication::translate("SceneRenderer",
                                               "The graphics driver cannot draw this view (%1).")
                .arg(problem);
        }
    }
    glGenVertexArrays(1, &emptyArray_);
    divergingMap_ = makeColourMapTexture(divergingMap());
    sequentialMap_ = makeColourMapTexture(sequentialMap());
    sceneChanged_ = clothChanged_ = tableChanged_ = content_.scene != nullptr;
    referenceChanged_ = content_.reference != nullptr;
    sewnChanged_ = true;
    return {};
}

void SceneRenderer::release() {
    if (!std::exchange(isReady_, false)) {
        return;
    }
    mesh_.release();
    overLines_.release();
    fileLines_.release();
    faces_.release();
    pieces_.release();
    glyphs_.release();
    facesOf_.reset();
    glyphsOf_.reset();
    glDeleteVertexArrays(1, &emptyArray_);
    for (GLuint* texture : {&divergingMap_, &sequentialMap_}) {
        glDeleteTextures(1, texture);
        *texture = 0;
    }
    emptyArray_ = 0;
    releaseOwn();
    cloth_.reset();
    lines_.reset();
    backdrop_.reset();
    glyph_.reset();
}

void SceneRenderer::show(SceneContent content) {
    const bool isOtherScene = content.scene != content_.scene;
    const bool liesElsewhere = content.places != content_.places;
    contentNumber_ += isOtherScene || liesElsewhere ? 1 : 0;
    sceneChanged_ = sceneChanged_ || isOtherScene;
    clothChanged_ = clothChanged_ || clothOf(content.scene) != clothOf(content_.scene);
    referenceChanged_ = referenceChanged_ || content.reference != content_.reference;
    sewnChanged_ = sewnChanged_ || isOtherScene || content.sewn != content_.sewn;
    tableChanged_ =
        tableChanged_ || isOtherScene || liesElsewhere || content.selection != content_.selection;
    content_ = std::move(content);
}

bool SceneRenderer::synchronize(const ViewState& view) {
    if (!content_.scene || !cloth_) {
        return false;
    }
    if (std::exchange(sceneChanged_, false)) {
        overLines_.upload(content_.scene->lineVertices, linesOf(*content_.scene));
    }
    if (std::exchange(clothChanged_, false)) {
        mesh_.upload(content_.scene->vertices, meshOf(*content_.scene));
    }
    if (std::exchange(sewnChanged_, false)) {
        const SewnCloth* cloth = sewn();
        const std::vector<SewnVertex> none;
        mesh_.uploadSewn(cloth ? cloth->vertices : none);
        if (!isSheet()) {
            overLines_.uploadSewn(cloth ? cloth->lineVertices : none);
        }
    }
    if (std::exchange(referenceChanged_, false) && content_.reference && isSheet()) {
        fileLines_.upload(content_.reference->vertices, content_.reference->runs);
    }
    if (std::exchange(pieceColours_, view.pieceColours) != view.pieceColours) {
        tableChanged_ = true;
    }
    const bool isOther = std::exchange(overlay_, view.overlay) != view.overlay;
    tableChanged_ = tableChanged_ || (isOther && hasOwnFabrics(content_.places));
    if (std::exchange(tableChanged_, false)) {
        std::vector<float> table = makePieceTable(*content_.scene, content_.selection,
                                                  content_.places, pieceColours_, overlay_);
        table.insert(table.end(), std::size_t{4} * kTexelsPerPiece,
                     0.0F);  // for lines without a piece
        pieces_.upload(table);
    }
    return true;
}

OverlayScale SceneRenderer::scaleOf(Overlay overlay) const {
    return content_.scale ? *content_.scale
                          : overlayScale(*content_.scene, overlay, content_.fabric, sewn());
}

void SceneRenderer::begin(ShaderProgram& program, const Frame& frame) {
    pieces_.bind(kPieceTableUnit);
    program.bind();
    program.setUniformValue("pieceTable", kPieceTableUnit);
    program.setUniformValue("colourMap", kColourMapUnit);
    program.setUniformValue("pixelRatio", frame.pixelRatio);
    program.setUniformValue("viewportPixels", static_cast<float>(frame.width),
                            static_cast<float>(frame.height));
    program.setUniformValue("viewProjection", frame.viewProjection);
}

void SceneRenderer::bindColourMap(Overlay overlay) {
    glActiveTexture(GL_TEXTURE0 + kColourMapUnit);
    glBindTexture(GL_TEXTURE_2D, traits(overlay).hasSign ? divergingMap_ : sequentialMap_);
}

bool SceneRenderer::hasFaceTable() {
    if (facesOf_.lock() != content_.scene->cloth) {
        glActiveTexture(GL_TEXTURE0 + kFaceTableUnit);
        facesFit_ = faces_.upload(faceValues(*content_.scene));
        facesOf_ = content_.scene->cloth;
    }
    return facesFit_;
}

ShaderProgram& SceneRenderer::beginCloth(const Frame& frame) {
    const Overlay overlay = frame.view.overlay;
    const OverlayScale scale = scaleOf(overlay);
    const bool triangleTable =
        isMeasured(overlay) && !isOfProof(overlay) &&
        (scale.limited || hasOwnFabrics(content_.places) || frame.view.valuesPerTriangle) &&
        hasFaceTable();
    faces_.bind(kFaceTableUnit);
    bindColourMap(overlay);

    ShaderProgram& program = *cloth_;
    begin(program, frame);
    program.setUniformValue("faceTable", kFaceTableUnit);
    program.setUniformValue("overlay", static_cast<int>(overlay));
    program.setUniformValue("squareSide", static_cast<float>(content_.squareSide));
    program.setUniformValue("overlayRange", static_cast<float>(scale.low),
                            static_cast<float>(scale.high));
    program.setUniformValue("overlayLimited", scale.limited);
    program.setUniformValue("isProved", sewn() && sewn()->isMeasured);
    program.setUniformValue("triangleTable", triangleTable);
    program.setUniformValue("perTriangle", triangleTable && frame.view.valuesPerTriangle);
    setOwnUniforms(program);
    return program;
}

void SceneRenderer::paintCrosses(const Frame& frame, float depthShift, double millimetresPerPixel) {
    if (frame.view.overlay != Overlay::Principal) {
        return;
    }
    if (glyphsOf_.lock() != content_.scene->cloth) {
        glyphs_.upload(content_.scene->glyphs);
        glyphsOf_ = content_.scene->cloth;
    }
    const OverlayScale scale = scaleOf(Overlay::Principal);
    bindColourMap(Overlay::Principal);
    const GlyphRange run = glyphsAt(content_.scene->glyphs, kMinSpacing * millimetresPerPixel);
    if (run.count == 0) {
        return;
    }
    ShaderProgram& program = *glyph_;
    begin(program, frame);
    program.setUniformValue("overlayRange", static_cast<float>(scale.low),
                            static_cast<float>(scale.high));
    program.setUniformValue("halfLength", static_cast<float>(kStrokeShare * run.spacing / 2));
    program.setUniformValue("depthShift", depthShift);
    beginBlending();
    glDepthMask(GL_FALSE);  // translucent stroke edges must not hide neighbours
    glyphs_.draw(run);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    program.release();
}

ShaderProgram& SceneRenderer::beginLines(const Frame& frame, float depthShift) {
    ShaderProgram& program = *lines_;
    begin(program, frame);
    program.setUniformValue("depthShift", depthShift);
    program.setUniformValue("dashLength", 0.0F);
    program.setUniformValue("fade", 0.0F, 0.0F);
    program.setUniformValue("tinted", false);
    setOwnUniforms(program);
    return program;
}

void SceneRenderer::setLine(const QColor& colour, float width, bool selectedOnly,
                            const Frame& frame) {
    lines_->setUniformValue("lineColour", colour);
    lines_->setUniformValue("lineWidth", width * frame.pixelRatio);
    lines_->setUniformValue("selectedOnly", selectedOnly);
}

void SceneRenderer::paintLines(const Frame& frame, float depthShift) {
    ShaderProgram& program = beginLines(frame, depthShift);
    if (frame.view.wireframe) {
        paintWireframe(frame);
    }
    setLine(frame.style.outline, kOutlineWidth, false, frame);
    mesh_.drawOutline();
    if (frame.view.exactOutline) {
        program.setUniformValue("depthShift", 1.1F * depthShift);  // below the drawn line
        paintExactOutlines(frame);
    }
    if (frame.view.seams) {
        program.setUniformValue("depthShift", 1.25F * depthShift);
        // Without depth writes, the halo cannot cover the seam's own colour.
        glDepthMask(GL_FALSE);
        paintChosenOutlines(frame, kSelectedHaloWidth, kHoveredHaloWidth);
        glDepthMask(GL_TRUE);
        program.setUniformValue("depthShift", 1.5F * depthShift);
        paintSeams(frame);
        program.setUniformValue("depthShift", 2 * depthShift);
    } else {
        program.setUniformValue("depthShift", 2 * depthShift);
        paintChosenOutlines(frame, kSelectedWidth, kHoveredPieceWidth);
    }
    paintCuttingLines(frame);
    if (frame.view.referencePanels) {
        paintReferenceLines(frame);
    }
    if (content_.seam) {
        paintHighlight(frame, depthShift, {.kind = Feature::Kind::Seam, .seam = *content_.seam},
                       false);
    }
    for (const Feature& mark : content_.marks) {
        paintHighlight(frame, depthShift, mark, false);
    }
    if (content_.hover && content_.hover->kind != Feature::Kind::Piece) {
        paintHighlight(frame, depthShift, *content_.hover, true);
    }
    program.release();
}

void SceneRenderer::paintChosenOutlines(const Frame& frame, float selected, float hovered) {
    setLine(frame.style.selection, selected, true, frame);
    mesh_.drawOutline();
    if (content_.hover && content_.hover->kind == Feature::Kind::Piece) {
        setLine(frame.style.selection, hovered, false, frame);
        drawFeature(*content_.hover);
    }
}

void SceneRenderer::paintSeams(const Frame& frame) {
    std::array<QVector3D, kSeamColours> palette;
    for (std::size_t i = 0; i < palette.size(); ++i) {
        const Rgb& colour = seamPalette(frame.style.onDark)[i];
        palette[i] = QVector3D(colour.r, colour.g, colour.b) / 255.0F;
    }
    lines_->setUniformValueArray("seamPalette", palette.data(), kSeamColours);
    lines_->setOpaque("freeColour", frame.style.freeEdge);
    lines_->setUniformValue("tinted", true);
    setLine(frame.style.outline, kPlainSeamWidth, false, frame);
    overLines_.drawSeams();
    lines_->setUniformValue("tinted", false);
}

void SceneRenderer::paintWireframe(const Frame& frame) {
    QColor wire = frame.style.wire;
    wire.setAlpha(110);
    beginBlending();
    setLine(wire, kWireWidth, false, frame);
    lines_->setUniformValue("fade", kWireFadesOut * frame.pixelRatio,
                            kWireFadesIn * frame.pixelRatio);
    mesh_.drawEdges();
    lines_->setUniformValue("fade", 0.0F, 0.0F);
    glDisable(GL_BLEND);
}

void SceneRenderer::paintLeftOut(const Frame& frame, float depthShift) {
    if (!overLines_.hasLeftOut()) {
        return;
    }
    QColor ghost = frame.style.faintText;
    ghost.setAlpha(kGhostAlpha);
    ShaderProgram& program = beginLines(frame, depthShift);
    beginBlending();
    glDepthMask(GL_FALSE);
    setLine(ghost, kWireWidth, false, frame);
    overLines_.drawLeftOut();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    program.release();
}

void SceneRenderer::paintReferenceLines(const Frame& frame) {
    lines_->setUniformValue("dashLength",
                            kDashPixels * frame.pixelRatio * frame.millimetresPerPixel);
    setLine(frame.style.reference, kReferenceWidth, false, frame);
    (content_.reference ? fileLines_ : overLines_).drawReference();
    lines_->setUniformValue("dashLength", 0.0F);
}

void SceneRenderer::paintExactOutlines(const Frame& frame) {
    lines_->setUniformValue("dashLength",
                            kExactDashPixels * frame.pixelRatio * frame.millimetresPerPixel);
    setLine(frame.style.exactOutline, kExactWidth, false, frame);
    overLines_.drawExact();
    lines_->setUniformValue("dashLength", 0.0F);
}

void SceneRenderer::paintCuttingLines(const Frame& frame) {
    if (frame.view.cuttingLine) {
        setLine(frame.style.cuttingLine, kCuttingWidth, false, frame);
        overLines_.drawCutting();
    }
    if (frame.view.notches) {
        setLine(frame.style.cuttingLine, kNotchWidth, false, frame);
        overLines_.drawNotches();
    }
    if (frame.view.internalLines) {
        setLine(frame.style.cuttingLine, kInternalWidth, false, frame);
        overLines_.drawInternal();
    }
}

void SceneRenderer::drawFeature(const Feature& feature) {
    constexpr int kWholeOutline = std::numeric_limits<int>::max();
    switch (feature.kind) {
        case Feature::Kind::Piece:
            overLines_.drawOutline(feature.piece, 0, kWholeOutline);
            break;
        case Feature::Kind::Seam:
            overLines_.drawSeam(feature.seam);
            break;
        case Feature::Kind::Run:
            overLines_.drawOutline(feature.piece, feature.first, feature.count);
            break;
        case Feature::Kind::Vertex:
            break;
    }
}

void SceneRenderer::paintHighlight(const Frame& frame, float depthShift, const Feature& feature,
                                   bool hovered) {
    const float share = hovered ? kHoveredShare : 1.0F;
    if (isInDepth()) {
        // Show it faintly through the cloth, so that seams on the far side can be found.
        QColor hidden = frame.style.seam;
        hidden.setAlpha(kHiddenSeamAlpha);
        glDisable(GL_DEPTH_TEST);
        beginBlending();
        setLine(hidden, share * kSeamWidth, false, frame);
        drawFeature(feature);
        glDisable(GL_BLEND);
        glEnable(GL_DEPTH_TEST);
    }
    // Without depth writes, the halo cannot cover the line itself at bends.
    glDepthMask(GL_FALSE);
    lines_->setUniformValue("depthShift", 3 * depthShift);
    setLine(frame.style.seamHalo, share * kSeamHaloWidth, false, frame);
    drawFeature(feature);
    setLine(frame.style.seam, share * kSeamWidth, false, frame);
    drawFeature(feature);
    glDepthMask(GL_TRUE);
}

void SceneRenderer::paintBackdrop(const Frame& frame) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    backdrop_->bind();
    backdrop_->setOpaque("topColour", frame.style.top);
    backdrop_->setOpaque("bottomColour", frame.style.bottom);
    backdrop_->setOpaque("gridColour", frame.style.grid);
    glBindVertexArray(emptyArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ++counts_.drawCalls;
    glBindVertexArray(0);
    backdrop_->release();
}

}  // namespace toile::app
