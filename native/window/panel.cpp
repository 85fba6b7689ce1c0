#include "native/window/panel.h"

#include "native/window/session.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <variant>

namespace gnomon {

namespace {

/// A control for one row; answers the new value's text where the user changed it, else empty.
struct Control {
    const SettingRow& row;
    const Settings& settings;
    const char* label;

    std::string operator()(const BoolType& type) const {
        bool on = settings.*type.at;
        return ImGui::Checkbox(label, &on) ? (on ? "on" : "off") : "";
    }
    std::string operator()(const IntType& type) const {
        int number = settings.*type.at;
        return ImGui::SliderInt(label, &number, type.min, type.max, "%d", ImGuiSliderFlags_AlwaysClamp)
                   ? std::to_string(number)
                   : "";
    }
    std::string operator()(const RealType& type) const { return real(settings.*type.at, type.min, type.max); }
    std::string operator()(const OptionalRealType&) const { return typed(); }
    std::string operator()(const OptionalPointType&) const { return typed(); }
    std::string operator()(const SizeType&) const { return typed(); }
    std::string operator()(const ChoiceType& type) const {
        std::string chosen;
        if (!ImGui::BeginCombo(label, textOf(row, settings).c_str())) return chosen;
        for (std::size_t i = 0; i < type.names.size(); ++i)
            if (ImGui::Selectable(std::string(type.names[i]).c_str(), int(i) == type.get(settings)))
                chosen = type.names[i];
        ImGui::EndCombo();
        return chosen;
    }

  private:
    std::string real(double value, double min, double max) const {
        float number = float(value);
        // A range over many decades is dragged by steps, not slid along.
        const bool moved =
            max - min > 1000 * row.step && max > 1
                ? ImGui::DragFloat(label, &number, float(row.step), float(min), float(max), "%.3f",
                                   ImGuiSliderFlags_AlwaysClamp)
                : ImGui::SliderFloat(label, &number, float(min), float(max), "%.4f", ImGuiSliderFlags_AlwaysClamp);
        char text[32];
        std::snprintf(text, sizeof text, "%.6g", double(number));
        return moved ? text : "";
    }
    /// Text that counts when Enter is pressed.
    std::string typed() const {
        char text[96];
        std::snprintf(text, sizeof text, "%s", textOf(row, settings).c_str());
        return ImGui::InputText(label, text, sizeof text, ImGuiInputTextFlags_EnterReturnsTrue) ? text : "";
    }
};

void drawRow(const SettingRow& row, const Settings& settings, Session& session) {
    const std::string key(row.key);
    if (const std::string value = std::visit(Control{row, settings, key.c_str()}, row.type); !value.empty())
        session.set(key, value);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(row.help).c_str());
}

void drawTable(Session& session) {
    ImGui::SetNextWindowPos({12, 44}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({330, 0}, ImGuiCond_FirstUseEver);
    ImGui::Begin("Settings (F2 hides)");
    const Settings settings = session.viewer().settings();
    std::string_view group;
    for (const auto& row : settingsTable()) {
        if (row.group != group) {
            ImGui::Spacing();
            ImGui::TextDisabled("%s", std::string(row.group).c_str());
            ImGui::Separator();
        }
        group = row.group;
        drawRow(row, settings, session);
    }
    ImGui::End();
}

/// The panel's font has ASCII only: each longer character, as an ellipsis, becomes a dash.
std::string ascii(const std::string& text) {
    std::string plain;
    for (unsigned char c : text) {
        if (c < 0x80) plain += char(c);
        if (c >= 0xC0) plain += '-'; // the first byte of several
    }
    return plain;
}

/// The last change and the frame rate, while they are news.
void drawNews(const Session& session, const Viewer& viewer, double now) {
    const std::string news = session.news(now);
    if (news.empty()) return;
    ImGui::SetNextWindowPos({12, 12});
    ImGui::SetNextWindowBgAlpha(0.6F);
    ImGui::Begin("news", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::Text("%s - %ld FPS", ascii(news).c_str(), std::lround(viewer.framesPerSecond()));
    ImGui::End();
}

} // namespace

Panel::Panel(GLFWwindow* window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // leaves no files behind
    float scaleX = 1, scaleY = 1;
    glfwGetWindowContentScale(window, &scaleX, &scaleY);
    io.FontGlobalScale = scaleX;
    ImGui::GetStyle().ScaleAllSizes(scaleX);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Panel::~Panel() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Panel::draw(Session& session, double now) {
    if (!shown_ && session.news(now).empty()) return;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    if (shown_) drawTable(session);
    drawNews(session, session.viewer(), now);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Panel::wantsKeys() const { return shown_ && ImGui::GetIO().WantTextInput; }
bool Panel::wantsPointer() const { return shown_ && ImGui::GetIO().WantCaptureMouse; }

} // namespace gnomon
