#include "convert.h"
#include "handles.h"

using namespace aureole;
using namespace aureole::c_api;

aureole_result aureole_requirements_defaults(aureole_requirements* requirements) {
    return guarded([&] { write(requirements, "requirements", to_c(PlanRequirements{})); });
}

aureole_result aureole_make_plan(const aureole_requirements* requirements, aureole_plan** out_plan) {
    return guarded([&] {
        aureole_plan*& out = given(out_plan, "out_plan");
        Plan made = plan(to_cpp(read(requirements, "requirements", to_c(PlanRequirements{}))));
        std::string setting = made.setting.id(), text = made.text();
        out = new aureole_plan{std::move(made), std::move(setting), std::move(text)};
    });
}

aureole_result aureole_destroy_plan(aureole_plan* plan) {
    return guarded([&] { delete plan; });
}

aureole_result aureole_get_plan_summary(const aureole_plan* plan, aureole_plan_summary* out_summary) {
    return guarded([&] {
        const Plan& p = given(plan, "plan").plan;
        write(out_summary, "out_summary",
              {sizeof(aureole_plan_summary), p.tolerable, plan->setting.c_str(), plan->text.c_str(), p.error.median,
               p.error.p95, p.error.light, p.error.bound, p.cost.frame_ms, p.cost.rebuild_ms, p.cost.mebibytes,
               p.cost.charged_ms, p.distance, static_cast<std::uint32_t>(p.warnings.size())});
    });
}

aureole_result aureole_plan_warning(const aureole_plan* plan, uint32_t index, const char** out_text) {
    return guarded([&] {
        const std::vector<std::string>& warnings = given(plan, "plan").plan.warnings;
        if (index >= warnings.size())
            throw Error(ErrorCode::invalid_argument, "index", std::to_string(index),
                        "less than warning_count, " + std::to_string(warnings.size()));
        given(out_text, "out_text") = warnings[index].c_str();
    });
}

aureole_result aureole_plan_view_settings(const aureole_plan* plan, aureole_view_settings* out_settings) {
    return guarded([&] { write(out_settings, "out_settings", to_c(given(plan, "plan").plan.view)); });
}

aureole_result aureole_create_planned_atmosphere(aureole_device* device, const aureole_plan* plan,
                                                 aureole_atmosphere** out_atmosphere) {
    return guarded([&] {
        aureole_device& on = given(device, "device");
        const Plan& p = given(plan, "plan").plan;
        aureole_atmosphere*& out = given(out_atmosphere, "out_atmosphere");
        out = new aureole_atmosphere(on, p.setting, p.air, p.model);
    });
}
