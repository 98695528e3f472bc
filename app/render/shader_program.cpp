// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/shader_program.h"

#include <QFile>
#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include "app/render/colour_map.h"

namespace toile::app {

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

/// Unbleached cotton, as a toile is made of.
constexpr Rgb kPlainCloth{226, 217, 200};

constexpr std::size_t kFacesPerRow = kFaceTableWidth / 2;
static_assert(sizeof(FaceValues) == sizeof(float[2][4]));

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

void ShaderProgram::setUniformValue(const char* name, const QColor& colour) {
    glUniform4f(at(name), colour.redF(), colour.greenF(), colour.blueF(), colour.alphaF());
}

void ShaderProgram::setUniformValueArray(const char* name, const QVector3D* values, int count) {
    static_assert(sizeof(QVector3D) == 3 * sizeof(float));
    glUniform3fv(at(name), count, reinterpret_cast<const float*>(values));
}

void ShaderProgram::setUniformValue(const char* name, const glm::mat4& matrix) {
    glUniformMatrix4fv(at(name), 1, GL_FALSE, glm::value_ptr(matrix));
}

void ShaderProgram::setUniformValue(const char* name, const glm::mat3& matrix) {
    glUniformMatrix3fv(at(name), 1, GL_FALSE, glm::value_ptr(matrix));
}

void ShaderProgram::setOpaque(const char* name, const QColor& colour) {
    glUniform3f(at(name), colour.redF(), colour.greenF(), colour.blueF());
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

PieceTable makePieceTable(const Scene& scene, const std::set<int>& selection,
                          const SheetPlaces& places, bool coloured) {
    const int count = static_cast<int>(scene.pieces.size());
    PieceTable table;
    table.height = std::max(1, (kTexelsPerPiece * count + kPieceTableWidth - 1) / kPieceTableWidth);
    table.texels.assign(
        static_cast<std::size_t>(4) * kPieceTableWidth * static_cast<std::size_t>(table.height),
        0.0F);
    for (int i = 0; i < count; ++i) {
        const PieceScene& piece = scene.pieces[static_cast<std::size_t>(i)];
        const SheetPlace& place = placeOf(places, i);
        const Rgb own = coloured ? pieceColour(place.colour) : kPlainCloth;
        const Rgb colour = piece.flat ? own : neutralColour();
        const int flags =
            (selection.count(i) != 0 ? kPieceSelected : 0) | (piece.flat ? kPieceFlat : 0);
        float* texel = table.texels.data() + static_cast<std::size_t>(i) * 4 * kTexelsPerPiece;
        texel[0] = static_cast<float>(colour.r) / 255.0F;
        texel[1] = static_cast<float>(colour.g) / 255.0F;
        texel[2] = static_cast<float>(colour.b) / 255.0F;
        texel[3] = static_cast<float>(flags);
        const Eigen::Matrix2d linear = place.placement.linear();
        for (int k = 0; k < 4; ++k) {
            texel[4 + k] = static_cast<float>(linear.data()[k]);  // column by column
        }
        texel[8] = static_cast<float>(place.placement.offset.x());
        texel[9] = static_cast<float>(place.placement.offset.y());
        texel[10] = static_cast<float>(std::cos(place.grain));
        texel[11] = static_cast<float>(std::sin(place.grain));
    }
    return table;
}

std::vector<FaceValues> garmentFaces(const Scene& scene) {
    std::vector<FaceValues> faces(scene.garment.triangles.size() / 3, FaceValues{});
    for (const PieceScene& piece : scene.pieces) {
        const auto from = scene.faces.begin() + piece.patternRun.first;
        std::copy_n(from, piece.patternRun.count, faces.begin() + piece.garmentRun.first);
    }
    return faces;
}

bool FaceTable::upload(std::span<const FaceValues> faces) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::size_t rows =
        std::max<std::size_t>(1, (faces.size() + kFacesPerRow - 1) / kFacesPerRow);
    if (rows > static_cast<std::size_t>(most)) {
        return false;
    }
    if (texture_ == 0) {
        glGenTextures(1, &texture_);
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kFaceTableWidth, static_cast<GLsizei>(rows), 0,
                 GL_RGBA, GL_FLOAT, nullptr);
    const std::size_t whole = faces.size() / kFacesPerRow, rest = faces.size() % kFacesPerRow;
    if (whole > 0) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kFaceTableWidth, static_cast<GLsizei>(whole),
                        GL_RGBA, GL_FLOAT, faces.data());
    }
    if (rest > 0) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(whole),
                        static_cast<GLsizei>(2 * rest), 1, GL_RGBA, GL_FLOAT,
                        faces.data() + whole * kFacesPerRow);
    }
    counts_.uploadedBytes += faces.size_bytes();
    return true;
}

void FaceTable::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_);
}

void FaceTable::release() {
    glDeleteTextures(1, &texture_);
    texture_ = 0;
}

}  // namespace toile::app
