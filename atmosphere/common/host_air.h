// The kernels' formulas bound to one packed atmosphere, in double: the host's way to ask what the shaders compute.
#pragma once

#include "common/formulas.h"
#include "common/pack_atmosphere.h"

#include <array>
#include <vector>

namespace aureole::detail {

class HostAir {
public:
    explicit HostAir(const ExactAtmosphere& air);
    HostAir(const HostAir&) = delete;  // the formulas point into this object
    HostAir& operator=(const HostAir&) = delete;

    [[nodiscard]] kernels::AirFormulas<double>& formulas() { return formulas_; }
    /// Value of phase function c.
    [[nodiscard]] double phase(int c, double cos_theta) {
        return formulas_.phase_function(formulas_.phase_kind(c), formulas_.atm.phase_parameters[c], cos_theta);
    }

private:
    std::vector<double> phase_texels_, profile_texels_;
    std::array<rhi::CpuBinding, 3> bindings_;
    std::array<rhi::Specialization, 5> specialization_;
    rhi::CpuArguments arguments_;
    kernels::AirFormulas<double> formulas_;
};

}  // namespace aureole::detail
