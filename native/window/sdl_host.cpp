/// The window by SDL2, for systems where GLFW does not do.
#include "native/crash.h"
#include "native/window/session.h"
#include "native/window/window_host.h"
#include "tracer/gl/gl.h"

#include <SDL2/SDL.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace gnomon {

namespace {

/// Moving keys and digits by position, so that they lie alike on every layout; other letters by what stands on the cap.
/// web/page/keyboard.js has the same rule.
std::string keyName(const SDL_Keysym& key) {
    constexpr std::string_view kMoves = "WASD";
    const auto letter = [](int index) { return std::string(1, char('A' + index)); };
    const bool isLetter = key.scancode >= SDL_SCANCODE_A && key.scancode <= SDL_SCANCODE_Z;
    const std::string byPosition = isLetter ? letter(key.scancode - SDL_SCANCODE_A) : std::string();
    if (isLetter && kMoves.find(byPosition) != kMoves.npos) return byPosition;
    if (key.sym >= SDLK_a && key.sym <= SDLK_z) {
        const std::string byCap = letter(key.sym - SDLK_a);
        return kMoves.find(byCap) == kMoves.npos ? byCap : std::string();
    }
    if (isLetter) return byPosition; // a layout without Latin letters
    if (key.scancode == SDL_SCANCODE_0) return "0";
    if (key.scancode >= SDL_SCANCODE_1 && key.scancode <= SDL_SCANCODE_9)
        return std::string(1, char('1' + (key.scancode - SDL_SCANCODE_1)));
    switch (key.sym) {
    case SDLK_LEFT: return "Left";
    case SDLK_RIGHT: return "Right";
    case SDLK_UP: return "Up";
    case SDLK_DOWN: return "Down";
    case SDLK_LSHIFT:
    case SDLK_RSHIFT: return "Shift";
    default: return {};
    }
}

gl::Function resolve(const char* name) { return reinterpret_cast<gl::Function>(SDL_GL_GetProcAddress(name)); }

/// Window and context, closed together with SDL's video.
struct SdlWindow {
    SDL_Window* window = nullptr;
    SDL_GLContext context = nullptr;

    bool open(glm::ivec2 size) {
        std::setlocale(LC_CTYPE, ""); // or X11 takes no title beyond ASCII
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        if (SDL_Init(SDL_INIT_VIDEO) != 0) return false;
        // Without a display SDL falls back to one that nobody sees, and that only a signal could close.
        const std::string driver = SDL_GetCurrentVideoDriver();
        if (!std::getenv("SDL_VIDEODRIVER") && (driver == "offscreen" || driver == "dummy"))
            return SDL_SetError("there is no display") == 0;
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
        SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
        window = SDL_CreateWindow("Gnomon", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, size.x, size.y,
                                  SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
        context = window ? SDL_GL_CreateContext(window) : nullptr;
        return context != nullptr;
    }
    ~SdlWindow() {
        if (context) SDL_GL_DeleteContext(context);
        if (window) SDL_DestroyWindow(window);
        SDL_Quit();
    }
};

class SdlHost {
  public:
    SdlHost(SDL_Window* window, Session& session) : window_(window), session_(session) {}

    int run(int frames) {
        while (!closing_) {
            SDL_Event event;
            while (SDL_PollEvent(&event)) handle(event);
            followSettings();
            const bool drawn = frame();
            if (frames > 0 && session_.failed()) return kNoGl;
            if (frames > 0 && session_.framesDrawn() >= frames) break;
            if (!drawn) SDL_Delay(Uint32(kIdleSeconds * 1000));
        }
        return kDone;
    }

  private:
    bool frame() {
        int width = 0, height = 0;
        SDL_GL_GetDrawableSize(window_, &width, &height);
        if (SDL_GetWindowFlags(window_) & SDL_WINDOW_MINIMIZED) width = height = 0;
        const double now = double(SDL_GetPerformanceCounter()) / double(SDL_GetPerformanceFrequency());
        if (!session_.frame(now, width, height)) return false;
        SDL_GL_SwapWindow(window_);
        if (const std::string title = session_.viewer().title(); title != title_)
            SDL_SetWindowTitle(window_, (title_ = title).c_str());
        return true;
    }

    void followSettings() {
        const Settings settings = session_.viewer().settings();
        if (vsync_ != settings.vsync) SDL_GL_SetSwapInterval(settings.vsync ? 1 : 0);
        vsync_ = settings.vsync;
    }

    void handle(const SDL_Event& event) {
        Viewer& viewer = session_.viewer();
        switch (event.type) {
        case SDL_QUIT: closing_ = true; break;
        case SDL_KEYDOWN:
            if (!event.key.repeat) keyDown(event.key.keysym);
            break;
        case SDL_KEYUP: viewer.keyUp(keyName(event.key.keysym)); break;
        case SDL_MOUSEMOTION:
            if (event.motion.state & SDL_BUTTON_LMASK) viewer.drag(event.motion.xrel, event.motion.yrel, height());
            break;
        case SDL_MOUSEWHEEL: viewer.pinch(std::pow(1.1, event.wheel.y), 0, 0, height()); break;
        case SDL_WINDOWEVENT:
            if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) viewer.releaseAllKeys();
            break;
        case SDL_DROPFILE:
            session_.open(event.drop.file);
            SDL_free(event.drop.file);
            break;
        default: break;
        }
    }

    void keyDown(const SDL_Keysym& key) {
        switch (key.sym) {
        case SDLK_ESCAPE: closing_ = true; return;
        case SDLK_F5: return session_.reload();
        case SDLK_F12: return session_.takeScreenshot();
        default: break;
        }
        const std::string name = keyName(key);
        if (!name.empty() && !(key.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI))) session_.viewer().keyDown(name);
    }

    double height() const {
        int width = 0, height = 0;
        SDL_GetWindowSize(window_, &width, &height);
        return height;
    }

    SDL_Window* window_;
    Session& session_;
    std::string title_;
    std::optional<bool> vsync_;
    bool closing_ = false;
};

} // namespace

int viewWithSdl(ViewTask task) {
    Problems problems;
    blameGl("window");
    SdlWindow window;
    if (!window.open(task.settings.size)) {
        problems.push_back({"window",
                            0,
                            {},
                            std::string("SDL opens no window with GL 3.3 (") + SDL_GetError() + ")",
                            "without a display, `gnomon render SCENE -o FILE` draws in memory"});
        return fail(kNoGl, problems);
    }
    if (!gl::load(resolve, problems)) return fail(kNoGl, problems);
    Session session(task.settings);
    if (!session.start(std::move(task.loaded), problems)) return fail(kInputWrong, problems);
    return SdlHost(window.window, session).run(task.frames);
}

} // namespace gnomon
