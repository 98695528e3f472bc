// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/framebuffer.h"

#include <algorithm>

#include "app/render/gl_support.h"

namespace toile {

namespace {

constexpr int kFlags = 8;  ///< of errors, more than OpenGL has

GLuint makeRenderbuffer(Gl& gl, int samples, GLenum format, int width, int height) {
    GLuint buffer = 0;
    gl.glGenRenderbuffers(1, &buffer);
    gl.glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return buffer;
}

}  // namespace

Framebuffer::~Framebuffer() {
    freeTarget(drawn_);
    freeTarget(resolved_);
}

void Framebuffer::freeTarget(Target& target) {
    gl_.glDeleteFramebuffers(1, &target.framebuffer);
    gl_.glDeleteRenderbuffers(1, &target.colour);
    gl_.glDeleteRenderbuffers(1, &target.depth);
    target = {};
}

bool Framebuffer::makeTarget(Target& target, int samples, bool withDepth) {
    gl_.glGenFramebuffers(1, &target.framebuffer);
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    target.colour = makeRenderbuffer(gl_, samples, GL_RGBA8, width_, height_);
    gl_.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  target.colour);
    if (withDepth) {
        target.depth = makeRenderbuffer(gl_, samples, GL_DEPTH_COMPONENT24, width_, height_);
        gl_.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                      target.depth);
    }
    return gl_.glGetError() == GL_NO_ERROR &&
           gl_.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool Framebuffer::make(int width, int height) {
    GLint most = 0, samples = 0;
    gl_.glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    gl_.glGetIntegerv(GL_MAX_SAMPLES, &samples);
    if (width < 1 || height < 1 || width > most || height > most) {
        return false;
    }
    width_ = width;
    height_ = height;
    for (int i = 0; i < kFlags && gl_.glGetError() != GL_NO_ERROR; ++i) {
        // What came before is not ours.
    }
    return makeTarget(resolved_, 0, false) &&
           makeTarget(drawn_, std::min<int>(kSamples, samples), true);
}

QImage Framebuffer::read() {
    gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
    gl_.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer);
    gl_.glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.framebuffer);
    QImage image(width_, height_, QImage::Format_RGBX8888);
    if (image.isNull()) {
        return image;
    }
    gl_.glPixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer);
    return image.mirrored();
}

}  // namespace toile
