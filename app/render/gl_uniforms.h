// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "app/render/shader_program.h"

namespace toile {

/// Uniforms from the types that cameras and styles speak; the program must be bound.

inline void setUniform(ShaderProgram& program, const char* name, const glm::mat4& matrix) {
    glUniformMatrix4fv(program.uniformLocation(name), 1, GL_FALSE, glm::value_ptr(matrix));
}

inline void setUniform(ShaderProgram& program, const char* name, const glm::mat3& matrix) {
    glUniformMatrix3fv(program.uniformLocation(name), 1, GL_FALSE, glm::value_ptr(matrix));
}

/// As vec3, without alpha.
inline void setUniform(ShaderProgram& program, const char* name, const QColor& colour) {
    program.setUniformValue(name, colour.redF(), colour.greenF(), colour.blueF());
}

}  // namespace toile
