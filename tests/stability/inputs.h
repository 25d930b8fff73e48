// What the kernels' functions are given of a case, for kernels in float and in double.
#pragma once

#include "camera/pack_view.h"
#include "common/pack_atmosphere.h"
#include "multi_scatter/multi_scatter.h"
#include "quadrature/gauss_legendre.h"
#include "stability/cases.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <vector>

namespace aureole::stability {

/// What the device gets of a case: floats, whatever the kernel computes in. Legendre moments are left out: they cost more than
/// the rest together.
class Inputs {
public:
    explicit Inputs(const AtmosphereParameters& parameters) {
        validate(parameters);
        const detail::ExactAtmosphere exact = detail::pack_exact(parameters);
        structure = exact.structure;
        air = detail::round_block<detail::AtmosphereBlock>(exact.block);
        air.sun_mapping = glm::vec4(detail::sun_mapping(parameters.planet));
        phase_table.assign(exact.phase_table.begin(), exact.phase_table.end());
        profile_table.assign(exact.profile_table.begin(), exact.profile_table.end());
    }
    /// With the camera and the first of the suns.
    Inputs(const AtmosphereParameters& parameters, const Case& c) : Inputs(parameters) { look(c); }
    explicit Inputs(const Case& c) : Inputs(c.air(), c) {}

    /// Legendre moments of the phase functions, too.
    void add_moments(const AtmosphereParameters& parameters) {
        const detail::PackedAtmosphere packed = detail::pack_atmosphere(parameters);
        std::ranges::copy(packed.block.phase_moments, std::begin(air.phase_moments));
    }
    void look(const Case& c) {
        const std::vector<Sun> given = c.suns();
        const std::span<const Sun> suns(given.data(), std::min<std::size_t>(given.size(), 1));
        view = detail::pack_view(c.camera(), suns, c.planet());
        sun_count = static_cast<int>(suns.size());
    }

    detail::AtmosphereBlock air{};
    detail::AirStructure structure;
    std::vector<float> phase_table, profile_table;
    detail::ViewBlock view{};
    int sun_count = 0;
};

/// The planet alone.
inline AtmosphereParameters without_air(const Planet& planet) {
    AtmosphereParameters bare;
    bare.planet = planet;
    return bare;
}

/// One kernel, which takes one case after another.
template <template <class> class Kernel, class real>
class Fed {
public:
    explicit Fed(int nodes = 8) {
        kernel.RAY_NODES = nodes;
        kernel.quadrature = widened<decltype(kernel.quadrature)>(detail::quadrature_block(nodes));
    }
    Fed(const Fed&) = delete;
    Fed& operator=(const Fed&) = delete;
    /// Any other rule of the kernel's.
    template <class Block>
    static void rule(Block& block, int nodes) {
        block = widened<Block>(detail::quadrature_block(nodes));
    }
    Kernel<real>& set(const Inputs& in) {
        kernel.atm = widened<decltype(kernel.atm)>(in.air);
        if constexpr (requires { kernel.view; }) kernel.view = widened<decltype(kernel.view)>(in.view);
        kernel.TERM_COUNT = in.structure.term_count;
        kernel.TERM_KINDS = in.structure.term_kinds;
        kernel.TERM_PHASES = in.structure.term_phases;
        kernel.PHASE_COUNT = in.structure.phase_count;
        kernel.PHASE_KINDS = in.structure.phase_kinds;
        if constexpr (requires { kernel.SHARP_PHASES; }) kernel.SHARP_PHASES = static_cast<int>(in.structure.sharp_phases);
        kernel.SUN_COUNT = in.sun_count;
        if constexpr (requires { kernel.phase_table; }) show(kernel.phase_table, phase_texels_, in.phase_table);
        show(kernel.profile_table, profile_texels_, in.profile_table);
        return kernel;
    }

private:
    /// Texels of a CPU texture have four channels.
    template <class Sampler>
    static void show(Sampler& sampler, std::vector<real>& rgba, const std::vector<float>& texels) {
        rgba.assign(std::max<std::size_t>(4 * texels.size(), 4), real(0));
        for (std::size_t i = 0; i < texels.size(); ++i) rgba[4 * i] = static_cast<real>(texels[i]);
        sampler.texels = rgba.data();
        sampler.width = texels.empty() ? 1 : detail::table_width;
        sampler.height = static_cast<int>(texels.size()) / sampler.width;
    }
    template <class To, class From>
    static To widened(const From& block) {
        constexpr std::size_t count = sizeof(From) / sizeof(float);
        static_assert(sizeof(To) == count * sizeof(real));
        std::array<float, count> floats;
        std::memcpy(floats.data(), &block, sizeof block);
        std::array<real, count> wide;
        for (std::size_t i = 0; i < count; ++i) wide[i] = static_cast<real>(floats[i]);
        To result;
        std::memcpy(static_cast<void*>(&result), wide.data(), sizeof result);
        return result;
    }

    std::array<rhi::CpuBinding, 20> bindings_{};
    rhi::CpuArguments arguments_{.specialization = {}, .bindings = bindings_, .push_constants = {}};
    std::vector<real> phase_texels_, profile_texels_;

public:
    Kernel<real> kernel{arguments_};
};

}  // namespace aureole::stability
