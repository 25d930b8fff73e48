#include "viewer/core/fields.h"

#include "io/test_files.h"

#include <doctest/doctest.h>
#include <algorithm>
#include <filesystem>
#include <numbers>
#include <set>

using namespace aureole;
using namespace aureole::viewer;
using app::complaint, app::contains;

namespace {

State state_with(const std::string& text) { return state_of(app::parse_scene(text, "t.toml"), "cpu"); }

}  // namespace

TEST_CASE("fields: each scene's are named once, inside their ranges, and are set to what they are") {
    for (const auto& file : std::filesystem::directory_iterator(AUREOLE_SCENES)) {
        if (file.path().extension() != ".toml") continue;
        CAPTURE(file.path().string());
        State state = state_of(app::read_scene(file.path()), "vulkan");
        const State before = state;
        std::set<std::string> names;
        for (const Field& field : fields_of(before)) {
            CAPTURE(field.name);
            CHECK(names.insert(field.name).second);
            CHECK(field.is_number() != static_cast<bool>(field.text));
            CHECK_NOTHROW(set_field(state, field.name, get_field(state, field.name)));
            CHECK(state == before);
        }
        CHECK(names.size() > 50);
    }
}

TEST_CASE("fields: each changes something, and only itself") {
    const State before = state_with(
        "exposure = 3\n[[sun]]\nirradiance = 1\n[camera]\nclearance_m = 5\n[terrain]\nheightmap = \"jacksboro\"\nalbedo = "
        "0.1\n");
    for (const Field& field : fields_of(before)) {
        CAPTURE(field.name);
        State state = before;
        std::string other;
        if (field.is_number())
            other = std::to_string(field.number(before) < (field.least + field.most) / 2 && field.least >= 0
                                       ? std::min(2 * field.number(before) + 0.25, field.most)
                                       : (field.least + field.number(before)) / 2);
        else if (field.options.size() > 1)
            other = field.options[field.options[0] == field.text(before)];
        else
            continue;
        if (field.name.ends_with("radius_m")) other = std::to_string(field.number(before) + 1);
        if (field.name == "view.table_pane" || field.name == "view.table_slice") other = "1";
        if (field.name == "planet.preset") other = "mars";
        CHECK(complaint([&] { set_field(state, field.name, other); }) == "nothing");
        CHECK_FALSE(state == before);
        if (field.is_number()) CHECK(get_field(state, field.name) != get_field(before, field.name));
    }
}

TEST_CASE("fields: what is refused says why, and changes nothing") {
    State state = state_with("[[sun]]\n");
    const State before = state;
    const auto refused = [&](const char* name, const char* value) { return complaint([&] { set_field(state, name, value); }); };
    CHECK(contains(refused("camera.speed", "1"), "field: \"camera.speed\" is not allowed; allowed: camera.altitude_m, "));
    CHECK(refused("camera.elevation_deg", "91") == "camera.elevation_deg: 91 is not allowed; allowed: in [-90, 90]");
    CHECK(contains(refused("camera.elevation_deg", "up"), "\"up\" is not allowed; allowed: a number"));
    CHECK(contains(refused("camera.elevation_deg", "nan"), "nan is not allowed"));
    CHECK(contains(refused("a.model", "preetham"), "a.model: \"preetham\" is not allowed; allowed: "));
    CHECK(contains(refused("sun.2.elevation_deg", "1"), "field: "));
    CHECK(contains(refused("planet.bottom_radius_m", "7e6"), "planet.bottom_radius_m"));
    CHECK(state == before);
}

TEST_CASE("fields: an altitude takes the place of a clearance, and a term's kind brings its own fields") {
    State state = state_with("[camera]\nclearance_m = 5\n[terrain]\nheightmap = \"jacksboro\"\n");
    set_field(state, "camera.altitude_m", "5000");
    CHECK_FALSE(state.scene.camera.clearance_m);
    CHECK(get_field(state, "camera.altitude_m") == "5000");
    set_field(state, "term.mie.phase", "henyey_greenstein_draine");
    set_field(state, "term.mie.alpha", "7");
    CHECK(std::get<HenyeyGreensteinDrainePhase>(state.scene.atmosphere.terms[1].phase).alpha == 7);
    set_field(state, "planet.preset", "titan");
    CHECK(get_field(state, "planet.preset") == "titan");
    set_field(state, "terrain.heightmap", "none");
    CHECK_FALSE(state.scene.terrain);
    set_field(state, "suns", "3");
    CHECK(state.scene.suns.size() == 3);
}

