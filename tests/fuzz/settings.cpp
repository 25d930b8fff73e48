// Settings of models, views and composites, and what the planner is asked, from bytes. What is accepted must be of use.
#include "bytes.h"
#include "fuzz.h"

#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/models/aureole.h>
#include <aureole/models/bruneton.h>
#include <aureole/models/fog.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/reference.h>
#include <aureole/models/single_lut.h>
#include <aureole/models/spectral.h>
#include <aureole/plan.h>
#include <aureole/presets.h>
#include <aureole/spectrum.h>

using namespace aureole;

namespace {

rhi::Extent extent(fuzz::Bytes& bytes, std::uint32_t low, std::uint32_t high, bool flat = true) {
    const auto width = bytes.integer<std::uint32_t>(low, high), height = bytes.integer<std::uint32_t>(low, high);
    return {width, height, flat ? bytes.integer<std::uint32_t>(1, 1) : bytes.integer<std::uint32_t>(low, high)};
}
rhi::Format format(fuzz::Bytes& bytes) {
    const std::uint8_t byte = bytes.raw<std::uint8_t>();
    if (byte >= 220) return static_cast<rhi::Format>(byte - 220);
    return byte % 2 == 0 ? rhi::Format::rgba16_float : rhi::Format::rgba32_float;
}
int whole(fuzz::Bytes& bytes, int low, int high) { return bytes.integer<int>(low, high); }

ModelPtr aureole_of(fuzz::Bytes& bytes) {
    QualitySettings s;
    s.transmittance = extent(bytes, 2, 4096);
    s.transmittance_nodes = whole(bytes, 2, 16);
    s.multi_scatter = extent(bytes, 2, 256);
    s.angular_order = whole(bytes, 0, 8);
    s.angular_order_as_needed = bytes.flag();
    s.multi_scatter_zenith = whole(bytes, 2, 16);
    s.multi_scatter_azimuth = whole(bytes, 2, 32);
    s.multi_scatter_nodes = whole(bytes, 2, 16);
    s.multi_scatter_later_nodes = whole(bytes, 2, 16);
    s.multi_scatter_orders = whole(bytes, 0, 64);
    s.ground_light = bytes.flag();
    s.sky_view = extent(bytes, 4, 4096);
    s.sky_view_nodes = whole(bytes, 2, 16);
    s.aerial_perspective = extent(bytes, 2, 256, false);
    s.aerial_perspective_nodes = whole(bytes, 1, 8);
    s.table_format = format(bytes);
    s.froxel_format = format(bytes);
    validate(s);
    return models::aureole(s);
}

ModelPtr hillaire_of(fuzz::Bytes& bytes) {
    models::HillaireSettings s;
    s.transmittance = extent(bytes, 2, 4096);
    s.transmittance_steps = whole(bytes, 1, 256);
    s.multi_scatter = extent(bytes, 2, 256);
    s.multi_scatter_steps = whole(bytes, 1, 256);
    s.fast_sky = bytes.flag();
    s.sky_view = extent(bytes, 4, 4096);
    s.sky_view_steps = whole(bytes, 1, 256);
    s.fast_aerial_perspective = bytes.flag();
    s.aerial_perspective = extent(bytes, 2, 256, false);
    s.march_steps = whole(bytes, 1, 256);
    s.table_format = format(bytes);
    s.froxel_format = format(bytes);
    validate(s);
    return models::hillaire(s);
}

ModelPtr bruneton_of(fuzz::Bytes& bytes) {
    models::BrunetonSettings s;
    s.transmittance = extent(bytes, 2, 4096);
    s.irradiance = extent(bytes, 2, 1024);
    s.altitude_nodes = whole(bytes, 2, 256);
    s.view_nodes = whole(bytes, 4, 512);
    s.sun_nodes = whole(bytes, 2, 256);
    s.nu_nodes = whole(bytes, 2, 64);
    s.orders = whole(bytes, 1, 64);
    s.combined = bytes.flag();
    s.format = format(bytes);
    s.sampling = bytes.choice<models::BrunetonSampling>(2);
    s.transmittance_nodes = whole(bytes, 2, 16);
    s.ray_nodes = whole(bytes, 2, 16);
    s.zenith_nodes = whole(bytes, 2, 16);
    s.azimuth_nodes = whole(bytes, 2, 16);
    s.lowest_sun_deg = bytes.number(91, 120);
    s.slices_per_frame = whole(bytes, 0, 1000000);
    validate(s);
    return models::bruneton(s);
}

models::Dome dome(fuzz::Bytes& bytes) {
    models::Dome d;
    if (bytes.flag()) d.size = extent(bytes, 4, 4096);
    d.phase = bytes.choice<models::Dome::Phase>(2);
    d.format = format(bytes);
    return d;
}

ModelPtr single_of(fuzz::Bytes& bytes) {
    models::SingleSettings s;
    s.steps = bytes.choice<models::Steps>(2);
    s.view_steps = whole(bytes, 1, 256);
    s.light_steps = whole(bytes, 1, 256);
    s.dome = dome(bytes);
    validate(s);
    return models::single(s);
}

ModelPtr single_lut_of(fuzz::Bytes& bytes) {
    models::SingleLutSettings s;
    s.steps = bytes.choice<models::Steps>(2);
    s.view_steps = whole(bytes, 1, 256);
    s.table = extent(bytes, 2, 4096);
    s.table_nodes = whole(bytes, 2, 16);
    s.table_format = format(bytes);
    s.dome = dome(bytes);
    validate(s);
    return models::single_lut(s);
}

ModelPtr fog_of(fuzz::Bytes& bytes) {
    models::FogSettings s;
    s.mode = bytes.choice<models::FogSettings::Mode>(2);
    s.sky = bytes.choice<models::FogSettings::Sky>(2);
    s.colour = {bytes.number(0, 1e6), bytes.number(0, 1e6), bytes.number(0, 1e6)};
    s.density_per_m = bytes.number(0, 1e3);
    s.transmittance_nodes = whole(bytes, 2, 16);
    validate(s);
    return models::fog(s);
}

ModelPtr reference_of(fuzz::Bytes& bytes) {
    models::ReferenceSettings s;
    s.show = bytes.choice<models::ReferenceSettings::Show>(2);
    s.tracking = bytes.choice<models::ReferenceSettings::Tracking>(2);
    s.paths_per_frame = whole(bytes, 0, 65536);
    s.max_paths = whole(bytes, 1, 16777216);
    s.film_width = bytes.integer<std::uint32_t>(0, 16384);
    s.film_height = bytes.integer<std::uint32_t>(0, 16384);
    s.max_order = whole(bytes, 0, 4096);
    s.first_order_parts = whole(bytes, 1, 16);
    s.nodes = whole(bytes, 4, 16);
    s.roulette_order = whole(bytes, 1, 4096);
    s.seed = whole(bytes, 0, 16777215);
    s.light_paths = whole(bytes, 0, 4096);
    s.validate();
    return models::reference(s);
}

ModelPtr model_of(fuzz::Bytes& bytes) {
    using Maker = ModelPtr (*)(fuzz::Bytes&);
    static constexpr Maker makers[] = {aureole_of, hillaire_of, bruneton_of, single_of, fog_of, single_lut_of, reference_of};
    ModelPtr model = makers[bytes.below(std::size(makers))](bytes);
    if (!bytes.flag()) return model;
    models::SpectralSettings s;
    s.wavelengths = spectrum::equal_bins(whole(bytes, 1, 400));
    for (double& nm : s.wavelengths.nm)
        if (bytes.below(32) == 31) nm = bytes.number(360, 830);
    for (Rgb& weight : s.wavelengths.to_rec709)
        if (bytes.below(32) == 31) weight.g = bytes.number(-1e30, 1e30);
    validate(s);
    return models::spectral(model, s);
}

/// In fog, which keeps no tables: a view is made in no time.
void make_view(fuzz::Bytes& bytes) {
    static const std::unique_ptr<cpu::CpuDevice> machine = cpu::create_cpu_device();
    static Atmosphere air(machine->device(), presets::earth(), models::fog());
    ViewSettings view;
    view.projection = bytes.choice<Projection>(3);
    view.max_suns = bytes.integer<std::uint32_t>(1, 4);
    view.aerial_perspective = bytes.flag();
    view.aerial_perspective_distance_m = bytes.number(1e-3, 1e13);
    view.light = bytes.flag();
    view.shadows.cascades = bytes.integer<std::uint32_t>(0, 4);
    view.shadows.distance_m = bytes.number(1e-3, 1e13);
    view.shadows.size = extent(bytes, 2, 8, false);
    view.shadows.samples = bytes.integer<std::uint32_t>(1, 64);
    CompositeSettings composite;
    composite.target_format = bytes.choice<rhi::Format>(13);
    composite.raster = bytes.flag();
    composite.scene_color = bytes.flag();
    composite.scene_depth = bytes.flag();
    composite.sun_disk = bytes.flag();
    composite.sun_lobe_g = bytes.number(0, 0.9999);
    composite.exposure = bytes.number(1e-30, 1e30);
    composite.tone_map = bytes.choice<ToneMap>(2);
    composite.encode_srgb = bytes.flag();
    composite.dither = bytes.flag();
    const View made(air, view, composite);
}

void make_plan(fuzz::Bytes& bytes) {
    PlanRequirements needs;
    needs.air = presets::by_name(presets::names()[bytes.below(presets::names().size())]);
    needs.sun_elevation_deg = {bytes.number(-90, 90), 90};
    if (bytes.flag()) needs.sun_elevation_deg.most = bytes.number(-90, 90);
    needs.altitude_m = {bytes.number(-1e4, bytes.flag() ? 1e12 : 1e5), 1e12};
    if (bytes.flag()) needs.altitude_m.most = bytes.number(-1e4, 1e12);
    needs.projection = bytes.choice<Projection>(3);
    needs.geometry = bytes.flag();
    needs.geometry_range_m = bytes.number(1e-3, 1e13);
    needs.shadows = bytes.flag();
    needs.light = bytes.flag();
    needs.suns = bytes.integer<std::uint32_t>(1, 4);
    needs.views = bytes.integer<std::uint32_t>(1, 64);
    needs.width = bytes.integer<std::uint32_t>(1, 65536);
    needs.height = bytes.integer<std::uint32_t>(1, 65536);
    needs.wavelengths = bytes.below(16) == 15;
    needs.rebuilds_per_frame = bytes.number(0, 1);
    if (bytes.flag()) needs.tolerance = bytes.number(1e-4, 10);
    if (bytes.flag()) needs.budget_ms = bytes.number(1e-9, 1e6);
    if (bytes.flag()) needs.budget_mib = bytes.number(1e-9, 1e6);
    needs.speed = {bytes.number(1e-6, 1e6), bytes.number(1e-6, 1e6)};
    validate(needs);
    if (bytes.below(8) != 0) return;  // it takes some milliseconds
    const Plan made = plan(needs);
    for (const double figure : {made.error.median, made.error.p95, made.error.bound, made.cost.frame_ms, made.cost.rebuild_ms,
                                made.cost.mebibytes, made.cost.charged_ms, made.distance})
        fuzz::require(std::isfinite(figure) && figure >= 0, "a plan's figures are finite: " + std::to_string(figure));
    fuzz::require(made.model != nullptr && !made.candidates.empty() && !made.text().empty(), "a plan has a model and reasons");
}

void make_spectrum(fuzz::Bytes& bytes) {
    spectrum::EarthAir air;
    air.co2_ppm = bytes.number(0, 1e6);
    air.ozone_dobson = bytes.number(0, 1e4);
    air.ozone = {bytes.number(-1e12, 1e12), bytes.number(0.01, 1e12)};
    air.aerosol_beta = bytes.number(0, 1e3);
    air.aerosol_alpha = bytes.number(-4, 4);
    air.aerosol_scale_height_m = bytes.number(0.01, 1e12);
    air.aerosol_albedo = bytes.number(0, 1);
    air.aerosol_g = bytes.number(-0.999, 0.999);
    air.ground_albedo = bytes.number(0, 1);
    validate(spectrum::earth({bytes.number(360, 830), bytes.number(360, 830), bytes.number(360, 830)}, air));

    spectrum::Bands bands;
    for (std::size_t count = bytes.below(16); count > 0; --count) bands.edge_nm.push_back(bytes.number(0, 1e6));
    if (bytes.flag()) std::ranges::sort(bands.edge_nm);
    for (std::size_t i = 1; i < bands.edge_nm.size(); ++i) bands.value.push_back(bytes.number(-1e100, 1e100));
    const glm::dvec3 xyz = spectrum::xyz(bands);
    fuzz::require(std::isfinite(xyz.x + xyz.y + xyz.z), "a colour is finite");
    (void)calibrated({bytes.number(1e-9, 1e9), bytes.number(1e-9, 1e9)});
    (void)HenyeyGreensteinDrainePhase::from_droplet_diameter(bytes.number(5, 50));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    (void)fuzz::accepts_value([&] {
        switch (bytes.below(4)) {
            case 0:
                return (void)model_of(bytes);
            case 1:
                return make_view(bytes);
            case 2:
                return make_plan(bytes);
            default:
                return make_spectrum(bytes);
        }
    });
    return 0;
}
