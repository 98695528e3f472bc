// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <QVector3D>
#include <memory>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "app/render/gl.h"

namespace toile {

/// A linked program on the GPU. Every call, the destructor's too, needs its context current.
/// Uniforms are set while it is bound; those that the program does not have are passed by.
class ShaderProgram {
public:
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void bind();
    void release();

    GLint uniformLocation(const char* name) const;
    void setUniformValue(const char* name, int value);
    void setUniformValue(const char* name, bool value) { setUniformValue(name, value ? 1 : 0); }
    void setUniformValue(const char* name, float value);
    void setUniformValue(const char* name, float x, float y);
    void setUniformValue(const char* name, float x, float y, float z);
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

    GLuint program_ = 0;
};

/// Links a program from resources/shaders; files of one stage are joined in the order given, the
/// `#version` line is put in front. Stage by ending: .vert, .geom, .frag; .glsl joins the next.
/// @param problem receives the driver's words where null is returned
std::unique_ptr<ShaderProgram> loadProgram(const std::vector<std::string_view>& files,
                                           QString& problem);

}  // namespace toile
