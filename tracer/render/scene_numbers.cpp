#include "tracer/render/scene_numbers.h"

#include "tracer/plan/scene_offsets.h"
#include "tracer/shader/program_cache.h"

namespace gnomon {

void SceneNumbers::upload(std::span<const glm::vec4> texels, bool block) {
    if (block)
        uploadBlock(texels);
    else
        uploadTexture(texels);
}

void SceneNumbers::bind() {
    if (buffer_) glBindBufferBase(GL_UNIFORM_BUFFER, kSceneBinding, buffer_.get());
    if (!texture_) return;
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
    glBindTexture(GL_TEXTURE_2D, texture_.get());
}

void SceneNumbers::uploadBlock(std::span<const glm::vec4> texels) {
    if (!buffer_) buffer_ = gl::makeUniformBuffer();
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.get());
    glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(texels.size_bytes()), texels.data(), GL_DYNAMIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kSceneBinding, buffer_.get());
}

void SceneNumbers::uploadTexture(std::span<const glm::vec4> texels) {
    const int full = int(texels.size()) / kDataWidth, rest = int(texels.size()) % kDataWidth;
    const int rows = full + (rest > 0);
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
    if (!texture_ || rows != rows_) texture_ = gl::makeDataTexture(kDataWidth, rows_ = rows);
    glBindTexture(GL_TEXTURE_2D, texture_.get());
    // An upload of no rows costs Firefox half a second.
    if (full > 0) glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kDataWidth, full, GL_RGBA, GL_FLOAT, texels.data());
    if (rest > 0)
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, full, rest, 1, GL_RGBA, GL_FLOAT, &texels[std::size_t(full) * kDataWidth]);
}

} // namespace gnomon
