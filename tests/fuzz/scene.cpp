// Scene files, and what a scene that was accepted gives the library.
#include "fuzz.h"

#include "scene/scene.h"

using namespace aureole;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::accepts([&] {
        const app::Scene scene = app::parse_scene(fuzz::text_of(data, size), "scene.toml");
        const bool valid = fuzz::accepts([&] {
            validate(scene.atmosphere);
            for (const Sun& sun : app::suns_of(scene)) validate(sun);
            (void)scene.model.make();
        });
        fuzz::require(valid, "what a scene holds is valid");
        // A picture of any shape: too narrow a one is an Error.
        fuzz::accepts([&] { validate(app::camera_of(scene, scene.camera.altitude_m, scene.width, scene.height)); });
    });
    return 0;
}
