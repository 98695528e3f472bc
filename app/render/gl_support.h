// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLFunctions_3_3_Core>
#include <QString>
#include <QSurfaceFormat>
#include <memory>
#include <string_view>
#include <vector>

class QOpenGLShaderProgram;

namespace toile {

using Gl = QOpenGLFunctions_3_3_Core;

/// OpenGL 3.3 core with depth and four samples per pixel: what every view asks for.
QSurfaceFormat sceneSurfaceFormat();

/// Tries to make a context. @return what is missing, as a sentence for a person; empty if all is
/// well. GUI thread.
QString glProblem();

/// The functions of the current context; null where it is older than 3.3 core.
Gl* currentGl();

/// Links a program from resources/shaders; files of one stage are joined in the order given, the
/// `#version` line is put in front. Stage by ending: .vert, .geom, .frag; .glsl joins the next.
/// @param problem receives the driver's words where null is returned
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const std::vector<std::string_view>& files,
                                                  QString& problem);

}  // namespace toile
