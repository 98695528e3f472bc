// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/framebuffer.h"

#include <algorithm>

#include "app/render/gl_support.h"

namespace toile {

namespace {

constexpr int kFlags = 8;  ///< of errors, more than OpenGL has

GLuint makeRenderbuffer(int samples, GLenum format, int width, int height) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return buffer;
}

}  // namespace

Framebuffer::~Framebuffer() {
    freeTarget(drawn_);
    freeTarget(resolved_);
}

void Framebuffer::freeTarget(Target& target) {
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteRenderbuffers(1, &target.colour);
    glDeleteRenderbuffers(1, &target.depth);
    target = {};
}

bool Framebuffer::makeTarget(Target& target, int samples, bool withDepth) {
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    target.colour = makeRenderbuffer(samples, GL_RGBA8, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour);
    if (withDepth) {
        target.depth = makeRenderbuffer(samples, GL_DEPTH_COMPONENT24, width_, height_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  target.depth);
    }
    return glGetError() == GL_NO_ERROR &&
           glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool Framebuffer::make(int width, int height) {
    GLint most = 0, samples = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    if (width < 1 || height < 1 || width > most || height > most) {
        return false;
    }
    width_ = width;
    height_ = height;
    for (int i = 0; i < kFlags && glGetError() != GL_NO_ERROR; ++i) {
        // What came before is not ours.
    }
    return makeTarget(resolved_, 0, false) &&
           makeTarget(drawn_, std::min(samplesPerPixel(), samples), true);
}

QImage Framebuffer::read() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.framebuffer);
    QImage image(width_, height_, QImage::Format_RGBX8888);
    if (image.isNull()) {
        return image;
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer);
    return image.mirrored();
}

}  // namespace toile