TEST_CASE("fields: a table's last row is set as its first, however many there are") {
    State state = state_with("[[sun]]\n");
    TabulatedProfile table;
    for (int row = 0; row < 4096; ++row) {  // the most that the air takes
        table.altitude_m.push_back(10.0 * row);
        table.density.push_back(1 - row / 4096.0);
    }
    state.scene.atmosphere.terms[1].profile = table;
    set_field(state, "term.mie.profile.density.65", "0.75");
    set_field(state, "term.mie.profile.altitude_m.4096", "40960");
    table.density[64] = 0.75;
    table.altitude_m[4095] = 40960;
    CHECK(std::get<TabulatedProfile>(state.scene.atmosphere.terms[1].profile) == table);
    const auto all = fields_of(state), without = fields_of(state, Rows::left_out);
    CHECK(all.size() == without.size() + 2 * 4096);
    CHECK(
        std::ranges::none_of(without, [](const Field& field) { return field.group == sample_group("mie", Sampled::profile); }));
}

TEST_CASE("fields: samples of a tabulated profile and phase function are set, added and taken out") {
    State state = state_with("[[sun]]\n");
    set_field(state, "term.mie.profile", "tabulated");
    CHECK(sample_count(state, 1, Sampled::profile) == 3);
    CHECK(sample_count(state, 1, Sampled::phase) == 0);
    CHECK(sample_count(state, 0, Sampled::profile) == 0);
    const auto profile = [&]() -> TabulatedProfile {
        return std::get<TabulatedProfile>(state.scene.atmosphere.terms[1].profile);
    };
    set_field(state, "term.mie.profile.altitude_m.2", "2000");
    set_field(state, "term.mie.profile.density.2", "0.5");
    CHECK(profile() == TabulatedProfile{{0, 2000, 10000}, {1, 0.5, 0}});
    insert_sample(state, 1, Sampled::profile, 1);
    insert_sample(state, 1, Sampled::profile, 3);
    CHECK(profile() == TabulatedProfile{{0, 2000, 6000, 10000, 14000}, {1, 0.5, 0.25, 0, 0}});
    remove_sample(state, 1, Sampled::profile, 0);
    CHECK(profile() == TabulatedProfile{{2000, 6000, 10000, 14000}, {0.5, 0.25, 0, 0}});
    // Altitudes rise, and two rows stay.
    const State before = state;
    CHECK(
        contains(complaint([&] { set_field(state, "term.mie.profile.altitude_m.2", "10001"); }), "allowed: in [2000, 10000]"));
    CHECK(contains(complaint([&] { set_field(state, "term.mie.profile.altitude_m.2", "10000"); }), "altitude_m"));
    CHECK(state == before);
    remove_sample(state, 1, Sampled::profile, 0);
    remove_sample(state, 1, Sampled::profile, 0);
    CHECK(complaint([&] { remove_sample(state, 1, Sampled::profile, 0); }) != "nothing");
    CHECK(sample_count(state, 1, Sampled::profile) == 2);

    set_field(state, "term.mie.phase", "tabulated");
    CHECK(contains(complaint([&] { set_field(state, "term.mie.phase.angle_rad.1", "1"); }), "field: "));
    insert_sample(state, 1, Sampled::phase, 1);  // the last stays the last
    set_field(state, "term.mie.phase.angle_rad.2", "1");
    set_field(state, "term.mie.phase.value.1", "5");
    const auto& phase = std::get<TabulatedPhase>(state.scene.atmosphere.terms[1].phase);
    CHECK(phase == TabulatedPhase{{0, 1, std::numbers::pi}, {5, 1, 1}});
    CHECK(complaint([&] { remove_sample(state, 1, Sampled::phase, 0); }) != "nothing");
    remove_sample(state, 1, Sampled::phase, 1);
    CHECK(sample_count(state, 1, Sampled::phase) == 2);
}
