/// Draws a scene with the one shader: owns every GL object that takes, none of which the caller sees.
///
/// The order of use: setScene, setImage for what imagesOf(scene) names (a flat grey stands in until then), configure
/// with the settings, then each frame poll() and draw(). All calls need the context the renderer was made in to be
/// current.
#pragma once

#include "tracer/image.h"
#include "tracer/problem.h"
#include "tracer/plan/camera.h"
#include "tracer/settings/settings.h"
#include "tracer/scene/scene.h"
#include "tracer/shader/library.h"

#include <memory>
#include <span>
#include <string>

namespace gnomon {

/// All that changes from frame to frame.
struct View {
    CameraPose camera;
    double time = 0;
    int width = 0, height = 0;

    bool operator==(const View&) const = default;
};

/// How far the program for the wanted scene and settings has come.
enum class ProgramState { None, Compiling, Ready, Failed };

/// What a program cost and is.
struct ProgramStats {
    std::size_t sourceBytes = 0;
    double buildMs = 0;   ///< specialising the source
    double compileMs = 0; ///< from handing it to GL to the first finished draw
};

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
    void setImage(const std::string& name, const Image&);

    /// Other overrides from here on, as in the constructor. What draws goes on until the new program is ready.
    void replaceShaders(std::span<const ShaderFile> overrides);

    /// Chooses the program for the settings and starts to compile it where it is new; the old one draws on meanwhile.
    void configure(const Settings&);

    /// Lets compiling go on; problems of a failed compile (shader file, line, the driver's words) are added once.
    ProgramState poll(Problems&);
    /// poll() until the program is ready or has failed.
    bool finish(Problems&);
    bool canDraw() const;

    /// Draws the picture at `scale` of its resolution and stretches it over the framebuffer object `framebuffer` (0 =
    /// the window).
    void draw(const View&, double scale, unsigned framebuffer);
    /// Draws rows `from` … `to` − 1 (0 = the lowest) of the picture at `scale`, aside: nothing is shown.
    void drawRows(const View&, double scale, int from, int to);
    /// Shows again what draw() drew last, and over its lowest `rows` what drawRows() has drawn.
    void show(const View&, int rows, unsigned framebuffer);

    /// The GPU has not finished what draw() asked for last.
    bool busy();
    /// Seconds from asking for the last finished draw() to its last pixel, as busy() saw it.
    double drawSeconds() const;
    /// Counts what changes pictures beside the view: settings, images, programs.
    unsigned version() const;
    /// Draws the output the settings name into float32, unclamped and not encoded, and reads it back.
    FloatImage readOutput(const View&, Problems&);
    /// Draws what a window would show, and reads it back.
    Image readPicture(const View&, Problems&);

    ProgramStats stats() const;
    const std::string& source() const; ///< of the program that draws now

    /// The GL objects are gone with a lost context: forget them without touching GL, then build all anew in the new
    /// one.
    void contextLost();
    void contextRestored();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon
