#include "plan/choices.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

namespace aureole::detail {
namespace {

std::string number(double value, int figures) {
    const int magnitude = value != 0 ? static_cast<int>(std::floor(std::log10(std::abs(value)))) : 0;
    std::ostringstream text;
    text << std::fixed << std::setprecision(std::clamp(figures - 1 - magnitude, 0, 9)) << value;
    return std::move(text).str();
}
std::string with_figures(double value, int figures, const char* unit) { return number(value, figures) + " " + unit; }

/// "without it", and what says the same of what is no thing.
std::string other_way(const std::string& what, bool left_out) {
    if (what == "samples") return left_out ? "with all of them" : "with half of them";
    if (what == "float tables") return left_out ? "with floats" : "with half floats";
    return left_out ? "with it" : "without it";
}

class Reasons {
public:
    Reasons(const PlanRequirements& requirements, const Predictor& predictor, const Situation& place, const Outlook& seen,
            const Plan& plan)
        : requirements_(requirements), predictor_(predictor), place_(place), seen_(seen), plan_(plan) {}

    std::vector<PlanChoice> all() {
        add_model();
        for (const DensityTerm& term : requirements_.air.terms) add_part("term " + term.name, term.name);
        for (const std::string_view name : simplification_names()) {
            if (name == "half the samples" || name == "float tables") continue;
            add_part(std::string(name), std::string(name));
        }
        add_part("samples", "half the samples");
        add_part("float tables", "float tables");
        add_passes();
        add_tables();
        return std::move(choices_);
    }

private:
    /// The planned setting with one more, or one less, left out; null if that was not measured.
    [[nodiscard]] const PlanCandidate* otherwise(const std::string& what) const {
        Setting other = plan_.setting;
        if (std::erase(other.without, what) == 0) other.without.push_back(what);
        const bool any_number = what == "wavelengths";  // without them it makes no difference how many there were
        const auto same = [&](const PlanCandidate& one) {
            return one.excluded.empty() && one.setting.model == other.model && one.setting.quality == other.quality &&
                   (any_number || one.setting.spectral == other.spectral) &&
                   std::set(one.setting.without.begin(), one.setting.without.end()) ==
                       std::set(other.without.begin(), other.without.end());
        };
        const auto found = std::ranges::find_if(plan_.candidates, same);
        return found == plan_.candidates.end() ? nullptr : &*found;
    }

    [[nodiscard]] bool by_tolerance() const { return requirements_.tolerance.has_value(); }

    void add_model() {
        const std::size_t count =
            static_cast<std::size_t>(std::ranges::count(plan_.candidates, true, &PlanCandidate::tolerable));
        std::string reason;
        if (!plan_.tolerable)
            reason = "nothing measured meets the requirements; this comes closest";
        else if (by_tolerance())
            reason = count == 1 ? "the only setting that meets the requirements"
                                : "the cheapest of " + std::to_string(count) + " settings that meet the requirements";
        else
            reason = count == 1 ? "the only setting within the budget"
                                : "the most accurate of " + std::to_string(count) + " settings within the budget";
        choices_.push_back({"model",
                            plan_.setting.model + " " + plan_.setting.quality +
                                (plan_.setting.in_rgb() ? "" : ", " + plan_.setting.spectral + " wavelengths"),
                            reason,
                            {},
                            {}});
    }

    /// Something that the setting leaves out, or could.
    void add_part(const std::string& what, const std::string& name) {
        const bool left_out = plan_.setting.leaves_out(name);
        const PlanCandidate* other = otherwise(name);
        if (!left_out && other == nullptr) {
            if (what.starts_with("term "))
                choices_.push_back({what, "kept", "leaving it out of this model was not measured", {}, {}});
            return;
        }
        PlanChoice choice{what, left_out ? "left out" : "kept", {}, {}, {}};
        if (what == "samples") choice.chosen = left_out ? "half of them" : "all of them";
        if (what == "float tables") choice.chosen = left_out ? "half floats" : "kept";
        if (other != nullptr) {
            choice.error_otherwise = other->error.bound - plan_.error.bound;
            choice.cost_otherwise_ms = other->cost.charged_ms - plan_.cost.charged_ms;
            choice.reason = other_way(what, left_out) + " the error would be " + percent(other->error.bound) + ", " +
                            cost_change(*choice.cost_otherwise_ms) + verdict(*other, left_out);
        } else {
            choice.reason = "as it was measured";
        }
        choices_.push_back(std::move(choice));
    }

    [[nodiscard]] std::string cost_change(double ms) const {
        if (std::abs(ms) < 0.02 * plan_.cost.charged_ms) return "at the same cost";
        return milliseconds(std::abs(ms)) + (ms < 0 ? " less" : " more");
    }
    [[nodiscard]] std::string verdict(const PlanCandidate& other, bool left_out) const {
        if (requirements_.tolerance && !left_out && other.error.bound > *requirements_.tolerance)
            return ": more than " + percent(*requirements_.tolerance);
        return {};
    }

    void add_passes() {
        const auto setting = std::ranges::find(predictor_.skies().settings, plan_.setting, &MeasuredSetting::setting);
        const auto measured = predictor_.cost(*setting, place_, table_work(*plan_.model, plan_.air));
        add_air_before_geometry(setting, *measured);
        PlanRequirements whole = requirements_;
        whole.geometry = whole.light = whole.shadows = true;
        const CostParts parts = cost_of(whole, *measured);
        const auto add = [&](const char* what, bool kept, double ms, const char* why_kept, const char* why_left) {
            choices_.push_back(
                {what,
                 kept ? "recorded" : "left out",
                 kept ? std::string(why_kept) + ": " + milliseconds(ms) : std::string(why_left) + ": saves " + milliseconds(ms),
                 {},
                 kept ? -ms : ms});
        };
        add("light", requirements_.light, parts.light_ms, "the host's materials need it", "no material needs it");
        if (!plan_.model->has_shadows()) return;
        add("shadows", requirements_.shadows, parts.shadows_ms,
            "the host's shadow map darkens the air (of one sun, of the default size)", "no shadow map");
        if (requirements_.shadows) choices_.back().reason += shadows_error();
    }

    [[nodiscard]] std::string shadows_error() const {
        if (!plan_.shadows_bound) return "; what they err by is not known";
        return "; away from their edges 95 of 100 directions err by at most " + percent(*plan_.shadows_bound) +
               " of the unshadowed light, in 95 scenes of 100, which no tolerance judges: light scattered more than "
               "once is not shadowed";
    }

    using Settings = std::vector<MeasuredSetting>;
    void add_air_before_geometry(Settings::const_iterator setting, const MeasuredCost& measured) {
        PlanRequirements with_geometry = requirements_;
        with_geometry.geometry = true;
        const bool geometry = requirements_.geometry, kept = seen_.air == AirBefore::drawn;
        const CostParts drawn = cost_of(with_geometry, measured, AirBefore::drawn);
        const CostParts bare = cost_of(with_geometry, measured, AirBefore::left_out);
        const double saved = geometry ? drawn.cost.frame_ms - bare.cost.frame_ms : drawn.aerial_perspective_ms;
        PlanChoice choice{"aerial perspective", kept ? "recorded" : "left out", {}, {}, kept ? -saved : saved};
        choice.reason = !geometry ? "no geometry: saves " + milliseconds(saved)
                        : kept    ? why_air_is_drawn() + ": " + milliseconds(saved)
                                  : "without it geometry up to " + reach() + " away is off by " + off() +
                                     ", within the tolerance of " + percent(*requirements_.tolerance) + ": saves " +
                                     milliseconds(saved) + " and " +
                                     with_unit(drawn.cost.mebibytes - bare.cost.mebibytes, "MiB") + darker_errs_by_more();
        const std::size_t index = static_cast<std::size_t>(setting - predictor_.skies().settings.begin());
        if (const auto& otherwise = seen_.bound_otherwise[index]; geometry && otherwise)
            choice.error_otherwise = *otherwise - plan_.error.bound;
        choices_.push_back(std::move(choice));
    }
    [[nodiscard]] std::string why_air_is_drawn() const {
        const std::string seen = "geometry is seen through the air";
        if (!seen_.bare) return seen + "; what it would err by without " + why_unknown();
        std::string without = seen + "; without it geometry up to " + reach() + " away would be off by " + off();
        if (!requirements_.tolerance) return without;
        if (seen_.bare->bound > *requirements_.tolerance) return without + ", more than " + percent(*requirements_.tolerance);
        return requirements_.shadows ? without + ", but shadows are seen in it" : without + ", but it is in use";
    }
    [[nodiscard]] static std::string darker_errs_by_more() {
        return "; so it is for geometry as bright as ground of albedo " + number(geometry_albedo, 2) +
               ": what is darker errs by more, and view.aerial_perspective = true keeps the air before it";
    }
    [[nodiscard]] std::string why_unknown() const {
        const double farthest_km = bare_distances_km.back();
        if (requirements_.geometry_range_m <= 1000 * farthest_km) return "was not measured";
        return "is not known beyond " + with_figures(farthest_km, 3, "km");
    }
    [[nodiscard]] std::string reach() const { return with_figures(requirements_.geometry_range_m / 1000, 3, "km"); }
    /// "1.2 %, below 1.5 %"
    [[nodiscard]] std::string off() const { return percent(seen_.bare->likely) + ", below " + percent(seen_.bare->bound); }

    void add_tables() {
        for (const ModelTable& table : plan_.model->tables_for(plan_.air)) {
            const bool froxels = table.name == "froxels";
            if (froxels && seen_.air != AirBefore::drawn) continue;
            const rhi::Extent& e = table.size;
            std::string what = std::to_string(e.width) + "x" + std::to_string(e.height);
            if (e.depth > 1) what.append("x").append(std::to_string(e.depth));
            what.append(" ").append(rhi::to_string(table.format)).append(", ").append(table.samples);
            if (froxels) what.append(", to ").append(reach());
            choices_.push_back({table.name, std::move(what), "of " + plan_.setting.id() + why(table), {}, {}});
        }
        choices_.push_back({"memory", with_unit(plan_.cost.mebibytes, "MiB"), "of all tables, of all views and suns", {}, {}});
    }
    /// Less than the quality would take.
    [[nodiscard]] std::string why(const ModelTable& table) const {
        if (plan_.setting.model != "aureole" || table.name != "multi-scatter table") return {};
        const bool lower = plan_.model->quality_for(plan_.air).angular_order < plan_.model->quality().angular_order;
        return lower ? ": this air makes use of no higher order" : "";
    }

    const PlanRequirements& requirements_;
    const Predictor& predictor_;
    const Situation& place_;
    const Outlook& seen_;
    const Plan& plan_;
    std::vector<PlanChoice> choices_;
};

}  // namespace

std::string with_unit(double value, const char* unit) { return with_figures(value, 3, unit); }
std::string percent(double share) { return with_figures(100 * share, 2, "%"); }
std::string milliseconds(double ms) { return with_figures(ms, 3, "ms"); }
std::string times(double factor) { return with_figures(factor, 2, "times"); }

std::vector<PlanChoice> choices_of(const PlanRequirements& requirements, const Predictor& predictor, const Situation& place,
                                   const Outlook& seen, const Plan& plan) {
    return Reasons(requirements, predictor, place, seen, plan).all();
}

}  // namespace aureole::detail
