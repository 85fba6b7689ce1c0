/// Draws a scene with the one shader library: puts the passes in order and keeps what they draw with, GL objects that
/// no caller sees.
///
/// The order of use: setScene, setImage for what imagesOf(scene) names (a flat grey stands in until then), configure
/// with the settings, then each frame poll() and draw(). All calls need the context the renderer was made in to be
/// current; where that is lost, all that is needed is contextRestored() in the next.
#pragma once

#include "tracer/image.h"
#include "tracer/problem.h"
#include "tracer/render/progress.h"
#include "tracer/render/view.h"
#include "tracer/scene/scene.h"
#include "tracer/settings/settings.h"
#include "tracer/shader/library.h"
#include "tracer/shader/program_stats.h"

#include <memory>
#include <span>
#include <string>

namespace gnomon {

class Renderer {
  public:
    /// `overrides` take the place of shader files of the same name, as for buildShader(); their names and texts must
    /// outlive the renderer.
    explicit Renderer(std::span<const ShaderFile> overrides = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Takes a checked scene. False, with problems, where this GL cannot hold it; the old scene then stays.
    bool setScene(const Scene&, Problems&);
    void setImage(const std::string& name, Image);
    /// Images leave memory when they are on the GPU. Another scene or context has to be given them again.
    void useImagesOnce();

    /// Other overrides from here on, as in the constructor. What draws goes on until the new program is ready.
    void replaceShaders(std::span<const ShaderFile> overrides);

    /// Chooses the programs for the settings and starts to compile them where they are new; the old ones draw on
    /// meanwhile.
    void configure(const Settings&);

    /// Lets compiling continue; problems of a failed compile (shader file, line, the driver's words) are added once.
    Progress poll(Problems&);
    /// poll() until the programs are ready or one has failed.
    bool finish(Problems&);
    bool canDraw() const;

    /// Draws the picture at `scale` of its resolution and shows it in the framebuffer object `framebuffer` (0 = the
    /// window), stretched over all of it.
    void draw(const View&, double scale, unsigned framebuffer);
    /// The same into a framebuffer of its own, which stays bound: nothing is shown.
    void drawAside(const View&, double scale);
    /// Draws `rows` more of the picture at `scale` aside; nothing is shown. It begins anew where view or version() have
    /// changed.
    void refine(const View&, double scale, int rows);
    /// Fraction of that picture that is drawn.
    double refined() const;
    /// Shows again what draw() drew last, and over it the rows that refine() has drawn.
    void show(const View&, unsigned framebuffer);

    /// The GPU has not finished what draw() or refine() asked for last.
    bool busy();
    /// Seconds from asking for the last finished drawing to its last pixel, as busy() saw it.
    double drawSeconds() const;
    /// Counts what changes pictures beside the view: settings, images, programs.
    unsigned version() const;
    /// Draws the output that the settings name into float32, neither clamped nor encoded, and reads it back.
    FloatImage readOutput(const View&, Problems&);
    /// Draws what a window would show, and reads it back.
    Image readPicture(const View&, Problems&);
    /// One line where the largest depth leaves colours more than 1 % off, the mean over the picture: by how much, and
    /// which depth would do. Else empty.
    std::string depthCut(const View&);

    ProgramStats stats() const;        ///< of the programs that trace
    const std::string& source() const; ///< of the program that traces now

    /// Builds all anew in a new context.
    void contextRestored();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon
