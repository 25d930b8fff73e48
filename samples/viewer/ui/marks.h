// Where the widgets of the last frame are, by name: what scripts click on.
#pragma once

#include <imgui.h>

#include <map>
#include <string>

namespace aureole::viewer {

class Marks {
public:
    /// A frame begins: nothing is anywhere yet.
    void forget() { places_.clear(); }
    /// The widget that was just made. `labelled`: it has its label on the right, where a click would do nothing.
    void last(const std::string& name, bool labelled = false) {
        const ImVec2 begin = ImGui::GetItemRectMin();
        ImVec2 end = ImGui::GetItemRectMax();
        if (labelled) end.x = begin.x + ImGui::CalcItemWidth();
        places_[name] = middle(begin, end);
        if (name != wanted_) return;
        ImGui::SetScrollHereY();
        wanted_.clear();
    }
    /// Of the frame so far: all of the last one before the next begins.
    [[nodiscard]] const std::map<std::string, ImVec2>& places() const { return places_; }
    /// The next frame scrolls to this widget.
    void scroll_to(const std::string& name) { wanted_ = name; }

private:
    static ImVec2 middle(const ImVec2& a, const ImVec2& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
    std::map<std::string, ImVec2> places_;
    std::string wanted_;
};

}  // namespace aureole::viewer
