// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/shader_program.h"

#include <QFile>
#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include "app/render/colour_map.h"
#include "app/render/overlay_values.h"

namespace toile::app {

namespace {

GLenum stageOf(std::string_view file) {
    if (file.ends_with(".vert")) {
        return GL_VERTEX_SHADER;
    }
    return file.ends_with(".geom") ? GL_GEOMETRY_SHADER : GL_FRAGMENT_SHADER;
}

/// The driver's log of a shader or program; never empty.
template <class Parameter, class Log>
QString wordsOf(GLuint object, Parameter parameter, Log log) {
    GLint length = 0;
    parameter(object, GL_INFO_LOG_LENGTH, &length);
    QByteArray words(std::max(length, 1), '\0');
    log(object, static_cast<GLsizei>(words.size()), nullptr, words.data());
    const QString text = QString::fromUtf8(words.constData()).trimmed();
    return text.isEmpty() ? QString("no reason given") : text;
}

/// Declares the number of every overlay in one line: "const int kOverlayNone = 0; ...".
QByteArray overlayNumbers() {
    QByteArray line;
    for (const OverlayTraits& known : kOverlays) {
        line += "const int kO" + QByteArray(known.action.name + 1) + " = " +
                QByteArray::number(static_cast<int>(known.overlay)) + "; ";
    }
    return line + '\n';
}

/// Unbleached cotton, the usual cloth of a toile.
constexpr Rgb kPlainCloth{226, 217, 200};

constexpr std::size_t kTexel = sizeof(float[4]);
static_assert(sizeof(FaceValues) == 2 * kTexel);

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
    glDeleteShader(shader);  // freed with the program
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
    const QByteArray head = "#version 330 core\n" + overlayNumbers();
    QByteArray source = head;
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
        source = head;
    }
    if (const QString words = program->link(); !words.isEmpty()) {
        problem = words;
        return nullptr;
    }
    return program;
}

std::vector<float> makePieceTable(const Scene& scene, const std::set<int>& selection,
                                  const SheetPlaces& places, bool coloured, Overlay overlay) {
    const int count = static_cast<int>(scene.pieces.size());
    std::vector<float> table(static_cast<std::size_t>(count) * 4 * kTexelsPerPiece);
    for (int i = 0; i < count; ++i) {
        const PieceScene& piece = scene.pieces[static_cast<std::size_t>(i)];
        const SheetPlace& place = placeOf(places, i);
        const Rgb own = coloured ? pieceColour(place.colour) : kPlainCloth;
        const Rgb colour = piece.flat ? own : neutralColour();
        const int flags = (selection.count(i) != 0 ? kPieceSelected : 0) |
                          (piece.flat ? kPieceFlat : 0) | (place.hidden ? kPieceHidden : 0);
        float* texel = table.data() + static_cast<std::size_t>(i) * 4 * kTexelsPerPiece;
        texel[0] = static_cast<float>(colour.r) / 255.0F;
        texel[1] = static_cast<float>(colour.g) / 255.0F;
        texel[2] = static_cast<float>(colour.b) / 255.0F;
        texel[3] = static_cast<float>(flags);
        const Eigen::Matrix2d linear = place.placement.linear();
        for (int k = 0; k < 4; ++k) {
            texel[4 + k] = static_cast<float>(linear.data()[k]);  // column-major
        }
        texel[8] = static_cast<float>(place.placement.offset.x());
        texel[9] = static_cast<float>(place.placement.offset.y());
        texel[10] = static_cast<float>(std::cos(place.grain));
        texel[11] = static_cast<float>(std::sin(place.grain));
        const auto limits =
            place.fabric ? fabricLimits(overlay, *place.fabric) : std::optional<OverlayLimits>();
        // Inverted limits mark a fabric of its own without limits.
        texel[12] = static_cast<float>(limits ? limits->least : place.fabric ? 1 : 0);
        texel[13] = static_cast<float>(limits ? limits->most : 0);
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

bool TableTexture::uploadBytes(const void* data, std::size_t bytes) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::size_t texels = bytes / kTexel, whole = texels / kTableWidth,
                      rest = texels % kTableWidth;
    const std::size_t rows = std::max<std::size_t>(1, whole + (rest > 0 ? 1 : 0));
    if (rows > static_cast<std::size_t>(most)) {
        return false;
    }
    if (texture_ == 0) {
        glGenTextures(1, &texture_);
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kTableWidth, static_cast<GLsizei>(rows), 0, GL_RGBA,
                 GL_FLOAT, nullptr);
    const auto put = [data](std::size_t row, std::size_t width, std::size_t height) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), static_cast<GLsizei>(width),
                        static_cast<GLsizei>(height), GL_RGBA, GL_FLOAT,
                        static_cast<const std::byte*>(data) + row * kTableWidth * kTexel);
    };
    if (whole > 0) {
        put(0, kTableWidth, whole);
    }
    if (rest > 0) {
        put(whole, rest, 1);
    }
    counts_.uploadedBytes += bytes;
    return true;
}

void TableTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_);
}

void TableTexture::release() {
    glDeleteTextures(1, &texture_);
    texture_ = 0;
}

}  // namespace toile::app
