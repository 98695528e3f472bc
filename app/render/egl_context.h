// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/render/offscreen_context.h"

namespace toile {

/// A context of OpenGL 3.3 core that needs neither display nor surface, made current on this thread
/// (EGL with Mesa's surfaceless platform: a graphics card where one may be used, else the
/// processor). Null where there is no such thing, or Toile was built without EGL.
std::unique_ptr<OffscreenContext> makeEglContext();

/// Whether a context of EGL is current on this thread.
bool isEglCurrent();

}  // namespace toile
