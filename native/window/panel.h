/// The panel over the window: every row of the settings table as a control, and a line that tells the last change.
#pragma once

struct GLFWwindow;

namespace gnomon {

class Session;

class Panel {
  public:
    /// Takes its share of the window's events; callbacks set before keep being called.
    explicit Panel(GLFWwindow* window);
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    void toggle() { shown_ = !shown_; }
    /// Over what is in the window's framebuffer.
    void draw(Session&, double now);

    bool wantsKeys() const;
    bool wantsPointer() const;

  private:
    bool shown_ = false;
};

} // namespace gnomon
