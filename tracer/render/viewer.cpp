#include "tracer/render/viewer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace gnomon {

namespace {

constexpr double kLongestStep = 0.25; ///< seconds: after a longer pause motion goes on from where it was
constexpr double kLastSecond = 1e6;   ///< the clock starts again; a setting `time` ends here too

/// Seven digits: what the shader's float holds, and links stay short.
glm::dvec3 rounded(glm::dvec3 point) {
    for (int axis = 0; axis < 3; ++axis) {
        char text[32];
        std::snprintf(text, sizeof text, "%.7g", point[axis]);
        point[axis] = std::strtod(text, nullptr);
    }
    return point;
}

bool samePose(const CameraPose& a, const CameraPose& b) {
    return a.eye == b.eye && a.target == b.target && a.fov == b.fov;
}

bool isCameraKey(std::string_view key) { return key == "eye" || key == "target" || key == "fov"; }

} // namespace

Viewer::Viewer(const Settings& settings, std::function<void(const std::string&)> report)
    : settings_(settings), report_(std::move(report)) {
    home_ = camera_.pose();
}

bool Viewer::setScene(Scene scene, Problems& problems) {
    if (!renderer_.setScene(scene, problems)) return false;
    const bool again = hasScene_ && scene.file == scene_.file && scene.name == scene_.name;
    const bool userMoved = !samePose(camera_.pose(), home_);
    const CameraPose moved = camera_.pose();
    if (hasScene_ && !again) settings_.eye = settings_.target = {}, settings_.fov = {};
    scene_ = std::move(scene);
    moves_ = changesWithTime(scene_);
    hasScene_ = true;
    depthTold_ = 0;
    placeCamera();
    if (again && userMoved) camera_.setPose(moved);
    configure();
    return true;
}

/// Where the settings and the scene say; what the user steered is forgotten.
void Viewer::placeCamera() {
    camera_.setPose(scene_.camera);
    home_ = camera_.pose();
    CameraPose pose = scene_.camera;
    pose.eye = settings_.eye.value_or(pose.eye);
    pose.target = settings_.target.value_or(pose.target);
    pose.fov = settings_.fov.value_or(pose.fov);
    camera_.setPose(pose);
}

void Viewer::setImage(const std::string& name, Image image) { renderer_.setImage(name, std::move(image)); }

bool Viewer::set(std::string_view key, std::string_view text, std::string_view source, Problems& problems) {
    const Settings before = settings_;
    if (isCameraKey(key)) settings_ = settings(); // so that the other two stay where the user is
    if (!setFromText(settings_, key, text, source, problems)) {
        settings_ = before;
        return false;
    }
    const SettingRow& row = *findSetting(key);
    if (isCameraKey(key))
        placeCamera();
    else if (!(settings_ == before)) {
        if (key != "time") report_(std::string(row.key) + " " + textOf(row, settings_));
        changed(row);
    }
    return true;
}

Settings Viewer::settings() const {
    Settings now = settings_;
    const CameraPose pose = camera_.pose();
    const bool still = pose.eye == home_.eye && pose.target == home_.target;
    now.eye = still ? std::nullopt : std::optional(rounded(pose.eye));
    now.target = still ? std::nullopt : std::optional(rounded(pose.target));
    now.fov = pose.fov == home_.fov ? std::nullopt : std::optional(pose.fov);
    return now;
}

void Viewer::changed(const SettingRow& row) {
    if (row.effect != Effect::Host) configure();
}

void Viewer::configure() {
    Settings usable = settings_;
    usable.light = std::clamp(usable.light, 0, std::max(0, int(scene_.lights.size()) - 1));
    renderer_.configure(usable);
}

void Viewer::keyDown(const std::string& key) {
    if (!held_.insert(key).second) return;
    const std::string change = pressHotkey(settings_, key);
    if (change.empty()) return;
    for (const auto& row : settingsTable())
        if (row.next == key || row.previous == key) changed(row);
    report_(change);
}

void Viewer::keyUp(const std::string& key) { held_.erase(key); }

void Viewer::releaseAllKeys() { held_.clear(); }

void Viewer::drag(double dx, double dy, double height) { camera_.drag(dx, dy, height); }

void Viewer::pinch(double ratio, double dx, double dy, double height) {
    camera_.zoom(ratio);
    camera_.pan(dx, dy, height);
}

void Viewer::resize(int width, int height) {
    width_ = std::max(0, width);
    height_ = std::max(0, height);
}

