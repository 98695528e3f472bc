// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>
#include <memory>

#include "app/render/gl.h"

namespace toile {

/// Samples per pixel, in windows and pictures alike.
inline constexpr int kSamples = 4;

/// OpenGL 3.3 core with depth and four samples per pixel: what every view asks for.
QSurfaceFormat sceneSurfaceFormat();

/// False on platforms of Qt without a screen. Some make contexts where an X display answers too,
/// but no widget can be drawn by them: Qt ends with a signal.
bool hasScreen();

/// Tries to make a context. @return what is missing, as a sentence for a person; empty if all is
/// well. GUI thread.
QString glProblem();

/// The functions of the current context, be it Qt's or one of offscreen_context.h; null where there
/// is none, or one older than 3.3 core.
std::unique_ptr<Gl> currentGl();

/// What is drawn next covers by its alpha.
void beginBlending(Gl& gl);

}  // namespace toile
