#include "viewer/core/pane.h"

#include "app/plan_needs.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace aureole::viewer {
namespace {

/// What a renderer must be made anew for: all of a scene but what FrameRenderer follows.
app::Scene shape_of(app::Scene scene) {
    scene.title.clear();
    scene.atmosphere = {};
    scene.suns.assign(scene.suns.size(), {});
    const Projection projection = scene.camera.projection;
    scene.camera = {};
    scene.camera.projection = projection;
    if (scene.exposure.factor) scene.exposure.factor = 1;
    scene.exposure.stops = 0;
    if (scene.terrain) {
        scene.terrain->camera_east_m = scene.terrain->camera_north_m = 0;
        scene.terrain->range_m = 1;
        scene.terrain->albedo.reset();
        scene.terrain->height_map_key.clear();
    }
    return scene;
}

/// What the land must be read anew for.
app::SceneTerrain map_of(const app::SceneTerrain& terrain) {
    app::SceneTerrain map;
    map.height_map = terrain.height_map;
    map.options = terrain.options;
    map.vertical_exaggeration = terrain.vertical_exaggeration;
    return map;
}

}  // namespace

/// A renderer, and what it was made for.
struct Pane::Drawn {
    app::Scene shape;
    std::string model_id;
    bool linear = false;
    std::unique_ptr<app::FrameRenderer> renderer;
};

Pane::Pane(bool validation) : validation_(validation) {}

// Device objects before the device.
Pane::~Pane() {
    display_.reset();
    linear_.reset();
}

/// The scene and all that belongs to it, in the places that the renderers refer to.
void Pane::follow(const PaneRequest& request) {
    if (!backend_ || backend_name_ != request.setup.backend) {
        display_.reset();
        linear_.reset();
        backend_.reset();
        app::BackendOptions options{.name = request.setup.backend};
        options.count_work = options.name.starts_with("cpu");
        options.validation = validation_ && options.name == "vulkan";
        backend_ = app::open_backend(options);
        backend_name_ = request.setup.backend;
        passes_.clear();
    }
    scene_ = request.scene;
    scene_.width = request.width;
    scene_.height = request.height;
    if (request.exposure) scene_.exposure = {request.exposure, 0};
    follow_land();
}

void Pane::follow_land() {
    const bool same = scene_.terrain ? land_ && land_of_ == map_of(*scene_.terrain) : !land_;
    if (!same) {
        display_.reset();
        linear_.reset();
        land_.reset();
    }
    if (!scene_.terrain) return;
    if (land_) return land_->follow(scene_);
    land_ = std::make_unique<app::Land>(scene_, scene_.terrain->height_map);
    land_of_ = map_of(*scene_.terrain);
}

void Pane::choose_model(const PaneRequest& request, PanePicture& picture) {
    scene_.model = request.setup.model;
    model_.reset();
    planned_air_ = true;
    if (!request.setup.planned) {
        model_id_ = picture.model = scene_.model.describe();
        return;
    }
    PlanRequirements needs = app::plan_needs(scene_);
    needs.altitude_m = {picture.altitude_m, picture.altitude_m};
    needs.light = scene_.terrain.has_value();
    needs.tolerance = request.setup.tolerance;
    const Plan plan = aureole::plan(needs);
    scene_.model = {plan.setting.model, plan.setting.quality, plan.setting.spectral};
    scene_.atmosphere = plan.air;
    model_ = plan.model;
    planned_air_ = plan.view.aerial_perspective;
    model_id_ = plan.setting.id() + (planned_air_ ? "" : ", no air before the land");
    picture.model = "plan: " + plan.setting.id();
    picture.plan = plan.text();
}

/// The picture proper, by a renderer of the picture before if that will do.
app::Frame Pane::draw(bool linear, const PaneRequest& request, const std::function<void()>& after_round) {
    std::unique_ptr<Drawn>& drawn = linear ? linear_ : display_;
    const app::Scene shape = shape_of(scene_);
    if (!drawn || drawn->shape != shape || drawn->model_id != model_id_) {
        drawn.reset();
        auto made = std::make_unique<Drawn>(Drawn{shape, model_id_, linear, nullptr});
        app::FrameOptions options{.width = request.width, .height = request.height, .linear = linear};
        options.model = model_;
        options.aerial_perspective = planned_air_;
        options.warm_up = false;
        made->renderer = std::make_unique<app::FrameRenderer>(*backend_, scene_, land_.get(), options);
        drawn = std::move(made);
        if (!linear) passes_.clear();
    }
    // Numbers tell paths of one picture from those of another; else all pictures are alike, to the dither.
    const std::uint64_t number = drawn->renderer->rounds() > 1 ? number_++ : 0;
    return drawn->renderer->render(app::suns_of(scene_), number, after_round);
}

void Pane::collect(const app::Frame& frame, PanePicture& picture) {
    for (const PassReport& report : frame.passes) {
        auto known = std::ranges::find(passes_, report.name, &PassFigure::name);
        if (known == passes_.end()) known = passes_.insert(passes_.end(), PassFigure{std::string(report.name)});
        const auto time = std::ranges::find(frame.times, report.name, &app::PassTime::name);
        known->recorded = time != frame.times.end() || report.recorded;
        if (time != frame.times.end()) known->milliseconds = time->milliseconds;
        if (report.invocations > 0) known->invocations = report.invocations;
        if (report.bytes_written > 0) known->bytes_written = report.bytes_written;
    }
    picture.passes = passes_;
    if (backend_->cpu()) picture.work = backend_->cpu()->work();
}

/// Tables and curves of what has been drawn.
void Pane::look_into(const PaneRequest& request, PanePicture& picture) {
    app::FrameRenderer& renderer = *display_->renderer;
    picture.table_bytes = renderer.air().table_bytes() + renderer.view().table_bytes();
    const std::vector<TableInfo> tables = tables_of(renderer.air(), renderer.view());
    for (const TableInfo& table : tables) picture.table_names.push_back(table.name);
    if (request.table && !tables.empty()) {
        auto wanted = std::ranges::find(tables, request.table_name, &TableInfo::name);
        picture.table = read_slice(*backend_, wanted == tables.end() ? tables.front() : *wanted, request.table_slice);
    }
    if (request.curves) picture.curves = curves_of(*backend_, renderer.metering_air(), picture.altitude_m);
}

PanePicture Pane::render(const PaneRequest& request, const std::function<void()>& after_round) {
    const auto begin = std::chrono::steady_clock::now();
    PanePicture picture;
    try {
        follow(request);
        picture.altitude_m = land_ ? land_->camera_altitude_m() : scene_.camera.altitude_m;
        picture.ground_m = land_ ? land_->ground_m() : 0;
        choose_model(request, picture);
        picture.backend = backend_->describe();
        if (backend_->cpu()) backend_->cpu()->reset_work();
        app::Frame frame = draw(false, request, after_round);
        collect(frame, picture);
        look_into(request, picture);
        picture.exposure = frame.exposure;
        picture.display = std::move(frame.display);
        if (request.linear) picture.linear = draw(true, request, after_round).linear;
    } catch (...) {
        display_.reset();
        linear_.reset();
        throw;
    }
    picture.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return picture;
}

}  // namespace aureole::viewer