/// W A S D, as fast along the diagonal as along an axis.
void Viewer::steer(double seconds) {
    const auto axis = [this](const char* more, const char* less) {
        return double(held_.count(more)) - held_.count(less);
    };
    const glm::dvec3 way{axis("W", "S"), axis("D", "A"), 0};
    if (way == glm::dvec3{0}) return;
    const double speed = settings_.speed * (held_.count("Shift") ? 0.5 : 1);
    camera_.move(glm::normalize(way) * (speed * seconds));
}

bool Viewer::frame(double now, unsigned framebuffer, Problems& problems) {
    const double seconds = lastFrame_ < 0 ? 0 : std::clamp(now - lastFrame_, 0.0, kLongestStep);
    lastFrame_ = now;
    steer(seconds);
    if (!settings_.pause) settings_.time = std::fmod(settings_.time + seconds, kLastSecond);
    progress_ = renderer_.poll(problems);
    if (!hasScene_ || width_ == 0 || height_ == 0 || !renderer_.canDraw()) return false;
    tellDepthCut();
    return drawFrame(now, framebuffer);
}

/// Once for a scene and a depth, when its programs draw.
void Viewer::tellDepthCut() {
    if (depthTold_ == settings_.depth || settings_.aov != Aov::Color || !progress_.ready()) return;
    depthTold_ = settings_.depth;
    const std::string cut = renderer_.depthCut(view());
    if (!cut.empty()) report_(cut);
}

/// On a slow GPU one picture at a time, coarser while it moves; once it is still, the full one grows aside, band by
/// band.
bool Viewer::drawFrame(double now, unsigned framebuffer) {
    if (settings_.adapt && renderer_.busy() && adaptive_.slow()) return false;
    learn();
    const View wanted = view();
    const bool still = wanted == last_.view && renderer_.version() == last_.version;
    if (settings_.adapt && still && last_.scale < settings_.scale) {
        refine(framebuffer);
        return true;
    }
    const double scale = settings_.adapt ? std::min(settings_.scale, adaptive_.scale()) : settings_.scale;
    renderer_.draw(wanted, scale, framebuffer);
    last_ = {wanted, renderer_.version(), scale, false, true};
    countFrame(now);
    return true;
}

/// What the last drawing took, once it is finished.
void Viewer::learn() {
    if (!last_.unknown || renderer_.busy()) return;
    last_.unknown = false;
    if (last_.band)
        adaptive_.tookBand(renderer_.drawSeconds());
    else if (last_.scale == adaptive_.scale())
        adaptive_.tookPicture(renderer_.drawSeconds());
}

void Viewer::refine(unsigned framebuffer) {
    if (refined() < 1) {
        renderer_.refine(last_.view, settings_.scale, adaptive_.rows(sharpHeight()));
        last_.band = last_.unknown = true;
    }
    countFrom_ = -1; // a picture that stands has no rate
    fps_ = 0;
    renderer_.show(last_.view, framebuffer);
}

int Viewer::sharpHeight() const { return scaled(last_.view, settings_.scale).height; }

/// Fraction of the picture at full resolution that is drawn.
double Viewer::refined() const { return last_.scale >= settings_.scale ? 1 : last_.band ? renderer_.refined() : 0; }

bool Viewer::sharp() const { return last_.scale > 0 && refined() >= 1; }

Progress Viewer::progress() const {
    Progress progress = progress_;
    progress.samples = last_.scale > 0 ? refined() : 0;
    return progress;
}

double Viewer::shownScale() const { return sharp() ? settings_.scale : last_.scale; }

void Viewer::countFrame(double now) {
    if (countFrom_ < 0) countFrom_ = now;
    const double span = now - countFrom_;
    if (span >= 0.5) {
        fps_ = counted_ / span;
        counted_ = 0;
        countFrom_ = now;
    }
    ++counted_;
}

std::string Viewer::title() const {
    std::string text = "Gnomon";
    if (hasScene_) text += " – " + scene_.name;
    if (fps_ > 0) text += " – " + std::to_string(std::lround(fps_)) + " FPS";
    text += " – depth " + std::to_string(settings_.depth) + ", shadows " + textOf(*findSetting("shadows"), settings_);
    return settings_.pause ? text + ", paused" : text;
}

/// Where nothing moves the picture stands while the clock goes on, and may become sharp.
View Viewer::view() const { return {camera_.pose(), moves_ ? settings_.time : 0, width_, height_}; }

} // namespace gnomon
