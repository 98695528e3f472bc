// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/gl.h"

#include <string_view>

namespace toile {

namespace {

bool isNewEnough(const Gl& gl) {
    const auto* name = reinterpret_cast<const char*>(gl.glGetString(GL_VERSION));
    if (!name || std::string_view(name).starts_with("OpenGL ES")) {
        return false;
    }
    GLint major = 0, minor = 0;
    gl.glGetIntegerv(GL_MAJOR_VERSION, &major);
    gl.glGetIntegerv(GL_MINOR_VERSION, &minor);
    return major > 3 || (major == 3 && minor >= 3);
}

}  // namespace

std::unique_ptr<Gl> loadGl(const GlLookup& lookup) {
    auto gl = std::make_unique<Gl>();
    bool complete = true;
    const auto find = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(lookup(name));
        complete = complete && function != nullptr;
    };
#define TOILE_GL_FUNCTION(name) find(gl->name, #name);
#define TOILE_GL_FUNCTION_OF(type, name) find(gl->name, #name);
    TOILE_GL_FUNCTIONS(TOILE_GL_FUNCTION, TOILE_GL_FUNCTION_OF)
#undef TOILE_GL_FUNCTION
#undef TOILE_GL_FUNCTION_OF
    return complete && isNewEnough(*gl) ? std::move(gl) : nullptr;
}

}  // namespace toile
