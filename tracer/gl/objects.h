/// GL objects with an owner. forget() drops the name without touching GL: for a context that is gone.
#pragma once

#include "tracer/gl/gl.h"
#include "tracer/image.h"
#include "tracer/layers.h"

#include <string>
#include <utility>
#include <vector>

namespace gnomon::gl {

/// A GL name that is deleted with its owner. `Delete` knows how.
template<void (*Delete)(GLuint)>
class Name {
  public:
    Name() = default;
    explicit Name(GLuint name) : name_(name) {}
    Name(Name&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Name& operator=(Name&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Name() {
        if (name_ != 0) Delete(name_);
    }
    GLuint get() const { return name_; }
    explicit operator bool() const { return name_ != 0; }
    void forget() { name_ = 0; }

  private:
    GLuint name_ = 0;
};

namespace detail {
void deleteTexture(GLuint);
void deleteBuffer(GLuint);
void deleteFramebuffer(GLuint);
void deleteVertexArray(GLuint);
void deleteProgram(GLuint);
void deleteShader(GLuint);
} // namespace detail

using Texture = Name<detail::deleteTexture>;
using Buffer = Name<detail::deleteBuffer>;
using Framebuffer = Name<detail::deleteFramebuffer>;
using VertexArray = Name<detail::deleteVertexArray>;
using ProgramName = Name<detail::deleteProgram>;
using ShaderName = Name<detail::deleteShader>;

VertexArray makeVertexArray();
Buffer makeUniformBuffer();

/// Colour images hold sRGB-encoded light where the scene is linear; data images (normals, masks) never do.
enum class Texels { Display, Srgb };

/// Mip levels are averaged here, not by the driver, so that every host sees the same ones.
/// An array texture that repeats along both sides.
Texture makeImages(const Layers&, Texels);
/// Faces in GL's order +x −x +y −y +z −z, all of one size.
Texture makeCubemap(const std::vector<Image>& faces, Texels);
/// RGBA32F texels in rows of `width`; read with texelFetch.
Texture makeDataTexture(int width, int height);

/// A colour target of its own; `format` is GL_RGBA8 or GL_RGBA32F. Empty where the GL cannot draw to it. Where depths
/// are asked for, what is drawn into `noting` is noted in them; they can be read while the other framebuffer is bound.
struct Target {
    Texture color, depth;
    Framebuffer framebuffer, coverage;
    int width = 0, height = 0;
    GLenum format = 0;
};
Target makeTarget(int width, int height, GLenum format, bool coverage = false);

/// Tells when the GPU has done what it was asked for so far, without waiting.
class Fence {
  public:
    Fence() = default;
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;
    ~Fence() { clear(); }

    void set();
    bool isSet() const { return sync_ != nullptr; }
    /// The GPU has come past it; then it is no longer set.
    bool passed();
    void clear();
    void forget() { sync_ = nullptr; }

  private:
    GLsync sync_ = nullptr;
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
    void bindBlock(const char* block, GLuint binding) const;
    void bindSampler(const char* sampler, GLint unit) const; ///< the program must be in use
    void forget();

  private:
    ShaderName vertex_, fragment_;
    ProgramName program_;
};

} // namespace gnomon::gl
