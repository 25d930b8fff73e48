// One half of the viewer: a scene drawn by one model on one backend, and what was learnt on the way.
#pragma once

#include "app/frame.h"
#include "viewer/core/curves.h"
#include "viewer/core/state.h"
#include "viewer/core/tables.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aureole::viewer {

/// What is asked of a pane.
struct PaneRequest {
    PaneSetup setup;
    app::Scene scene;  ///< Its model and size are not used.
    std::uint32_t width = 0, height = 0;
    bool linear = false;             ///< The radiance, too.
    std::optional<double> exposure;  ///< Instead of the scene's, stops included.
    bool curves = false;
    bool table = false;      ///< Read this one back:
    std::string table_name;  ///< empty, or one that there is not: the first,
    int table_slice = 0;     ///< and of it this slice.
};

struct PassFigure {
    std::string name;
    double milliseconds = 0;  ///< Of the latest time that it was recorded; 0 where the device has no clock.
    bool recorded = false;    ///< By this picture.
    std::uint64_t invocations = 0, bytes_written = 0;
};

struct PanePicture {
    app::DisplayImage display;
    app::LinearImage linear;  ///< If it was asked for.
    double exposure = 1;
    double milliseconds = 0;  ///< Of everything, by the wall clock.
    std::string backend;      ///< "vulkan on llvmpipe ..."
    std::string model;        ///< "model aureole, quality default"
    std::string plan;         ///< The planner's reasons, if it chose.
    std::vector<PassFigure> passes;
    std::vector<cpu::PipelineWork> work;  ///< Of this picture, counted by the CPU backends; else empty.
    std::uint64_t table_bytes = 0;
    double ground_m = 0;    ///< Of the land below the camera; 0 without.
    double altitude_m = 0;  ///< Of the camera.
    std::vector<std::string> table_names;
    std::optional<TableSlice> table;
    std::optional<Curves> curves;
};

class Pane {
public:
    /// `validation`: of Vulkan devices (app::BackendOptions).
    explicit Pane(bool validation = false);
    ~Pane();
    Pane(const Pane&) = delete;
    Pane& operator=(const Pane&) = delete;

    /// Keeps of the picture before what still holds: devices, tables, pipelines, the height map. `after_round` is called
    /// several times in the course of a picture by paths, and may throw to end it. Throws Error; the next picture is made anew
    /// then.
    [[nodiscard]] PanePicture render(const PaneRequest& request, const std::function<void()>& after_round = {});

private:
    struct Drawn;
    void follow(const PaneRequest& request);
    void follow_land();
    void choose_model(const PaneRequest& request, PanePicture& picture);
    [[nodiscard]] app::Frame draw(bool linear, const PaneRequest& request, const std::function<void()>& after_round);
    void collect(const app::Frame& frame, PanePicture& picture);
    void look_into(const PaneRequest& request, PanePicture& picture);

    bool validation_;
    std::unique_ptr<app::Backend> backend_;
    std::string backend_name_;
    app::Scene scene_;  ///< Renderers refer to it.
    ModelPtr model_;
    std::string model_id_;
    bool planned_air_ = true;  ///< The plan draws the air before the land.
    std::unique_ptr<app::Land> land_;
    app::SceneTerrain land_of_;
    std::unique_ptr<Drawn> display_, linear_;
    std::vector<PassFigure> passes_;
    std::uint64_t number_ = 0;
};

}  // namespace aureole::viewer
