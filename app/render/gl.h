// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <qopengl.h>

namespace toile {

/// What Toile calls of OpenGL 3.3 core: TOILE_GL_FUNCTION(name) for those of OpenGL 1.1, which have
/// prototypes everywhere, TOILE_GL_FUNCTION_OF(type, name) for the others.
#define TOILE_GL_FUNCTIONS(TOILE_GL_FUNCTION, TOILE_GL_FUNCTION_OF)                   \
    TOILE_GL_FUNCTION(glBindTexture)                                                  \
    TOILE_GL_FUNCTION(glClear)                                                        \
    TOILE_GL_FUNCTION(glCullFace)                                                     \
    TOILE_GL_FUNCTION(glDeleteTextures)                                               \
    TOILE_GL_FUNCTION(glDepthFunc)                                                    \
    TOILE_GL_FUNCTION(glDepthMask)                                                    \
    TOILE_GL_FUNCTION(glDisable)                                                      \
    TOILE_GL_FUNCTION(glDrawArrays)                                                   \
    TOILE_GL_FUNCTION(glDrawElements)                                                 \
    TOILE_GL_FUNCTION(glEnable)                                                       \
    TOILE_GL_FUNCTION(glGenTextures)                                                  \
    TOILE_GL_FUNCTION(glGetError)                                                     \
    TOILE_GL_FUNCTION(glGetIntegerv)                                                  \
    TOILE_GL_FUNCTION(glGetString)                                                    \
    TOILE_GL_FUNCTION(glPixelStorei)                                                  \
    TOILE_GL_FUNCTION(glPolygonOffset)                                                \
    TOILE_GL_FUNCTION(glReadPixels)                                                   \
    TOILE_GL_FUNCTION(glTexImage2D)                                                   \
    TOILE_GL_FUNCTION(glTexParameteri)                                                \
    TOILE_GL_FUNCTION(glTexSubImage2D)                                                \
    TOILE_GL_FUNCTION(glViewport)                                                     \
    TOILE_GL_FUNCTION_OF(PFNGLACTIVETEXTUREPROC, glActiveTexture)                     \
    TOILE_GL_FUNCTION_OF(PFNGLATTACHSHADERPROC, glAttachShader)                       \
    TOILE_GL_FUNCTION_OF(PFNGLBINDBUFFERPROC, glBindBuffer)                           \
    TOILE_GL_FUNCTION_OF(PFNGLBINDFRAMEBUFFERPROC, glBindFramebuffer)                 \
    TOILE_GL_FUNCTION_OF(PFNGLBINDRENDERBUFFERPROC, glBindRenderbuffer)               \
    TOILE_GL_FUNCTION_OF(PFNGLBINDVERTEXARRAYPROC, glBindVertexArray)                 \
    TOILE_GL_FUNCTION_OF(PFNGLBLENDFUNCSEPARATEPROC, glBlendFuncSeparate)             \
    TOILE_GL_FUNCTION_OF(PFNGLBLITFRAMEBUFFERPROC, glBlitFramebuffer)                 \
    TOILE_GL_FUNCTION_OF(PFNGLBUFFERDATAPROC, glBufferData)                           \
    TOILE_GL_FUNCTION_OF(PFNGLBUFFERSUBDATAPROC, glBufferSubData)                     \
    TOILE_GL_FUNCTION_OF(PFNGLCHECKFRAMEBUFFERSTATUSPROC, glCheckFramebufferStatus)   \
    TOILE_GL_FUNCTION_OF(PFNGLCOMPILESHADERPROC, glCompileShader)                     \
    TOILE_GL_FUNCTION_OF(PFNGLCREATEPROGRAMPROC, glCreateProgram)                     \
    TOILE_GL_FUNCTION_OF(PFNGLCREATESHADERPROC, glCreateShader)                       \
    TOILE_GL_FUNCTION_OF(PFNGLDELETEBUFFERSPROC, glDeleteBuffers)                     \
    TOILE_GL_FUNCTION_OF(PFNGLDELETEFRAMEBUFFERSPROC, glDeleteFramebuffers)           \
    TOILE_GL_FUNCTION_OF(PFNGLDELETEPROGRAMPROC, glDeleteProgram)                     \
    TOILE_GL_FUNCTION_OF(PFNGLDELETERENDERBUFFERSPROC, glDeleteRenderbuffers)         \
    TOILE_GL_FUNCTION_OF(PFNGLDELETESHADERPROC, glDeleteShader)                       \
    TOILE_GL_FUNCTION_OF(PFNGLDELETEVERTEXARRAYSPROC, glDeleteVertexArrays)           \
    TOILE_GL_FUNCTION_OF(PFNGLENABLEVERTEXATTRIBARRAYPROC, glEnableVertexAttribArray) \
    TOILE_GL_FUNCTION_OF(PFNGLFRAMEBUFFERRENDERBUFFERPROC, glFramebufferRenderbuffer) \
    TOILE_GL_FUNCTION_OF(PFNGLGENBUFFERSPROC, glGenBuffers)                           \
    TOILE_GL_FUNCTION_OF(PFNGLGENFRAMEBUFFERSPROC, glGenFramebuffers)                 \
    TOILE_GL_FUNCTION_OF(PFNGLGENRENDERBUFFERSPROC, glGenRenderbuffers)               \
    TOILE_GL_FUNCTION_OF(PFNGLGENVERTEXARRAYSPROC, glGenVertexArrays)                 \
    TOILE_GL_FUNCTION_OF(PFNGLGETPROGRAMINFOLOGPROC, glGetProgramInfoLog)             \
    TOILE_GL_FUNCTION_OF(PFNGLGETPROGRAMIVPROC, glGetProgramiv)                       \
    TOILE_GL_FUNCTION_OF(PFNGLGETSHADERINFOLOGPROC, glGetShaderInfoLog)               \
    TOILE_GL_FUNCTION_OF(PFNGLGETSHADERIVPROC, glGetShaderiv)                         \
    TOILE_GL_FUNCTION_OF(PFNGLGETUNIFORMLOCATIONPROC, glGetUniformLocation)           \
    TOILE_GL_FUNCTION_OF(PFNGLLINKPROGRAMPROC, glLinkProgram)                         \
    TOILE_GL_FUNCTION_OF(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC,                     \
                         glRenderbufferStorageMultisample)                            \
    TOILE_GL_FUNCTION_OF(PFNGLSHADERSOURCEPROC, glShaderSource)                       \
    TOILE_GL_FUNCTION_OF(PFNGLUNIFORM1FPROC, glUniform1f)                             \
    TOILE_GL_FUNCTION_OF(PFNGLUNIFORM1IPROC, glUniform1i)                             \
    TOILE_GL_FUNCTION_OF(PFNGLUNIFORM2FPROC, glUniform2f)                             \
    TOILE_GL_FUNCTION_OF(PFNGLUNIFORM3FPROC, glUniform3f)                             \
    TOILE_GL_FUNCTION_OF(PFNGLUNIFORM3FVPROC, glUniform3fv)                           \
    TOILE_GL_FUNCTION_OF(PFNGLUNIFORM4FPROC, glUniform4f)                             \
    TOILE_GL_FUNCTION_OF(PFNGLUNIFORMMATRIX3FVPROC, glUniformMatrix3fv)               \
    TOILE_GL_FUNCTION_OF(PFNGLUNIFORMMATRIX4FVPROC, glUniformMatrix4fv)               \
    TOILE_GL_FUNCTION_OF(PFNGLUSEPROGRAMPROC, glUseProgram)                           \
    TOILE_GL_FUNCTION_OF(PFNGLVERTEXATTRIBPOINTERPROC, glVertexAttribPointer)

/// The functions of OpenGL 3.3 core of one context, under their own names. Qt's table of them needs
/// a context of Qt's, and where there is no display Qt makes none (see offscreen_context.h).
struct Gl {
#define TOILE_GL_FUNCTION(name) decltype(&::name) name = nullptr;
#define TOILE_GL_FUNCTION_OF(type, name) type name = nullptr;
    TOILE_GL_FUNCTIONS(TOILE_GL_FUNCTION, TOILE_GL_FUNCTION_OF)
#undef TOILE_GL_FUNCTION
#undef TOILE_GL_FUNCTION_OF
};

/// Any function, to be cast to what it is.
using GlFunction = void (*)();
/// Finds a function of the current context by its name; null where there is none.
using GlLookup = std::function<GlFunction(const char*)>;

/// @return null where a function is missing, or the current context is older than 3.3 or one of
/// OpenGL ES
std::unique_ptr<Gl> loadGl(const GlLookup& lookup);

}  // namespace toile
