/// A window and its GL 3.3 core context by GLFW.
#pragma once

#include "tracer/gl/gl.h"
#include "tracer/problem.h"

#include <memory>
#include <string>

struct GLFWwindow;

namespace gnomon {

class GlfwWindow {
  public:
    /// Null, with a problem, where there is no display or no such GL.
    static std::unique_ptr<GlfwWindow> open(const std::string& title, int width, int height, bool visible, Problems&);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    GLFWwindow* handle() const { return handle_; }
    static gl::Resolver resolver();

  private:
    explicit GlfwWindow(GLFWwindow* handle) : handle_(handle) {}
    GLFWwindow* handle_;
};

} // namespace gnomon
