#include "viewer/core/flight.h"

#include "viewer/core/path.h"

#include "io/test_files.h"

#include <doctest/doctest.h>
#include <cmath>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::viewer;

namespace {

app::Scene scene_with(const std::string& text) { return app::parse_scene(text, "t.toml"); }
doctest::Approx near(double value) { return doctest::Approx(value).scale(1).epsilon(1e-9); }

}  // namespace

TEST_CASE("flight: poses and directions are each other's inverse") {
    for (const app::ScenePose pose : {app::ScenePose{0, 0}, {90, 10}, {-135, -40}, {179, 89}, {12.5, 0.001}}) {
        const app::ScenePose again = pose_of(3.0 * app::direction_of(pose));
        CHECK(again.bearing_deg == near(pose.bearing_deg));
        CHECK(again.elevation_deg == near(pose.elevation_deg));
    }
    CHECK(pose_of({0, 0, 2}).elevation_deg == 90);
    app::ScenePose pose{170, 80};
    turn(pose, 20, 20);
    CHECK(pose.bearing_deg == near(-170));
    CHECK(pose.elevation_deg == 90);
}

TEST_CASE("flight: a degree of the planet towards the sun raises it by a degree, and half way round it is on the other side") {
    app::Scene scene =
        scene_with("[[sun]]\nelevation_deg = 20\nbearing_deg = 90\n[[sun]]\nelevation_deg = 0\nbearing_deg = 0\n");
    const double degree_m = scene.atmosphere.planet.bottom_radius_m * std::acos(-1.0) / 180;
    move_over_ground(scene, {degree_m, 0});  // east, where the first sun stands
    CHECK(scene.suns[0].pose.elevation_deg == near(21));
    CHECK(scene.suns[0].pose.bearing_deg == near(90));
    CHECK(scene.suns[1].pose.elevation_deg == near(0));  // along the axis of the turn
    move_over_ground(scene, {0, -17 * degree_m});
    move_over_ground(scene, {0, 17 * degree_m});
    CHECK(scene.suns[0].pose.elevation_deg == near(21));
    move_over_ground(scene, {180 * degree_m, 0});
    CHECK(scene.suns[0].pose.elevation_deg == near(-21));
    // Away from it, step by step: it sets.
    scene.suns[0].pose = {0, 3};
    for (int i = 0; i < 40; ++i) move_over_ground(scene, {0, -0.1 * degree_m});
    CHECK(scene.suns[0].pose.elevation_deg == near(-1));
}

TEST_CASE("flight: faster the higher, and never into the ground") {
    app::Scene scene = scene_with("[camera]\naltitude_m = 100\n");
    fly(scene, 0, {.up = 1}, 1);
    CHECK(scene.camera.altitude_m == near(100 + flight_speed(100)));
    // From the ground to orbit in a time that one waits for.
    scene.camera.altitude_m = 2;
    double seconds = 0;
    for (; scene.camera.altitude_m < 400e3; seconds += 0.1) fly(scene, 0, {.up = 1}, 0.1);
    CHECK(seconds > 5);
    CHECK(seconds < 30);
    for (int i = 0; i < 1000; ++i) fly(scene, 150, {.up = -1, .fast = true}, 0.1);
    CHECK(scene.camera.altitude_m == 152);
    // The way over the ground is that of the land below, and of the land's place.
    scene = scene_with("[camera]\nclearance_m = 1000\nbearing_deg = 90\n[terrain]\nheightmap = \"jacksboro\"\n");
    fly(scene, 500, {.forward = 1}, 2);
    const double radius = scene.atmosphere.planet.bottom_radius_m;
    CHECK_FALSE(scene.camera.clearance_m);
    CHECK(scene.camera.altitude_m == 1500);
    CHECK(scene.terrain->camera_east_m == near(2 * flight_speed(1000) * radius / (radius + 1500)));
    CHECK(scene.terrain->camera_north_m == near(0));
    const app::Scene before = scene;
    fly(scene, 500, {}, 1);
    CHECK(scene == before);
}

