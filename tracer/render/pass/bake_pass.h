/// Bakes the signed distance of a height patch into a texture of three dimensions, some slices at a time.
///
/// Sample i of n lies at i / (n - 1) of the box along each axis, so that trilinear interpolation covers all of it. What
/// a texel holds is in the world's units, positive above the surface and negative below.
///
/// The order of use: begin, then step until done() is 1, or until it fails.
#pragma once

#include "tracer/gl/objects.h"
#include "tracer/scene/height_patch.h"
#include "tracer/shader/program_cache.h"

#include <array>
#include <memory>

namespace gnomon {

/// How the field is found: shaders/pass/bake_*.frag, in this order.
enum class BakeMethod { Exact, AdaMax, Adam, Gradient, Brute, Lipschitz };

struct FieldBox {
    glm::dvec3 low{0}, high{1};
};

struct FieldBake {
    Heights heights{};
    glm::dvec3 center{0}, size{1}; ///< of the patch: tracer/scene/height_patch.h
    FieldBox box;                  ///< over the patch's rectangle, where a point has a side
    int resolution = 32;           ///< samples along each side
    GLenum format = GL_R32F;       ///< or GL_R16F
    BakeMethod method = BakeMethod::Exact;
    // What the third source's methods go by.
    int iterations = 25, starts = 10, samples = 32; ///< samples along a side: of brute force
    double rate = 0.05, beta1 = 0.9, beta2 = 0.99;
    double lipschitz = 0; ///< of the height above the surface; 0: what the net tells
};

class BakePass {
  public:
    /// A field from here on. False, with a problem, where this GL cannot draw it.
    bool begin(const FieldBake&, const CodegenTarget&, Problems&);
    /// Draws on by so many slices, into the part of the volume that begins at its texel `at`; compiles first. False,
    /// with problems, where that fails.
    bool step(ProgramCache&, const gl::Volume&, glm::ivec3 at, int slices, Problems&);

    /// Fraction of the slices that are drawn.
    double done() const { return double(slices_) / bake_.resolution; }

  private:
    enum class Part { Cells, Bricks, Slices }; ///< the first two of BakeMethod::Exact only

    bool exact() const { return bake_.method == BakeMethod::Exact; }
    bool makeTargets(Problems&);
    CompileState poll(ProgramCache&, const gl::Volume&, Problems&);
    void bind(glm::ivec3 at) const;
    void drawWith(const CachedProgram&, Part, const gl::Volume&, glm::ivec3 at, int slice) const;

    FieldBake bake_;
    CodegenTarget target_;
    std::array<std::shared_ptr<CachedProgram>, 3> programs_; ///< by Part
    gl::Target cells_, bricks_;
    gl::Texture slopes_; ///< beside the cells' heights
    gl::Buffer block_;
    gl::VertexArray vertexArray_;
    int slices_ = 0;
};

} // namespace gnomon
