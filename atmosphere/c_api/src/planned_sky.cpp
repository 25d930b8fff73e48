#include "convert.h"
#include "handles.h"

using namespace aureole;
using namespace aureole::c_api;

aureole_planned_sky::aureole_planned_sky(aureole_device& on, const PlanRequirements& needs, const CompositeSettings& composite,
                                         const FollowSettings& follow)
    : device(on), sky(on.rhi_device(), needs, composite, follow) {
    ++device.atmospheres;
}
aureole_planned_sky::~aureole_planned_sky() { --device.atmospheres; }

aureole_follow_settings c_api::to_c(const FollowSettings& settings) {
    const ShadowSettings& shadows = settings.shadows;
    return {sizeof(aureole_follow_settings),
            settings.fade_frames,
            settings.margin,
            static_cast<std::uint32_t>(settings.passes_per_frame),
            shadows.cascades,
            shadows.distance_m,
            {shadows.size.width, shadows.size.height, shadows.size.depth},
            shadows.samples};
}

FollowSettings c_api::to_cpp(const aureole_follow_settings& c) {
    FollowSettings f;
    f.margin = c.margin;
    f.fade_frames = c.fade_frames;
    // What does not fit an int is out of range all the same.
    f.passes_per_frame = c.passes_per_frame > 1000 ? 1000 : static_cast<int>(c.passes_per_frame);
    f.shadows = {
        c.shadow_cascades, c.shadow_distance_m, {c.shadow_size[0], c.shadow_size[1], c.shadow_size[2]}, c.shadow_samples};
    return f;
}

aureole_result aureole_follow_settings_defaults(aureole_follow_settings* follow) {
    return guarded([&] { write(follow, "follow", to_c(FollowSettings{})); });
}

aureole_result aureole_create_planned_sky(aureole_device* device, const aureole_requirements* requirements,
                                          const aureole_composite_settings* composite, const aureole_follow_settings* follow,
                                          aureole_planned_sky** out_sky) {
    return guarded([&] {
        aureole_device& on = given(device, "device");
        const PlanRequirements needs = to_cpp(read(requirements, "requirements", to_c(PlanRequirements{})));
        const aureole_composite_settings usual = to_c(CompositeSettings{});
        const aureole_follow_settings usual_follow = to_c(FollowSettings{});
        const CompositeSettings shown = to_cpp(composite ? read(composite, "composite", usual) : usual);
        const FollowSettings how = to_cpp(follow ? read(follow, "follow", usual_follow) : usual_follow);
        aureole_planned_sky*& out = given(out_sky, "out_sky");
        out = new aureole_planned_sky(on, needs, shown, how);
    });
}

aureole_result aureole_destroy_planned_sky(aureole_planned_sky* sky) {
    return guarded([&] { delete sky; });
}

aureole_result aureole_update_planned_sky(aureole_planned_sky* sky, const aureole_camera* camera, const aureole_sun* suns,
                                          uint32_t sun_count, aureole_plan_update* out_update) {
    return guarded([&] {
        aureole_planned_sky& of = given(sky, "sky");
        const Camera from = to_cpp(read(camera, "camera", to_c(Camera{})));
        if (out_update) check_size<aureole_plan_update>(out_update->struct_size, "out_update");
        PlanUpdate update = of.sky.update(from, read_suns(suns, sun_count));
        of.changes = std::move(update.changes);
        if (out_update)
            write(out_update, "out_update",
                  {sizeof(aureole_plan_update), update.planned, update.share, static_cast<std::uint32_t>(of.changes.size())});
    });
}

aureole_result aureole_get_plan_change(const aureole_planned_sky* sky, uint32_t index, aureole_plan_change* out_change) {
    return guarded([&] {
        const std::vector<PlanChange>& changes = given(sky, "sky").changes;
        if (index >= changes.size())
            throw Error(ErrorCode::invalid_argument, "index", std::to_string(index),
                        "less than change_count, " + std::to_string(changes.size()));
        const PlanChange& c = changes[index];
        write(out_change, "out_change",
              {sizeof(aureole_plan_change), c.what.c_str(), c.before.c_str(), c.after.c_str(), c.reason.c_str()});
    });
}

aureole_result aureole_copy_plan(const aureole_planned_sky* sky, aureole_plan** out_plan) {
    return guarded([&] {
        const Plan& plan = given(sky, "sky").sky.plan();
        aureole_plan*& out = given(out_plan, "out_plan");
        out = new aureole_plan{plan, plan.setting.id(), plan.text()};
    });
}

aureole_result aureole_set_planned_air(aureole_planned_sky* sky, const aureole_parameters* air) {
    return guarded([&] { given(sky, "sky").sky.set_air(read_parameters(air, "air")); });
}

aureole_result aureole_set_planned_exposure(aureole_planned_sky* sky, double exposure) {
    return guarded([&] { given(sky, "sky").sky.set_exposure(exposure); });
}

aureole_result aureole_set_planned_shadow_map(aureole_planned_sky* sky, const aureole_shadow_map* map) {
    return guarded([&] {
        aureole_planned_sky& of = given(sky, "sky");
        of.sky.set_shadow_map(to_cpp(read(map, "map", to_c(ShadowMap{}))));
    });
}

aureole_result aureole_set_planned_frame(aureole_planned_sky* sky, uint64_t frame) {
    return guarded([&] { given(sky, "sky").sky.set_frame(frame); });
}

aureole_result aureole_prepare_planned_composite(aureole_planned_sky* sky, const aureole_composite_targets* targets) {
    return guarded([&] { given(sky, "sky").sky.prepare_composite(read_targets(targets)); });
}

aureole_result aureole_release_planned_composite(aureole_planned_sky* sky, const aureole_composite_targets* targets) {
    return guarded([&] { given(sky, "sky").sky.release_composite(read_targets(targets)); });
}

aureole_result aureole_record_planned_sky(aureole_planned_sky* sky, aureole_commands* commands) {
    return guarded([&] {
        aureole_planned_sky& of = given(sky, "sky");
        of.sky.record(open_list(of.device, commands));
    });
}

aureole_result aureole_record_planned_composite(aureole_planned_sky* sky, aureole_commands* commands,
                                                const aureole_composite_targets* targets) {
    return guarded([&] {
        aureole_planned_sky& of = given(sky, "sky");
        of.sky.record_composite(open_list(of.device, commands), read_targets(targets));
    });
}

aureole_result aureole_invalidate_planned_sky(aureole_planned_sky* sky) {
    return guarded([&] { given(sky, "sky").sky.invalidate(); });
}

aureole_result aureole_get_planned_light(const aureole_planned_sky* sky, aureole_planned_light* out_light) {
    return guarded([&] {
        const PlannedLight light = given(sky, "sky").sky.light();
        write(out_light, "out_light", {sizeof(aureole_planned_light), light.before.value, light.after.value, light.share});
    });
}

aureole_result aureole_planned_table_bytes(const aureole_planned_sky* sky, uint64_t* out_bytes) {
    return guarded([&] { given(out_bytes, "out_bytes") = given(sky, "sky").sky.table_bytes(); });
}
