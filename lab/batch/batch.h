/// A shader pass over many given numbers: what goes in and comes out is one vec4 of float32 each a pixel.
#pragma once

#include "tracer/problem.h"
#include "tracer/scene/scene.h"
#include "tracer/settings/settings.h"
#include "tracer/shader/library.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace gnomon {

struct BatchPass {
    const char* file = "";           ///< its entry point, as `pass/intersect.frag`
    std::vector<const char*> inputs; ///< samplers
    int outputs = 1;
    bool distances = false; ///< SceneFeatures::distances, whatever the settings say
    Settings settings{};    ///< what the pass is built for, its time, and the numbers of its shadow model and march
    float pixelAngle = 0;   ///< of the cones that marches take rays for
};

class Batch {
  public:
    static constexpr std::size_t kMost = 512 * 512; ///< pixels at a time

    /// The pass for a scene's shapes in the current context; null, with problems, where it does not compile or the
    /// context cannot draw float32. `overrides` as for buildShader().
    /// Scene data lie in a uniform block unless the settings say otherwise.
    static std::unique_ptr<Batch> make(const BatchPass&, const Scene&, Problems&,
                                       std::span<const ShaderFile> overrides);
    ~Batch();

    /// Goes on with another scene. Compiles only where its source is another one: scenes that differ in values share
    /// theirs. False, with problems, where that fails.
    bool setScene(const Scene&, Problems&);

    /// One vector an input, all of the same size of at most kMost.
    void upload(std::span<const std::vector<glm::vec4>> inputs);
    /// Answers what was uploaded last; frame.repeats tells the pass how often. `wait`s once for it all to be done.
    void draw(int repeats = 1);
    void wait();
    /// As many as were uploaded.
    std::vector<glm::vec4> read(int output);

  private:
    struct Impl;
    explicit Batch(std::unique_ptr<Impl>);
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon
