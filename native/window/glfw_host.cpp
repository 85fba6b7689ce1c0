/// The window by GLFW, with the panel.
#include "native/crash.h"
#include "native/window/glfw_window.h"
#include "native/window/panel.h"
#include "native/window/session.h"
#include "native/window/window_host.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace gnomon {

namespace {

/// By what stands on the cap; moving keys by position, so that they lie alike on every layout, and nowhere else.
/// web/page/keyboard.js has the same rule.
std::string letterName(int key, int scancode) {
    constexpr std::string_view kMoves = "WASD";
    const std::string byPosition(1, char(key));
    if (kMoves.find(byPosition) != kMoves.npos) return byPosition;
    const char* cap = glfwGetKeyName(key, scancode);
    if (!cap || cap[1] != 0 || cap[0] < 'a' || cap[0] > 'z') return byPosition; // a layout without Latin letters
    const std::string byCap(1, char(cap[0] - 'a' + 'A'));
    return kMoves.find(byCap) == kMoves.npos ? byCap : std::string();
}

/// The name the settings table and the viewer know a key by; empty for others.
std::string keyName(int key, int scancode) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return letterName(key, scancode);
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return std::string(1, char(key));
    switch (key) {
    case GLFW_KEY_LEFT: return "Left";
    case GLFW_KEY_RIGHT: return "Right";
    case GLFW_KEY_UP: return "Up";
    case GLFW_KEY_DOWN: return "Down";
    case GLFW_KEY_LEFT_SHIFT:
    case GLFW_KEY_RIGHT_SHIFT: return "Shift";
    default: return {};
    }
}

class GlfwHost {
  public:
    GlfwHost(GLFWwindow* window, Session& session) : window_(window), session_(session) {
        glfwSetWindowUserPointer(window, this);
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
            of(w).key(key, scancode, action, mods);
        });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
            if (button == GLFW_MOUSE_BUTTON_LEFT) of(w).press(action == GLFW_PRESS);
        });
        glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { of(w).pointer(x, y); });
        glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y) { of(w).scroll(y); });
        glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
            if (!focused) of(w).loseFocus();
        });
        glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** files) {
            if (count > 0) of(w).session_.open(files[0]);
        });
        panel_.emplace(window); // after the callbacks above, which it keeps and calls
    }

    int run(int frames) {
        while (!glfwWindowShouldClose(window_)) {
            glfwPollEvents();
            followSettings();
            const bool drawn = frame();
            if (frames > 0 && session_.failed()) return kNoGl;
            if (frames > 0 && session_.framesDrawn() >= frames) break;
            if (!drawn) glfwWaitEventsTimeout(kIdleSeconds);
        }
        return kDone;
    }

  private:
    static GlfwHost& of(GLFWwindow* window) { return *static_cast<GlfwHost*>(glfwGetWindowUserPointer(window)); }

    bool frame() {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        const double now = glfwGetTime();
        if (!session_.frame(now, width, height)) return false;
        panel_->draw(session_, now);
        glfwSwapBuffers(window_);
        if (const std::string title = session_.viewer().title(); title != title_)
            glfwSetWindowTitle(window_, (title_ = title).c_str());
        return true;
    }

    /// What the host itself has to do for a setting: v-sync, and the window's size.
    void followSettings() {
        const Settings settings = session_.viewer().settings();
        if (vsync_ != settings.vsync) glfwSwapInterval(settings.vsync ? 1 : 0);
        vsync_ = settings.vsync;
        if (size_ && *size_ != settings.size) resizeTo(settings.size);
        size_ = settings.size;
    }

    /// `size` counts pixels, GLFW the screen's units.
    void resizeTo(glm::ivec2 size) {
        int width = 1, height = 1, pixelsX = 1, pixelsY = 1;
        glfwGetWindowSize(window_, &width, &height);
        glfwGetFramebufferSize(window_, &pixelsX, &pixelsY);
        glfwSetWindowSize(window_, std::max(1, size.x * width / std::max(1, pixelsX)),
                          std::max(1, size.y * height / std::max(1, pixelsY)));
    }

    void key(int key, int scancode, int action, int mods) {
        if (action == GLFW_RELEASE) return session_.viewer().keyUp(keyName(key, scancode));
        if (action != GLFW_PRESS || panel_->wantsKeys()) return;
        switch (key) {
        case GLFW_KEY_ESCAPE: return glfwSetWindowShouldClose(window_, GLFW_TRUE);
        case GLFW_KEY_F2: return panel_->toggle();
        case GLFW_KEY_F5: return session_.reload();
        case GLFW_KEY_F12: return session_.takeScreenshot();
        default: break;
        }
        const std::string name = keyName(key, scancode);
        if (!name.empty() && !(mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)))
            session_.viewer().keyDown(name);
    }

    void press(bool down) { dragging_ = down && !panel_->wantsPointer(); }

    /// Measured from event to event: asking GLFW for the pointer gives the place it has by now, after a slow picture
    /// far on.
    void pointer(double x, double y) {
        const glm::dvec2 now{x, y}, way = now - pointer_.value_or(now);
        if (dragging_) session_.viewer().drag(way.x, way.y, height());
        pointer_ = now;
    }

    void scroll(double clicks) {
        if (!panel_->wantsPointer()) session_.viewer().pinch(std::pow(1.1, clicks), 0, 0, height());
    }

    void loseFocus() {
        session_.viewer().releaseAllKeys();
        dragging_ = false;
    }

    double height() const {
        int width = 0, height = 0;
        glfwGetWindowSize(window_, &width, &height);
        return height;
    }

    GLFWwindow* window_;
    Session& session_;
    std::optional<Panel> panel_;
    std::string title_;
    std::optional<bool> vsync_;
    std::optional<glm::ivec2> size_;
    std::optional<glm::dvec2> pointer_;
    bool dragging_ = false;
};

} // namespace

int viewWithGlfw(ViewTask task) {
    Problems problems;
    blameGl("window");
    const auto window = GlfwWindow::open("Gnomon", task.settings.size.x, task.settings.size.y, true, problems);
    if (!window) return fail(kNoGl, problems);
    glfwMakeContextCurrent(window->handle());
    if (!gl::load(GlfwWindow::resolver(), problems)) return fail(kNoGl, problems);
    Session session(task.settings);
    if (!session.start(std::move(task.loaded), problems)) return fail(kInputWrong, problems);
    return GlfwHost(window->handle(), session).run(task.frames);
}

} // namespace gnomon
