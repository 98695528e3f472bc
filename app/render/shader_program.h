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

/// A linked program on the GPU. Every call, the destructor's too, needs its context current.
/// Uniforms are set while it is bound; those that the program does not have are passed by.
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
    /// @return the driver's words where it refuses the source; else empty
    QString addStage(GLenum stage, const QByteArray& source);
    QString link();
    GLint at(const char* uniform) const { return glGetUniformLocation(program_, uniform); }

    GLuint program_ = 0;
};

/// Links a program from resources/shaders; files of one stage are joined in the order given, the
/// `#version` line is put in front. Stage by ending: .vert, .geom, .frag; .glsl joins the next.
/// @param problem receives the driver's words where null is returned
std::unique_ptr<ShaderProgram> loadProgram(const std::vector<std::string_view>& files,
                                           QString& problem);

/// Numbers that shaders look up: four of them a texel, in rows of this many texels.
inline constexpr int kTableWidth = 2048;

/// A table of them on the GPU. Every call needs the same context current; `release` before that
/// context goes.
class TableTexture {
public:
    /// Uploads are counted there; must outlive this object.
    explicit TableTexture(FrameCounts& counts) : counts_(counts) {}

    /// Replaces what was there. A value is a whole number of texels, or they are floats.
    /// @return false where the graphics card has no room for so many
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

/// What may change per piece without touching the meshes, as the shaders look it up, so many texels
/// per piece: (red, green, blue, flags), the columns of the placement's 2 x 2 matrix, (offset x,
/// offset y, the grain's direction in the piece's own coordinates: x, y), and (least, most, 0, 0)
/// that the fabric of its material allows of the overlay, or zeros.
inline constexpr int kTexelsPerPiece = 4;

enum PieceFlag { kPieceSelected = 1, kPieceFlat = 2, kPieceHidden = 4 };

/// @param coloured  pieces have colours of their own; else all that are flat have a plain one
/// @param overlay   for what fabrics allow
std::vector<float> makePieceTable(const Scene& scene, const std::set<int>& selection,
                                  const SheetPlaces& places, bool coloured = true,
                                  Overlay overlay = Overlay::None);

/// The triangles' own values, looked up by gl_PrimitiveID, so that vertices need not be doubled for
/// colours that end at edges. In the order of Scene::garment; zeros for pieces that are not flat.
std::vector<FaceValues> garmentFaces(const Scene& scene);

}  // namespace toile::app
