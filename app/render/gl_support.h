// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>
#include <cstddef>

namespace toile::app {

/// Samples per pixel, in windows and pictures: 4, or the value of TOILE_SAMPLES. A value of 1
/// halves the work of software rendering, but edges look jagged.
int samplesPerPixel();

/// The format of every view: OpenGL 3.3 core with depth and multisampling.
QSurfaceFormat sceneSurfaceFormat();

/// False on Qt platforms without a screen. Some of them create contexts if an X display answers,
/// but Qt aborts when a widget is drawn with one.
bool hasScreen();

/// Tries to create a context. @return a message about the problem; empty if there is none. GUI
/// thread.
QString glProblem();

/// Version and vendor of OpenGL, "4.5 (Core Profile) Mesa 22.3.6, llvmpipe"; empty without OpenGL.
/// GUI thread.
QString glDescription();

/// Whether a context of Qt or of offscreen.h is current and has OpenGL 3.3.
bool hasGl();

/// Turns on alpha blending.
void beginBlending();

/// Totals of one renderer's requests to the graphics driver, without the text over the view.
struct FrameCounts {
    int drawCalls = 0;
    std::size_t uploadedBytes = 0;  ///< to buffers and textures
};

}  // namespace toile::app
