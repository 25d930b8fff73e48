#include "viewer/ui/window.h"

#include <aureole/rhi/error.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <cctype>
#include <utility>

namespace aureole::viewer {
namespace {

std::string glfw_reason() {
    const char* text = nullptr;
    return glfwGetError(&text) != GLFW_NO_ERROR && text ? text : "no reason given";
}

const std::map<std::string, int>& named_keys() {
    static const std::map<std::string, int> keys{
        {"space", GLFW_KEY_SPACE}, {"enter", GLFW_KEY_ENTER},         {"escape", GLFW_KEY_ESCAPE},
        {"tab", GLFW_KEY_TAB},     {"backspace", GLFW_KEY_BACKSPACE}, {"delete", GLFW_KEY_DELETE},
        {"left", GLFW_KEY_LEFT},   {"right", GLFW_KEY_RIGHT},         {"up", GLFW_KEY_UP},
        {"down", GLFW_KEY_DOWN},   {"shift", GLFW_KEY_LEFT_SHIFT},    {"ctrl", GLFW_KEY_LEFT_CONTROL}};
    return keys;
}

}  // namespace

Window::Window(std::uint32_t width, std::uint32_t height, const std::string& title) {
    if (!glfwInit()) throw Error(ErrorCode::unsupported, "no window can be opened here: " + glfw_reason());
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    window_ = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title.c_str(), nullptr, nullptr);
    if (!window_) {
        const std::string reason = glfw_reason();
        glfwTerminate();
        throw Error(ErrorCode::unsupported, "no window can be opened here: " + reason);
    }
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // nothing is written that nobody asked for
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForVulkan(window_, true);
}

Window::~Window() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

bool Window::wants_to_close() const { return glfwWindowShouldClose(window_) != 0; }

VkExtent2D Window::size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

void Window::resize(int width, int height) {
    if (width < 200 || height < 100 || width > 16384 || height > 16384)
        throw Error(ErrorCode::invalid_argument, "size", std::to_string(width) + "x" + std::to_string(height),
                    "200x100 to 16384x16384");
    glfwSetWindowSize(window_, width, height);
}

void Window::poll(double seconds) {
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

void ScriptedInput::key(const std::string& name, bool down) {
    int key = 0;
    if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])))
        key = std::toupper(static_cast<unsigned char>(name[0]));  // GLFW's keys are ASCII's capitals
    else if (const auto found = named_keys().find(name); found != named_keys().end())
        key = found->second;
    else
        throw Error(ErrorCode::invalid_argument, "key", name, "a letter, a digit, or the name of a key (viewer.md)");
    keys_[key] = down;
}

void ScriptedInput::apply() {
    ImGuiIO& io = ImGui::GetIO();
    if (mouse_) io.MousePos = {mouse_->x, mouse_->y};
    for (const auto& [index, down] : buttons_) io.MouseDown[index] = down;
    for (const auto& [key, down] : keys_) {
        io.KeysDown[key] = down;
        if (key == GLFW_KEY_LEFT_SHIFT) io.KeyShift = down;
        if (key == GLFW_KEY_LEFT_CONTROL) io.KeyCtrl = down;
    }
    io.MouseWheel += std::exchange(wheel_, 0.0F);
    if (!text_.empty()) io.AddInputCharactersUTF8(std::exchange(text_, {}).c_str());
}

}  // namespace aureole::viewer
