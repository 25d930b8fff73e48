// Look-ups on Vulkan, by the test kernel and by a host's own shader with descriptor sets made by hand: both give what the CPU
// in double finds in the same tables. Under core and synchronization validation and the RHI's own.
#include <doctest/doctest.h>

#include <algorithm>

#include "host/compare.h"
#include "host/vulkan_host.h"

using namespace aureole;
using namespace aureole::host;
using namespace aureole::passes;
using vulkan::test::Host;

namespace {

/// A rig on a host's device, kept over several scenes: making one costs the driver seconds.
struct Stage {
    Stage(Host& host, const Scene& scene)
        : inner(new OpenHost(host)), backend("host", std::unique_ptr<OpenDevice>(inner)), rig(backend, scene.setup) {
        show(scene);
    }
    /// The scene's air has the structure of the first one's.
    void show(const Scene& scene) {
        rig.air.set_parameters(scene.setup.air);
        rig.record_air();
        rig.record_view(scene.camera, scene.suns);
    }
    OpenHost* inner;
    Backend backend;
    Rig rig;
};

const Scene& named(const std::string& name) {
    static const std::vector<Scene> all = scenes();
    return *std::find_if(all.begin(), all.end(), [&](const Scene& scene) { return scene.name == name; });
}

/// What the CPU in double makes of the stage's tables.
std::vector<Answer> in_double(Stage& stage, const Scene& scene, std::span<const Question> questions) {
    Shown exact(open_cpu_double(), scene);
    exact.backend->write(exact.rig.air.transmittance_table(), stage.rig.transmittance());
    exact.backend->write(exact.rig.view.sky_view_table(), stage.rig.sky_view());
    exact.backend->write(exact.rig.view.aerial_perspective_table(), stage.rig.froxels());
    exact.backend->write(exact.rig.view.light_table(), stage.rig.light());
    return ask(exact.rig, questions);
}

void check_sky_against_composite(Stage& stage, std::span<const Question> questions, std::span<const Answer> answers) {
    const rhi::Extent extent{static_cast<std::uint32_t>(questions.size()), 1, 1};
    Image directions{extent, {}};
    for (const Question& q : questions) directions.texels.emplace_back(q.direction, 0);
    CompositeTargets targets;
    targets.directions = stage.backend.make("directions", rhi::Format::rgba32_float, directions);
    const Image sky = stage.rig.show(extent, targets);
    Worst radiance("sky of the composite", 1e-5, 1e-7);
    for (std::size_t i = 0; i < answers.size(); ++i) radiance.add(i, answers[i].sky, Rgb(sky.texels[i]));
    radiance.check();
}

/// Kernel, host's shader and CPU on the tables as they are.
void check_lookups(Stage& stage, const Scene& scene, const HostShader& shader = {}) {
    INFO(scene.name);
    const std::vector<Question> questions = assorted(200, static_cast<int>(scene.suns.size()));
    const std::vector<Answer> expected = in_double(stage, scene, questions);
    const std::vector<Answer> by_kernel = ask(stage.rig, questions);
    check_same_answers(by_kernel, expected);
    check_sky_against_composite(stage, questions, by_kernel);

    Asker asker(*stage.inner, stage.rig, shader, questions);
    asker.record();
    stage.inner->host().submit_and_wait();
    check_same_answers(asker.answers(), expected);
}

Scene without_disks(const std::string& name) {
    Scene scene = named(name);
    scene.setup.composite = {.target_format = rhi::Format::rgba32_float, .sun_disk = false};
    return scene;
}

}  // namespace

TEST_CASE(
    "a host's own shader looks up on Vulkan what the CPU does, by day, at dawn, in orbit, and after the air has changed") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    const Scene noon = without_disks("noon");
    Stage stage(host, noon);
    check_lookups(stage, noon);

    // New numbers: everything that the host bound stays.
    const std::string defines = stage.rig.view.shader_defines();
    const rhi::Texture sky_view = stage.rig.view.sky_view_table(), transmittance = stage.rig.air.transmittance_table();
    const rhi::Buffer block = stage.rig.view.view_block();
    const Scene dawn = without_disks("haze at dawn"), orbit = without_disks("low orbit");
    stage.show(dawn);
    check_lookups(stage, dawn, {.set = 1, .first_slot = 10});
    stage.show(orbit);
    check_lookups(stage, orbit);
    CHECK(stage.rig.view.shader_defines() == defines);
    CHECK(stage.rig.view.sky_view_table() == sky_view);
    CHECK(stage.rig.air.transmittance_table() == transmittance);
    CHECK(stage.rig.view.view_block() == block);

    // A new structure: all of it ends, and what the host asks for then works.
    Scene tabulated = noon;
    tabulated.name = "tabulated phase";
    tabulated.setup.air = tabulated_haze();
    stage.show(tabulated);
    CHECK(stage.rig.view.shader_defines() != defines);
    CHECK_THROWS_AS((void)stage.inner->guest().native(sky_view), Error);
    CHECK_THROWS_AS((void)stage.inner->guest().native(transmittance), Error);
    CHECK_THROWS_AS((void)stage.inner->guest().native(block), Error);
    check_lookups(stage, tabulated);
}

TEST_CASE("two suns; and the next frame in the same command buffer waits for the host's look-ups") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    const Scene scene = without_disks("two suns");
    Stage stage(host, scene);
    check_lookups(stage, scene);

    Scene dusk = scene;
    dusk.suns[0] = sun_at(-1);
    const std::vector<Question> questions = assorted(100, 2);
    Asker first(*stage.inner, stage.rig, {.set = 3, .first_slot = 20}, questions),
        second(*stage.inner, stage.rig, {}, questions);
    const std::vector<Answer> before = ask(stage.rig, questions);
    stage.inner->host_queue().hold();
    first.record();
    stage.rig.record_view(dusk.camera, dusk.suns);  // overwrites what `first` reads
    second.record();
    stage.inner->host_queue().release();
    check_same_answers(first.answers(), before);
    check_same_answers(second.answers(), ask(stage.rig, questions));
    CHECK(before[0].sky.r > 2 * second.answers()[0].sky.r);
}
