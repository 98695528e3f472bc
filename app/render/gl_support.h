// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>
#include <cstddef>

namespace toile::app {

/// Samples per pixel, in windows and pictures alike: 4, or what the environment says in
/// TOILE_SAMPLES (1 halves the work where a processor draws, and edges show steps).
int samplesPerPixel();

/// OpenGL 3.3 core with depth and so many samples per pixel: what every view asks for.
QSurfaceFormat sceneSurfaceFormat();

/// False on platforms of Qt without a screen. Some make contexts where an X display answers too,
/// but no widget can be drawn by them: Qt ends with a signal.
bool hasScreen();

/// Tries to make a context. @return what is missing, as a sentence for a person; empty if all is
/// well. GUI thread.
QString glProblem();

/// Version and maker of OpenGL here, "4.5 (Core Profile) Mesa 22.3.6, llvmpipe"; empty where there
/// is none. GUI thread.
QString glDescription();

/// Whether a context is current, be it Qt's or one of offscreen.h, and has OpenGL 3.3.
bool hasGl();

/// What is drawn next covers by its alpha.
void beginBlending();

/// What the frames of one renderer have asked of the graphics driver so far. Writing over the view
/// is not in it.
struct FrameCounts {
    int drawCalls = 0;
    std::size_t uploadedBytes = 0;  ///< to buffers and textures
};

}  // namespace toile::app
