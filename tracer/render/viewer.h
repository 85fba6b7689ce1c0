/// The interactive program without a window: what the desktop and the browser host share.
///
/// A host makes a GL context current, gives events and time, and shows what report() and title() say. It owns nothing
/// else.
#pragma once

#include "tracer/plan/camera.h"
#include "tracer/render/adaptive_resolution.h"
#include "tracer/render/renderer.h"
#include "tracer/settings/settings.h"

#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace gnomon {

class Viewer {
  public:
    /// `report` gets one line for every change the user should know of.
    Viewer(const Settings&, std::function<void(const std::string&)> report);

    /// False, with problems, where this GL cannot hold the scene; the old one then stays. The settings' eye, target and
    /// fov hold for the first scene; a later one brings its own. The same scene again keeps the view where the user
    /// moved it.
    bool setScene(Scene, Problems&);
    void setImage(const std::string& name, Image);
    const Scene& scene() const { return scene_; }

    /// One setting by name, as a panel or a script changes it. `eye`, `target`, `fov` and `time` act at once.
    bool set(std::string_view key, std::string_view text, std::string_view source, Problems&);
    /// The settings as they stand. eye, target and fov are set only where they differ from the scene's, rounded to
    /// seven digits; time is the clock's.
    Settings settings() const;

    /// Key names: letters and digits as on the cap ("W", "1"), "Left", "Right", "Up", "Down", "Shift". Repeats are
    /// ignored.
    void keyDown(const std::string& key);
    void keyUp(const std::string& key);
    void releaseAllKeys(); ///< when the window loses the focus

    /// Mouse or one finger: pixels right and down, of a view `height` pixels high.
    void drag(double dx, double dy, double height);
    /// Two fingers: move by the pinch (ratio of finger distances now : before) and their common way in pixels.
    void pinch(double ratio, double dx, double dy, double height);

    void resize(int width, int height); ///< in physical pixels
    /// Steps the motion by the clock, lets compiling go on and draws into `framebuffer`. `now` in seconds.
    /// False while there is nothing to draw yet.
    bool frame(double now, unsigned framebuffer, Problems&);

    /// Lets compiling continue where no frame is drawn.
    void poll(Problems& problems) { progress_ = renderer_.poll(problems); }
    /// How far all is, as of the last frame or poll.
    Progress progress() const;
    bool sharp() const;        ///< the picture shown has all the resolution that the settings allow
    double shownScale() const; ///< its resolution over that of the canvas; 0 before the first
    double framesPerSecond() const { return fps_; } ///< over at least half a second; 0 before that, and while refining
    std::string title() const;                      ///< `Gnomon – lite – 61 FPS – depth 4, shadows hard`

    Renderer& renderer() { return renderer_; }
    View view() const;

    /// After a lost context (gl::contextLost()), in the next.
    void contextRestored() { renderer_.contextRestored(); }

  private:
    void steer(double seconds);
    void changed(const SettingRow&);
    void configure();
    void placeCamera();
    bool drawFrame(double now, unsigned framebuffer);
    void learn();
    void refine(unsigned framebuffer);
    int sharpHeight() const;
    double refined() const;
    void countFrame(double now);
    void tellDepthCut();

    Settings settings_;
    std::function<void(const std::string&)> report_;
    Scene scene_;
    bool moves_ = false; ///< changesWithTime(scene_)
    Camera camera_;
    CameraPose home_; ///< the pose as the scene gave it
    Renderer renderer_;
    Progress progress_;
    std::set<std::string> held_;
    bool hasScene_ = false;
    int depthTold_ = 0; ///< at which what the scene's depth cuts has been looked at; 0: none
    int width_ = 0, height_ = 0;
    double lastFrame_ = -1, countFrom_ = -1, fps_ = 0;
    int counted_ = 0;

    /// What was drawn last.
    struct Drawn {
        View view;
        unsigned version = 0;
        double scale = 0;
        bool band = false;    ///< the last drawing was of the full resolution, a band of it
        bool unknown = false; ///< how long it took is not known yet
    };
    AdaptiveResolution adaptive_;
    Drawn last_;
};

} // namespace gnomon
