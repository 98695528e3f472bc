// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/shader_program.h"

#include <QFile>

#include <glm/gtc/type_ptr.hpp>

namespace toile {

namespace {

GLenum stageOf(std::string_view file) {
    if (file.ends_with(".vert")) {
        return GL_VERTEX_SHADER;
    }
    return file.ends_with(".geom") ? GL_GEOMETRY_SHADER : GL_FRAGMENT_SHADER;
}

/// What the driver says of a shader or a program; never empty.
template <class Parameter, class Log>
QString wordsOf(GLuint object, Parameter parameter, Log log) {
    GLint length = 0;
    parameter(object, GL_INFO_LOG_LENGTH, &length);
    QByteArray words(std::max(length, 1), '\0');
    log(object, static_cast<GLsizei>(words.size()), nullptr, words.data());
    const QString text = QString::fromUtf8(words.constData()).trimmed();
    return text.isEmpty() ? QString("no reason given") : text;
}

}  // namespace

ShaderProgram::ShaderProgram() : program_(glCreateProgram()) {}

ShaderProgram::~ShaderProgram() {
    glDeleteProgram(program_);
}

QString ShaderProgram::addStage(GLenum stage, const QByteArray& source) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.constData();
    const auto length = static_cast<GLint>(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    QString problem;
    if (done == GL_TRUE) {
        glAttachShader(program_, shader);
    } else {
        problem = wordsOf(shader, glGetShaderiv, glGetShaderInfoLog);
    }
    glDeleteShader(shader);  // the program keeps it as long as it needs it
    return problem;
}

QString ShaderProgram::link() {
    glLinkProgram(program_);
    GLint done = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &done);
    return done == GL_TRUE ? QString() : wordsOf(program_, glGetProgramiv, glGetProgramInfoLog);
}

void ShaderProgram::bind() {
    glUseProgram(program_);
}

void ShaderProgram::release() {
    glUseProgram(0);
}

GLint ShaderProgram::uniformLocation(const char* name) const {
    return glGetUniformLocation(program_, name);
}

void ShaderProgram::setUniformValue(const char* name, int value) {
    glUniform1i(uniformLocation(name), value);
}

void ShaderProgram::setUniformValue(const char* name, float value) {
    glUniform1f(uniformLocation(name), value);
}

void ShaderProgram::setUniformValue(const char* name, float x, float y) {
    glUniform2f(uniformLocation(name), x, y);
}

void ShaderProgram::setUniformValue(const char* name, float x, float y, float z) {
    glUniform3f(uniformLocation(name), x, y, z);
}

void ShaderProgram::setUniformValue(const char* name, const QColor& colour) {
    glUniform4f(uniformLocation(name), colour.redF(), colour.greenF(), colour.blueF(),
                colour.alphaF());
}

void ShaderProgram::setUniformValueArray(const char* name, const QVector3D* values, int count) {
    static_assert(sizeof(QVector3D) == 3 * sizeof(float));
    glUniform3fv(uniformLocation(name), count, reinterpret_cast<const float*>(values));
}

void ShaderProgram::setUniformValue(const char* name, const glm::mat4& matrix) {
    glUniformMatrix4fv(uniformLocation(name), 1, GL_FALSE, glm::value_ptr(matrix));
}

void ShaderProgram::setUniformValue(const char* name, const glm::mat3& matrix) {
    glUniformMatrix3fv(uniformLocation(name), 1, GL_FALSE, glm::value_ptr(matrix));
}

void ShaderProgram::setOpaque(const char* name, const QColor& colour) {
    setUniformValue(name, colour.redF(), colour.greenF(), colour.blueF());
}

std::unique_ptr<ShaderProgram> loadProgram(const std::vector<std::string_view>& files,
                                           QString& problem) {
    std::unique_ptr<ShaderProgram> program(new ShaderProgram());
    const QByteArray version = "#version 330 core\n";
    QByteArray source = version;
    for (const std::string_view name : files) {
        QFile file(":/shaders/" + QString::fromUtf8(name));
        if (!file.open(QIODevice::ReadOnly)) {
            problem = file.fileName();
            return nullptr;
        }
        source += file.readAll();
        if (name.ends_with(".glsl")) {
            continue;
        }
        if (const QString words = program->addStage(stageOf(name), source); !words.isEmpty()) {
            problem = file.fileName() + ": " + words;
            return nullptr;
        }
        source = version;
    }
    if (const QString words = program->link(); !words.isEmpty()) {
        problem = words;
        return nullptr;
    }
    return program;
}

}  // namespace toile
