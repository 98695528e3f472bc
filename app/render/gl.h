// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// OpenGL by libepoxy: each function is found in whichever context is current, Qt's or one of
// offscreen.h. It wants to be there before GL/gl.h, which Qt's headers bring. Where Qt's
// were first, the two say the same but for the parameter of one extension.
#undef __gl_h_
#undef __glext_h_
#define PFNGLPATHGLYPHINDEXRANGENVPROC EpoxyPathGlyphIndexRange
#include <epoxy/gl.h>
#undef PFNGLPATHGLYPHINDEXRANGENVPROC
