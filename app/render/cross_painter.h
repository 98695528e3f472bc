// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "app/render/gl_support.h"
#include "app/render/shader_program.h"
#include "app/render/stretch_crosses.h"

namespace toile {

/// Draws the principal strains as crosses: one draw call, as many places as the scale of the view
/// has room for, and nothing uploaded when that changes. Every call needs the same context current.
class CrossPainter {
public:
    /// Draw calls and uploads are counted there; must outlive this object.
    explicit CrossPainter(FrameCounts& counts);
    ~CrossPainter();

    /// @return whether the driver takes the shaders; `problem` receives its words where not
    bool initialize(const std::vector<std::string_view>& files, QString& problem);
    /// Replaces what was there.
    void upload(const StretchCrosses& crosses);
    /// The bound program, for the uniforms that the renderers share.
    ShaderProgram& begin();
    /// @param millimetresPerPixel of the cloth, logical pixels
    void draw(const StretchCrosses& crosses, double millimetresPerPixel);
    void release();

private:
    FrameCounts& counts_;
    std::unique_ptr<ShaderProgram> program_;
    GLuint array_ = 0, vertices_ = 0;
};

}  // namespace toile
