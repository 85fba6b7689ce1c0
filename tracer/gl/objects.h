/// GL objects, each deleted with its owner, or lost with its context (generation.h).
#pragma once

#include "tracer/gl/generation.h"
#include "tracer/gl/gl.h"
#include "tracer/image.h"
#include "tracer/layers.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::gl {

/// A GL name that is deleted with its owner. `Delete` knows how.
template<class Handle, void (*Delete)(Handle)>
class Owned {
  public:
    Owned() = default;
    explicit Owned(Handle handle) : handle_(handle), generation_(generation()) {
        if (handle_) detail::objectMade();
    }
    Owned(Owned&& other) noexcept { swap(other); }
    Owned& operator=(Owned&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Owned() {
        if (!*this) return;
        Delete(handle_);
        detail::objectDeleted();
    }
    /// Empty once its context is gone.
    explicit operator bool() const { return handle_ && generation_ == generation(); }
    Handle get() const { return *this ? handle_ : Handle{}; }

  private:
    void swap(Owned& other) {
        std::swap(handle_, other.handle_);
        std::swap(generation_, other.generation_);
    }

    Handle handle_{};
    unsigned generation_ = 0;
};

namespace detail {
void deleteTexture(GLuint);
void deleteBuffer(GLuint);
void deleteFramebuffer(GLuint);
void deleteRenderbuffer(GLuint);
void deleteVertexArray(GLuint);
void deleteProgram(GLuint);
void deleteShader(GLuint);
void deleteQuery(GLuint);
void deleteSync(GLsync);
} // namespace detail

using Texture = Owned<GLuint, detail::deleteTexture>;
using Buffer = Owned<GLuint, detail::deleteBuffer>;
using Framebuffer = Owned<GLuint, detail::deleteFramebuffer>;
using Renderbuffer = Owned<GLuint, detail::deleteRenderbuffer>;
using VertexArray = Owned<GLuint, detail::deleteVertexArray>;
using ProgramName = Owned<GLuint, detail::deleteProgram>;
using ShaderName = Owned<GLuint, detail::deleteShader>;
using Query = Owned<GLuint, detail::deleteQuery>;
using Sync = Owned<GLsync, detail::deleteSync>;

VertexArray makeVertexArray();
Buffer makeUniformBuffer();
Renderbuffer makeStencil(int width, int height);

/// Colour images hold sRGB-encoded light where the scene is linear; data images (normals, masks) never do.
enum class Texels { Display, Srgb };

/// Mip levels are averaged here, not by the driver, so that every host sees the same ones.
/// Images are asked for one after another, each once, the largest first, and gone before the next.
using ImageSource = std::function<Image(int)>;
/// An array texture that repeats along both sides, of the images whose layers these are.
Texture makeImages(const Layers&, const ImageSource&, Texels);
// No wider or higher than `side`: what is larger is halved.
/// Six faces in GL's order +x −x +y −y +z −z, all of one size.
Texture makeCubemap(const ImageSource&, Texels, int side);
/// All around: repeats along its rows.
Texture makePanorama(Image, Texels, int side);
/// RGBA32F texels in rows of `width`; read with texelFetch.
Texture makeDataTexture(int width, int height);

/// A colour target of its own, of GL_RGBA8, GL_R8, GL_RGBA32F or GL_RGBA32UI texels, read by texelFetch. Empty where
/// the GL cannot draw to it.
struct Target {
    Texture color;
    Framebuffer framebuffer;
    int width = 0, height = 0;
    GLenum format = 0;

    explicit operator bool() const { return bool(framebuffer); }
};
Target makeTarget(int width, int height, GLenum format);
/// What a program puts out second goes into this texture, which is as large.
void attachSecond(const Target&, const Texture&);

/// A block of GL_R32F or GL_R16F texels, and a framebuffer to attach its layers to. Empty where the GL cannot draw to
/// it. Read by texelFetch or, where `filtered`, between texels.
struct Volume {
    Texture texture;
    Framebuffer framebuffer;
    glm::ivec3 size{0};
    GLenum format = 0;

    explicit operator bool() const { return bool(framebuffer); }
};
Volume makeVolume(glm::ivec3 size, GLenum format, bool filtered);

/// Tells when the GPU has done what it was asked for so far, without waiting.
class Fence {
  public:
    void set();
    bool isSet() const { return bool(sync_); }
    /// The GPU has come past it; then it is no longer set.
    bool passed();
    void clear() { sync_ = {}; }

  private:
    Sync sync_;
};

/// A program on its way: compile and link are asked for at once, and only looked at when done.
class Program {
  public:
    Program() = default;
    Program(const std::string& vertex, const std::string& fragment);

    /// Done, well or badly. Does not wait where the GL can tell without (`pollable`), else waits.
    bool finished(bool pollable) const;
    /// After finished(): linked. The logs say why not.
    bool linked() const;
    std::string vertexLog() const;
    std::string fragmentLog() const;
    std::string linkLog() const;

    GLuint get() const { return program_.get(); }
    explicit operator bool() const { return bool(program_); }
    void bindBlock(const char* block, GLuint binding) const;
    void bindSampler(const char* sampler, GLint unit) const; ///< the program must be in use

  private:
    ShaderName vertex_, fragment_;
    ProgramName program_;
};

} // namespace gnomon::gl
