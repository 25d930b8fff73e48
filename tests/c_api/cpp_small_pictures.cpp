// The small pictures by the C++ API.
#include <aureole/cpu/cpu_device.h>
#include <aureole/models/aureole.h>
#include <aureole/models/bruneton.h>
#include <aureole/models/fog.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/reference.h>
#include <aureole/models/single.h>
#include <aureole/models/single_lut.h>
#include <aureole/planned_sky.h>
#include <aureole/presets.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

#include "c_api/small_pictures.h"

using namespace aureole;

namespace {

ModelPtr model(int which) {
    using namespace models;
    switch (which) {
        case SMALL_FOG: {
            FogSettings s = FogSettings::by_name("default");
            s.mode = FogSettings::Mode::one_colour;
            s.colour.y = 0.2;
            s.density_per_m = 2e-5;
            return fog(s);
        }
        case SMALL_SINGLE: {
            SingleSettings s = SingleSettings::by_name("default");
            s.view_steps = 5;
            s.dome.size = {12, 16, 1};
            s.dome.phase = Dome::Phase::in_table;
            return single(s);
        }
        case SMALL_SINGLE_LUT: {
            SingleLutSettings s = SingleLutSettings::by_name("default");
            s.steps = Steps::midpoints;
            s.view_steps = 20;
            s.table.width = 32;
            return single_lut(s);
        }
        case SMALL_HILLAIRE: {
            HillaireSettings s = HillaireSettings::by_name("default");
            s.fast_sky = false;
            s.march_steps = 12;
            s.multi_scatter.height = 16;
            return hillaire(s);
        }
        case SMALL_AUREOLE: {
            QualitySettings s = QualitySettings::by_name("low");
            s.sky_view.width = 24;
            s.sky_view_nodes = 4;
            s.angular_order = 2;
            s.ground_light = false;
            s.table_format = rhi::Format::rgba32_float;
            return models::aureole(s);
        }
        case SMALL_BRUNETON: {
            BrunetonSettings s = BrunetonSettings::by_name("low");
            s.altitude_nodes = 4;
            s.view_nodes = 16;
            s.sun_nodes = 8;
            s.nu_nodes = 4;
            s.orders = 2;
            s.combined = false;
            s.lowest_sun_deg = 97.5;
            return bruneton(s);
        }
        default: {
            ReferenceSettings s = ReferenceSettings::by_name("low");
            s.paths_per_frame = 2;
            s.seed = 5;
            s.light_paths = 0;
            s.max_order = 2;
            return reference(s);
        }
    }
}

/// The rig of small_rig.h.
struct Rig {
    Rig() {
        targets.extent = {SMALL_WIDTH, SMALL_HEIGHT, 1};
        targets.target = device.create_texture({"target", rhi::Dimension::d2, rhi::Format::rgba32_float, targets.extent,
                                                rhi::Usage::storage | rhi::Usage::copy_source});
        staging = device.create_buffer({"staging", sizeof(float) * SMALL_FLOATS, rhi::Usage::read_back});
    }
    template <class Record>
    void show(float* out, const Record& record) {
        rhi::CommandList& commands = cpu->queue().begin();
        const auto move = [&](rhi::State before, rhi::State after) {
            const rhi::TextureBarrier barrier{targets.target, before, after};
            commands.barrier({&barrier, 1}, {});
        };
        move(rhi::State::undefined, rhi::State::storage_write);
        record(commands);
        move(rhi::State::storage_write, rhi::State::copy_source);
        const rhi::BufferBarrier writable{staging, rhi::State::undefined, rhi::State::copy_destination};
        commands.barrier({}, {&writable, 1});
        commands.copy(rhi::TextureToBuffer{targets.target, staging});
        cpu->queue().submit();
        cpu->queue().wait();
        device.read_buffer(staging, std::as_writable_bytes(std::span(out, SMALL_FLOATS)));
    }

    std::unique_ptr<cpu::CpuDevice> cpu = cpu::create_cpu_device({});
    rhi::Device& device = cpu->device();
    CompositeTargets targets;
    rhi::Buffer staging;
};

Camera camera_at(double altitude_m) { return look(6360e3, altitude_m, 0.3, 0.2, 1.2, 1.6); }

Sun sun_at(double elevation_deg) {
    const double elevation = elevation_deg * std::numbers::pi / 180;
    Sun sun;
    sun.direction = {std::cos(elevation), 0, std::sin(elevation)};
    return sun;
}

void render(int which, float* out) {
    Rig rig;
    Atmosphere air(rig.device, presets::earth(), model(which));
    View view(air, {}, {.target_format = rhi::Format::rgba32_float});
    view.prepare_composite(rig.targets);
    const Sun sun = sun_at(20);
    view.update(camera_at(1500), {&sun, 1});
    rig.show(out, [&](rhi::CommandList& commands) {
        air.record(commands);
        view.record(commands);
        view.record_composite(commands, rig.targets);
    });
}

void follow(planned_frame* out) {
    Rig rig;
    PlanRequirements needs;
    needs.air = presets::earth();
    needs.sun_elevation_deg = {-6, 70};
    needs.rebuilds_per_frame = 1;
    needs.tolerance = 0.05;
    PlannedSky sky(rig.device, needs, {.target_format = rhi::Format::rgba32_float},
                   {.margin = 0.1, .fade_frames = 3, .passes_per_frame = 0});
    sky.prepare_composite(rig.targets);
    sky.set_exposure(10);
    for (int i = 0; i < PLANNED_FRAMES; ++i) {
        sky.set_frame(static_cast<std::uint64_t>(i) + 1);
        const Sun sun = sun_at(i < 2 ? 50 : 1);
        const PlanUpdate update = sky.update(camera_at(2), {&sun, 1});
        out[i].planned = update.planned, out[i].share = update.share;
        out[i].change_count = static_cast<std::uint32_t>(update.changes.size());
        std::string changes;
        for (const PlanChange& c : update.changes) changes += c.what + "|" + c.before + "|" + c.after + "|" + c.reason + ";";
        std::snprintf(out[i].changes, sizeof out[i].changes, "%s", changes.c_str());
        std::snprintf(out[i].setting, sizeof out[i].setting, "%s", sky.plan().setting.id().c_str());
        rig.show(out[i].texels, [&](rhi::CommandList& commands) {
            sky.record(commands);
            sky.record_composite(commands, rig.targets);
        });
        out[i].fading_light = static_cast<bool>(sky.light().after);
        out[i].light_share = sky.light().share;
        out[i].table_bytes = sky.table_bytes();
    }
}

template <class Act>
int told(const Act& act) {
    try {
        act();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "C++: %s\n", error.what());
        return 1;
    }
}

}  // namespace

int small_picture_by_cpp(int model, float* out) {
    return told([&] { render(model, out); });
}

int planned_frames_by_cpp(planned_frame* out) {
    return told([&] { follow(out); });
}