TEST_CASE("flight: the sun goes to where the mouse is") {
    app::Scene scene =
        scene_with("[[sun]]\nelevation_deg = 60\n[camera]\nbearing_deg = 100\nelevation_deg = 10\nvertical_fov_deg = 60\n");
    drag_sun(scene, 0.5, 0.5, 1.5, {});
    CHECK(std::abs(scene.suns[0].pose.bearing_deg - 100) < 0.1);
    CHECK(std::abs(scene.suns[0].pose.elevation_deg - 10) < 0.1);
    drag_sun(scene, 0.5, 0, 1.5, {});  // upper edge: half of the field of view further up
    CHECK(std::abs(scene.suns[0].pose.elevation_deg - 40) < 0.1);
    // What the camera sees there is in that direction: a point of the picture taken from the camera's own matrices.
    drag_sun(scene, 0.8, 0.3, 1.5, {});
    const Camera camera = app::camera_of(scene, 2, 150, 100);
    const glm::dvec4 clip = camera.projection * glm::dvec4(glm::dmat3(camera.view) * app::direction_of(scene.suns[0].pose), 1);
    CHECK(std::abs(clip.x / clip.w - (2 * 0.8 - 1)) < 2e-3);
    CHECK(std::abs(clip.y / clip.w - (1 - 2 * 0.3)) < 4e-3);
    scene.camera.projection = Projection::fisheye;
    const app::ScenePose pose = scene.suns[0].pose;
    drag_sun(scene, 0.8, 0.3, 1.5, {0, -0.1});
    CHECK(scene.suns[0].pose.elevation_deg == near(pose.elevation_deg + 18));
}

TEST_CASE("path: written, read, flown, with all suns") {
    Path path;
    app::Scene scene = scene_with(
        "[[sun]]\nelevation_deg = 10\nbearing_deg = 170\n[[sun]]\nelevation_deg = 30\nbearing_deg = 5\n[camera]\naltitude_m = "
        "100\n");
    path.add(point_of(scene, 100, 0));
    scene.suns[0].pose.bearing_deg = -170;
    scene.suns[1].pose.elevation_deg = 50;
    scene.camera.altitude_m = 300;
    path.add(point_of(scene, 300, 2));
    CHECK(path.at(-1).altitude_m == 100);
    CHECK(path.at(9).altitude_m == 300);
    CHECK(path.at(1).altitude_m == near(200));
    REQUIRE(path.at(0.5).suns.size() == 2);
    CHECK(path.at(0.5).suns[0].bearing_deg == near(175));  // the shorter way round
    CHECK(path.at(0.5).suns[1].elevation_deg == near(35));
    write_path("path.csv", path);
    CHECK(read_path("path.csv").points() == path.points());
    stand_at(scene, path.at(1));
    CHECK(scene.camera.altitude_m == near(200));
    CHECK(scene.suns[0].pose.bearing_deg == near(180));
    CHECK(scene.suns[1].pose.elevation_deg == near(40));
    CHECK(scene.suns[1].pose.bearing_deg == near(5));

    // A sun that goes while the path is recorded stays where it was last; one that comes is none of the path's.
    const app::ScenePose last = scene.suns[1].pose;
    Path shorter;
    shorter.add(point_of(scene, 0, 0));
    scene.suns.resize(1);
    shorter.add(point_of(scene, 0, 1));
    REQUIRE(shorter.points()[1].suns.size() == 2);
    CHECK(shorter.points()[1].suns[1] == last);
    scene.suns.resize(4);
    shorter.add(point_of(scene, 0, 2));
    CHECK(shorter.points()[2].suns.size() == 2);
    Path none;
    none.add(point_of(scene_with("[camera]\naltitude_m = 1\n"), 1, 0));
    write_path("none.csv", none);
    CHECK(read_path("none.csv").points() == none.points());

    app::put("bad.csv",
             "time_s,altitude_m,east_m,north_m,bearing_deg,elevation_deg,vertical_fov_deg\n1,1,1,1,1,1,1\n1,1,1,1,1,1,1\n");
    CHECK(app::contains(app::complaint([] { (void)read_path("bad.csv"); }), "bad.csv:3: time_s: 1 is not allowed"));
    app::put(
        "half.csv",
        "time_s,altitude_m,east_m,north_m,bearing_deg,elevation_deg,vertical_fov_deg,sun_1_bearing_deg\n1,1,1,1,1,1,1,1\n");
    CHECK(app::contains(app::complaint([] { (void)read_path("half.csv"); }), "column sun_1_elevation_deg is missing"));
}
