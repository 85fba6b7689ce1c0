#include "tracer/software/coverage.h"

namespace gnomon {

Coverage::Coverage(const gl::Target& target, Kind kind) : kind_(kind) {
    if (kind == Kind::None) return;
    if (kind == Kind::Mask) {
        gl::Target mask = gl::makeTarget(target.width, target.height, GL_R8);
        mask_ = std::move(mask.color);
    } else {
        stencil_ = gl::makeStencil(target.width, target.height);
    }
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    framebuffer_ = gl::Framebuffer(name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.color.get(), 0);
    if (kind == Kind::Stencil) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, stencil_.get());
        return;
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, mask_.get(), 0);
    const GLenum outputs[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, outputs);
}

void Coverage::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    if (kind_ == Kind::Stencil) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_NOTEQUAL, 1, 0xFF);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        glClearStencil(0);
        glClear(GL_STENCIL_BUFFER_BIT);
    } else {
        const float nothing[4] = {};
        glClearBufferfv(GL_COLOR, 1, nothing);
    }
}

void Coverage::end(const gl::Target& target) const {
    glDisable(GL_STENCIL_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
}

} // namespace gnomon
