#include "tracer/gl/objects.h"

#include <algorithm>

namespace gnomon::gl {
namespace detail {
void deleteTexture(GLuint name) { glDeleteTextures(1, &name); }
void deleteBuffer(GLuint name) { glDeleteBuffers(1, &name); }
void deleteFramebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
void deleteRenderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
void deleteVertexArray(GLuint name) { glDeleteVertexArrays(1, &name); }
void deleteProgram(GLuint name) { glDeleteProgram(name); }
void deleteShader(GLuint name) { glDeleteShader(name); }
void deleteQuery(GLuint name) { glDeleteQueries(1, &name); }
void deleteSync(GLsync sync) { glDeleteSync(sync); }
} // namespace detail

namespace {

constexpr GLenum kCompletionStatus = 0x91B1; // GL_COMPLETION_STATUS_KHR, the same in the ARB extension and in WebGL

GLint formatOf(Texels texels) { return texels == Texels::Srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8; }

Image noLargerThan(int side, Image image, Texels texels) {
    while (std::max(image.width, image.height) > side) image = halved(image, texels == Texels::Srgb);
    return image;
}

void uploadLevels(GLenum target, Image image, Texels texels) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (int level = 0;; ++level) {
        if (image.coding == Image::Coding::SharedExponent)
            glTexImage2D(target, level, GL_RGB9_E5, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_INT_5_9_9_9_REV,
                         image.rgba.data());
        else
            glTexImage2D(target, level, formatOf(texels), image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         image.rgba.data());
        if (image.width == 1 && image.height == 1) return;
        image = halved(image, texels == Texels::Srgb);
    }
}

Texture makeTexture(GLenum target, GLint minify, GLint magnify, GLint wrap) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
    return Texture(name);
}

ShaderName compile(GLenum type, const std::string& source) {
    ShaderName shader(glCreateShader(type));
    const char* text = source.c_str();
    glShaderSource(shader.get(), 1, &text, nullptr);
    glCompileShader(shader.get());
    return shader;
}

std::string shaderLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, &length, log.data());
    log.resize(std::size_t(std::max(length, 0)));
    return log;
}

} // namespace

VertexArray makeVertexArray() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return VertexArray(name);
}

Buffer makeUniformBuffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return Buffer(name);
}

Renderbuffer makeStencil(int width, int height) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_STENCIL_INDEX8, width, height);
    return Renderbuffer(name);
}

