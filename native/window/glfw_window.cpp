#include "native/window/glfw_window.h"

#include "native/context/context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace gnomon {

namespace {

/// GLFW's own words for what just failed.
std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? std::string(" (") + text + ")" : std::string();
}

class WindowContext : public Context {
  public:
    explicit WindowContext(std::unique_ptr<GlfwWindow> window) : window_(std::move(window)) {}
    bool makeCurrent() override {
        glfwMakeContextCurrent(window_->handle());
        return glfwGetCurrentContext() == window_->handle();
    }
    gl::Resolver resolver() const override { return GlfwWindow::resolver(); }

  private:
    std::unique_ptr<GlfwWindow> window_;
};

} // namespace

std::unique_ptr<GlfwWindow> GlfwWindow::open(const std::string& title, int width, int height, bool visible,
                                             Problems& problems) {
    const auto refuse = [&](const std::string& what) {
        problems.push_back(
            {"window", 0, {}, what + lastError(), "without a display, `gnomon render SCENE -o FILE` draws in memory"});
        return nullptr;
    };
    if (!glfwInit()) return refuse("no display can be opened");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, visible);
    GLFWwindow* handle = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (handle) return std::unique_ptr<GlfwWindow>(new GlfwWindow(handle));
    refuse("no window with GL 3.3 can be opened");
    glfwTerminate();
    return nullptr;
}

GlfwWindow::~GlfwWindow() {
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

gl::Resolver GlfwWindow::resolver() { return glfwGetProcAddress; }

std::unique_ptr<Context> makeWindowContext(Problems& problems) {
    auto window = GlfwWindow::open("gnomon", 16, 16, false, problems);
    return window ? std::make_unique<WindowContext>(std::move(window)) : nullptr;
}

} // namespace gnomon
