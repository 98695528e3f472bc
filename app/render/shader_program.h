// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <QVector3D>
#include <cstddef>
#include <memory>
#include <set>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "app/render/gl.h"
#include "app/render/gl_support.h"
#include "app/render/scene.h"

namespace toile::app {

/// A linked program on the GPU. All calls, including the destructor, need its context current. Set
/// uniforms while it is bound; unknown ones are ignored.
class ShaderProgram {
public:
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void bind() { glUseProgram(program_); }
    void release() { glUseProgram(0); }

    void setUniformValue(const char* name, int value) { glUniform1i(at(name), value); }
    void setUniformValue(const char* name, bool value) { glUniform1i(at(name), value ? 1 : 0); }
    void setUniformValue(const char* name, float value) { glUniform1f(at(name), value); }
    void setUniformValue(const char* name, float x, float y) { glUniform2f(at(name), x, y); }
    void setUniformValue(const char* name, const QColor& colour);  ///< vec4
    void setUniformValueArray(const char* name, const QVector3D* values, int count);
    void setUniformValue(const char* name, const glm::mat4& matrix);
    void setUniformValue(const char* name, const glm::mat3& matrix);
    void setOpaque(const char* name, const QColor& colour);  ///< vec3, without alpha

private:
    friend std::unique_ptr<ShaderProgram> loadProgram(const std::vector<std::string_view>& files,
                                                      QString& problem);
    ShaderProgram();
    /// @return the driver's message if it rejects the source; else empty
    QString addStage(GLenum stage, const QByteArray& source);
    QString link();
    GLint at(const char* uniform) const { return glGetUniformLocation(program_, uniform); }

    GLuint program_ = 0;
};

/// Links a program from resources/shaders. Joins the files of a stage in order, after a `#version`
/// line and the numbers of the overlays. The ending selects the stage: .vert, .geom, .frag; .glsl
/// belongs to the next file.
/// @param problem receives the driver's message if null is returned
std::unique_ptr<ShaderProgram> loadProgram(const std::vector<std::string_view>& files,
                                           QString& problem);

/// Width in texels of the tables that shaders look up; a texel is four numbers.
inline constexpr int kTableWidth = 2048;

/// A table of numbers on the GPU. All calls need the same context current. Call `release` before
/// that context is destroyed.
class TableTexture {
public:
    /// Counts uploads in `counts`, which must outlive this object.
    explicit TableTexture(FrameCounts& counts) : counts_(counts) {}

    /// Replaces the table. A value is a whole number of texels, or a float.
    /// @return false if the table exceeds the graphics card's limits
    template <class Value>
    bool upload(const std::vector<Value>& values) {
        return uploadBytes(values.data(), values.size() * sizeof(Value));
    }
    void bind(int unit) const;
    void release();

private:
    bool uploadBytes(const void* data, std::size_t bytes);

    FrameCounts& counts_;
    GLuint texture_ = 0;
};

/// Per-piece data that shaders look up, changeable without touching the meshes. Texels per piece:
/// (red, green, blue, flags), the columns of the placement's 2 x 2 matrix, (offset x, offset y,
/// grain direction x, y in the piece's own coordinates), and (least, most, 0, 0), the limits of its
/// material's fabric for the overlay, or zeros.
inline constexpr int kTexelsPerPiece = 4;

enum PieceFlag { kPieceSelected = 1, kPieceFlat = 2, kPieceHidden = 4 };

/// @param coloured  use a colour per piece; else one plain colour for all flat pieces
/// @param overlay   selects the fabric limits
std::vector<float> makePieceTable(const Scene& scene, const std::set<int>& selection,
                                  const SheetPlaces& places, bool coloured = true,
                                  Overlay overlay = Overlay::None);

/// The triangles' own values, looked up by gl_PrimitiveID, so that sharp colour edges need no
/// duplicated vertices. In the order of Scene::garment; zeros for pieces that are not flat.
std::vector<FaceValues> garmentFaces(const Scene& scene);

}  // namespace toile::app
