/// What every kind of window does around the viewer: messages, loading another scene, taking a screenshot.
#pragma once

#include "native/file/asset_folder.h"
#include "tracer/render/viewer.h"

#include <string>

namespace gnomon {

class Session {
  public:
    /// The GL context is current and loaded.
    explicit Session(const Settings&);

    /// Draws `loaded` from now on. False, with problems, where this GL cannot hold it.
    bool start(Loaded loaded, Problems&);
    /// Draws another scene file or name from now on; says so, or says what is wrong with it and goes on as before.
    void open(const std::string& sceneOrFile);
    /// Reads the scene file from disk again.
    void reload();
    /// Writes the next picture to the next free gnomon-NNN.png.
    void takeScreenshot() { screenshotWanted_ = true; }

    /// Draws into the window. False where there is nothing to draw yet.
    bool frame(double now, int width, int height);
    /// Nothing is drawn and nothing will be.
    bool failed() const { return failed_; }
    int framesDrawn() const { return framesDrawn_; }

    /// One setting, as a panel changes it.
    void set(const std::string& key, const std::string& value);
    Viewer& viewer() { return viewer_; }

    /// The last change, while it is new; else empty.
    std::string news(double now) const { return now < newsUntil_ ? news_ : std::string(); }

  private:
    void say(const std::string& line);
    void complain(const Problems&);
    void writeScreenshot(int width, int height);

    Viewer viewer_;
    std::optional<AssetFolder> assets_;
    std::string news_;
    double now_ = 0, newsUntil_ = 0;
    bool screenshotWanted_ = false, failed_ = false;
    int framesDrawn_ = 0;
};

} // namespace gnomon
