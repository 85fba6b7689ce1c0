/// A GL context for a test, and pictures and outputs of scenes drawn in it.
#pragma once

#include "native/context/context.h"
#include "tracer/image.h"
#include "tracer/render/renderer.h"

#include <memory>
#include <string>

namespace gnomon::test {

/// One context for the whole test program: making one takes longer than drawing a small picture. Aborts the program,
/// loudly, where this machine has none of that kind.
Context& offscreen(ContextKind = ContextKind::OsMesa);

/// Ends that context and makes another of its kind: what a lost one comes to.
void renewContext();

/// A scene by name with its images, ready to draw with `settings`. Fails the running test on any problem.
class Drawing {
  public:
    Drawing(const Scene&, Settings, std::span<const ShaderFile> overrides = {});
    FloatImage output(); ///< what settings.aov names
    Image picture();     ///< as a window would show it
    Renderer& renderer() { return renderer_; }
    View view; ///< the scene's camera at settings.time and settings.size

  private:
    Renderer renderer_;
};

/// The first float that differs, as text; empty where none does.
std::string difference(const FloatImage&, const FloatImage&);

/// One output of a scene.
FloatImage outputOf(const Scene&, Settings, Aov);

} // namespace gnomon::test