Texture makeImages(const Layers& layers, const ImageSource& imageOf, Texels texels) {
    Texture texture = makeTexture(GL_TEXTURE_2D_ARRAY, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (int level = 0; level < layers.levels(); ++level)
        glTexImage3D(GL_TEXTURE_2D_ARRAY, level, formatOf(texels), layers.width(level), layers.height(level),
                     layers.count(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (const int layer : layers.largestFirst()) // so the others are made fit in memory that it has left
        layers.forEachLevel(layer, imageOf(layer), [&](int level, const Image& image) {
            glTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, layer, image.width, image.height, 1, GL_RGBA,
                            GL_UNSIGNED_BYTE, image.rgba.data());
        });
    return texture;
}

Texture makeCubemap(const ImageSource& faceOf, Texels texels, int side) {
    Texture texture = makeTexture(GL_TEXTURE_CUBE_MAP, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
    for (int i = 0; i < 6; ++i)
        uploadLevels(GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(i), noLargerThan(side, faceOf(i), texels), texels);
    return texture;
}

Texture makePanorama(Image image, Texels texels, int side) {
    Texture texture = makeTexture(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    uploadLevels(GL_TEXTURE_2D, noLargerThan(side, std::move(image), texels), texels);
    return texture;
}

Texture makeDataTexture(int width, int height) {
    Texture texture = makeTexture(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    return texture;
}

namespace {

/// Format and type in which texels of an internal format would come from the CPU: none do.
struct Transfer {
    GLenum format, type;
};
Transfer transferOf(GLenum format) {
    switch (format) {
    case GL_RGBA32F: return {GL_RGBA, GL_FLOAT};
    case GL_RGBA32UI: return {GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    case GL_R8: return {GL_RED, GL_UNSIGNED_BYTE};
    default: return {GL_RGBA, GL_UNSIGNED_BYTE};
    }
}

Framebuffer makeFramebuffer() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return Framebuffer(name);
}

/// Of the framebuffer that is bound, which is not any more then.
bool isComplete() {
    const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return complete;
}

} // namespace

Target makeTarget(int width, int height, GLenum format) {
    const GLint filter = format == GL_RGBA8 ? GL_LINEAR : GL_NEAREST; // floats are not filterable everywhere
    const Transfer transfer = transferOf(format);
    Target target{makeTexture(GL_TEXTURE_2D, filter, filter, GL_CLAMP_TO_EDGE), {}, width, height, format};
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), width, height, 0, transfer.format, transfer.type, nullptr);
    target.framebuffer = makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.color.get(), 0);
    return isComplete() ? std::move(target) : Target{};
}

void attachSecond(const Target& target, const Texture& texture) {
    constexpr GLenum kBoth[]{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, kBoth[1], GL_TEXTURE_2D, texture.get(), 0);
    glDrawBuffers(2, kBoth);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Volume makeVolume(glm::ivec3 size, GLenum format, bool filtered) {
    const GLint filter = filtered ? GL_LINEAR : GL_NEAREST;
    Volume volume{makeTexture(GL_TEXTURE_3D, filter, filter, GL_CLAMP_TO_EDGE), makeFramebuffer(), size, format};
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    const GLenum type = format == GL_R16F ? GL_HALF_FLOAT : GL_FLOAT;
    glTexImage3D(GL_TEXTURE_3D, 0, GLint(format), size.x, size.y, size.z, 0, GL_RED, type, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, volume.framebuffer.get());
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, volume.texture.get(), 0, 0);
    return isComplete() ? std::move(volume) : Volume{};
}

void Fence::set() {
    sync_ = Sync(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
    glFlush();
}

bool Fence::passed() {
    if (glClientWaitSync(sync_.get(), GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED) return false;
    clear();
    return true;
}

Program::Program(const std::string& vertex, const std::string& fragment)
    : vertex_(compile(GL_VERTEX_SHADER, vertex)), fragment_(compile(GL_FRAGMENT_SHADER, fragment)),
      program_(glCreateProgram()) {
    glAttachShader(program_.get(), vertex_.get());
    glAttachShader(program_.get(), fragment_.get());
    glLinkProgram(program_.get());
}

bool Program::finished(bool pollable) const {
    if (!pollable) return true;
    GLint done = GL_FALSE;
    glGetProgramiv(program_.get(), kCompletionStatus, &done);
    return done != GL_FALSE;
}

bool Program::linked() const {
    GLint linked = GL_FALSE;
    glGetProgramiv(program_.get(), GL_LINK_STATUS, &linked);
    return linked != GL_FALSE;
}

std::string Program::vertexLog() const { return shaderLog(vertex_.get()); }
std::string Program::fragmentLog() const { return shaderLog(fragment_.get()); }

std::string Program::linkLog() const {
    GLint length = 0;
    glGetProgramiv(program_.get(), GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program_.get(), length, &length, log.data());
    log.resize(std::size_t(std::max(length, 0)));
    return log;
}

void Program::bindBlock(const char* block, GLuint binding) const {
    const GLuint index = glGetUniformBlockIndex(program_.get(), block);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(program_.get(), index, binding);
}

void Program::bindSampler(const char* sampler, GLint unit) const {
    const GLint location = glGetUniformLocation(program_.get(), sampler);
    if (location >= 0) glUniform1i(location, unit);
}

} // namespace gnomon::gl
