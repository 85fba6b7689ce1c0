#include "native/window/session.h"

#include "native/exit.h"
#include "native/file/image_file.h"
#include "tracer/gl/gl.h"
#include "tracer/gl/read_top_down.h"
#include "tracer/printable.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace gnomon {

namespace {

constexpr double kNewsSeconds = 2;

std::string freeName() {
    char name[32];
    std::error_code ignored;
    for (int number = 1; number < 1000; ++number) {
        std::snprintf(name, sizeof name, "gnomon-%03d.png", number);
        if (!std::filesystem::exists(name, ignored)) return name;
    }
    return {};
}

} // namespace

Session::Session(const Settings& settings) : viewer_(settings, [this](const std::string& line) { say(line); }) {}

bool Session::start(Loaded loaded, Problems& problems) {
    if (!viewer_.setScene(std::move(loaded.scene), problems)) return false;
    for (auto& [name, image] : loaded.images) viewer_.setImage(name, std::move(image));
    note(loaded.notes);
    assets_ = std::move(loaded.assets);
    return true;
}

void Session::open(const std::string& sceneOrFile) {
    Problems problems;
    auto loaded = load(sceneOrFile, problems);
    if (!loaded || !start(std::move(*loaded), problems)) return complain(problems);
    failed_ = false;
    say(viewer_.scene().name + " loaded");
}

void Session::reload() {
    const std::string file = viewer_.scene().file;
    open(file);
}

bool Session::frame(double now, int width, int height) {
    now_ = now;
    viewer_.resize(width, height);
    Problems problems;
    const bool drawn = viewer_.frame(now, 0, problems);
    complain(problems);
    failed_ = failed_ || (!problems.empty() && !viewer_.renderer().canDraw());
    if (!drawn) return false;
    ++framesDrawn_;
    if (std::exchange(screenshotWanted_, false)) writeScreenshot(width, height);
    return true;
}

void Session::set(const std::string& key, const std::string& value) {
    Problems problems;
    viewer_.set(key, value, "panel", problems);
    complain(problems);
}

void Session::say(const std::string& line) {
    std::printf("%s\n", printable(line).c_str());
    std::fflush(stdout);
    news_ = line;
    newsUntil_ = now_ + kNewsSeconds;
}

void Session::complain(const Problems& problems) {
    if (problems.empty()) return;
    fail(kInputWrong, problems);
    news_ = toString(problems.front());
    newsUntil_ = now_ + 4 * kNewsSeconds; // longer to read, and not asked for
}

void Session::writeScreenshot(int width, int height) {
    const std::string name = freeName();
    Problems problems;
    if (name.empty())
        problems.push_back({"gnomon-NNN.png", 0, {}, "all 999 names are taken", "move some screenshots away"});
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    if (!name.empty() && writeImage(name, gl::readTopDown(width, height), problems)) say("screenshot " + name);
    complain(problems);
}

} // namespace gnomon
