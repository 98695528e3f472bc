// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// OpenGL through libepoxy, which resolves functions for the current context (Qt or offscreen.h). It
// must be included before GL/gl.h, which Qt's headers include. If Qt's came first, the declarations
// differ in one extension's parameter only.
#undef __gl_h_
#undef __glext_h_
#define PFNGLPATHGLYPHINDEXRANGENVPROC EpoxyPathGlyphIndexRange
#include <epoxy/gl.h>
#undef PFNGLPATHGLYPHINDEXRANGENVPROC
