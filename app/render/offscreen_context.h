// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

namespace toile {

/// A context of OpenGL 3.3 to draw in without a window. It is current on the thread that made it
/// until it goes.
class OffscreenContext {
public:
    virtual ~OffscreenContext() = default;
};

/// Makes a context and makes it current: of the display where Qt has one that offers OpenGL, else
/// one that needs no display. Needs a QGuiApplication; GUI thread.
/// @param problem  receives a sentence for a person where null is returned
std::unique_ptr<OffscreenContext> makeOffscreenContext(QString& problem);

/// A context of OpenGL 3.3 core that needs neither display nor surface, made current on this thread
/// (EGL with Mesa's surfaceless platform: a graphics card where one may be used, else the
/// processor). Null where there is no such thing, or Toile was built without EGL.
std::unique_ptr<OffscreenContext> makeEglContext();

/// Whether a context of EGL is current on this thread.
bool isEglCurrent();

}  // namespace toile
