// The kernel language, C++ side: gives the words of prelude.glsl their meaning on the CPU, for real = float and double.
//
// A kernel file is included in the body of a class template (`AUREOLE_DEFINE_CPU_KERNEL`): its functions become members, its
// resources become members bound when a range of invocations starts, its specialization constants likewise.
#pragma once

#include <aureole/rhi/shader.h>
#include <aureole/rhi/texel.h>

#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/ext/matrix_double4x4.hpp>
#include <glm/ext/matrix_float4x4.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <type_traits>

namespace aureole::rhi::kernel {

template <class real>
struct SampledTexture {
    const real* texels = nullptr;
    int width = 1, height = 1, depth = 1;
    bool linear = true;
    Address address[3] = {Address::clamp, Address::clamp, Address::clamp};
    CpuCounts* counts = nullptr;

    [[nodiscard]] glm::vec<4, real> fetch(int x, int y, int z) const {
        const real* t = texels + 4 * ((static_cast<std::ptrdiff_t>(z) * height + y) * width + x);
        return {t[0], t[1], t[2], t[3]};
    }
};
template <class real>
struct Sampler2D : SampledTexture<real> {};
template <class real>
struct Sampler3D : SampledTexture<real> {};
template <class real>
struct SamplerCube : SampledTexture<real> {};

template <class real>
struct StorageImage {
    real* texels = nullptr;
    int width = 1, height = 1, depth = 1;
    Format format = Format::undefined;
    bool exact = false;
    CpuCounts* counts = nullptr;

    void store(int x, int y, int z, const glm::vec<4, real>& value) const {
        if (x < 0 || y < 0 || z < 0 || x >= width || y >= height || z >= depth) return;  // as on a GPU: dropped
        if (counts) ++counts->stores, counts->bytes += bytes_per_texel(format);
        real* t = texels + 4 * ((static_cast<std::ptrdiff_t>(z) * height + y) * width + x);
        for (int i = 0; i < 4; ++i) t[i] = value[i];
        if (exact)
            confine(format, t);
        else
            quantize(format, t);
    }
};
template <class real>
struct Image2D : StorageImage<real> {};
template <class real>
struct Image3D : StorageImage<real> {};
template <class real>
struct ImageCube : StorageImage<real> {};

/// The two texels and the weight along one axis. Texel centres are at (i + 1/2) / size.
template <class real>
struct Taps {
    int a, b;
    real w;
};
template <class real>
inline int wrap(int i, int size, Address address) {
    if (address == Address::repeat) return ((i % size) + size) % size;
    return i < 0 ? 0 : (i >= size ? size - 1 : i);
}
template <class real>
inline Taps<real> taps(real u, int size, bool linear, Address address) {
    // A NaN or huge coordinate must not become a wild index.
    const real limit = real(1 << 24);
    real x = u * real(size);
    x = x > -limit ? (x < limit ? x : limit) : -limit;
    if (!linear) {
        const int i = wrap<real>(static_cast<int>(std::floor(x)), size, address);
        return {i, i, real(0)};
    }
    x -= real(0.5);
    const real f = std::floor(x);
    const int i = static_cast<int>(f);
    return {wrap<real>(i, size, address), wrap<real>(i + 1, size, address), x - f};
}

template <class real>
inline glm::vec<4, real> SAMPLE(const Sampler2D<real>& s, const glm::vec<2, real>& uv) {
    if (s.counts) ++s.counts->samples;
    const auto x = taps(uv.x, s.width, s.linear, s.address[0]);
    const auto y = taps(uv.y, s.height, s.linear, s.address[1]);
    return glm::mix(glm::mix(s.fetch(x.a, y.a, 0), s.fetch(x.b, y.a, 0), x.w),
                    glm::mix(s.fetch(x.a, y.b, 0), s.fetch(x.b, y.b, 0), x.w), y.w);
}
template <class real>
inline glm::vec<4, real> SAMPLE(const Sampler3D<real>& s, const glm::vec<3, real>& uvw) {
    if (s.counts) ++s.counts->samples;
    const auto x = taps(uvw.x, s.width, s.linear, s.address[0]);
    const auto y = taps(uvw.y, s.height, s.linear, s.address[1]);
    const auto z = taps(uvw.z, s.depth, s.linear, s.address[2]);
    const auto slice = [&](int k) {
        return glm::mix(glm::mix(s.fetch(x.a, y.a, k), s.fetch(x.b, y.a, k), x.w),
                        glm::mix(s.fetch(x.a, y.b, k), s.fetch(x.b, y.b, k), x.w), y.w);
    };
    return glm::mix(slice(z.a), slice(z.b), z.w);
}
/// Where a direction meets a cube: faces +x -x +y -y +z -z, with the face coordinates of the graphics APIs in [0, 1].
template <class real>
struct CubePlace {
    int face;
    real u, v;
};
template <class real>
inline CubePlace<real> cube_place(const glm::vec<3, real>& d) {
    const real ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
    // Kept within the face also where rounding, or a direction that is none, would leave it.
    const auto to_unit = [](real c, real major) {
        const real u = (c / major + real(1)) / real(2);
        return u > real(0) ? (u < real(1) ? u : real(1)) : real(0);
    };
    if (ax >= ay && ax >= az) return {d.x >= 0 ? 0 : 1, to_unit(d.x >= 0 ? -d.z : d.z, ax), to_unit(-d.y, ax)};
    if (ay >= az) return {d.y >= 0 ? 2 : 3, to_unit(d.x, ay), to_unit(d.y >= 0 ? d.z : -d.z, ay)};
    return {d.z >= 0 ? 4 : 5, to_unit(d.z >= 0 ? d.x : -d.x, az), to_unit(-d.y, az)};
}
/// The other way: (s, t) in [-1, 1] on the face, and beyond it in the face's plane.
inline glm::dvec3 cube_direction(int face, double s, double t) {
    const glm::dvec3 directions[6] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    return directions[face];
}
/// A texel that may lie one step outside of its face: then the one behind the edge. Behind a corner there is none: there stands
/// the mean of the three texels that meet. In double, for the places are close to the borders of the largest textures' texels.
template <class real>
inline glm::vec<4, real> fetch_seamless(const SamplerCube<real>& s, int face, int x, int y) {
    const int last = s.width - 1;
    const bool out_x = x < 0 || x > last, out_y = y < 0 || y > last;
    if (!out_x && !out_y) return s.fetch(x, y, face);
    if (out_x && out_y) {
        const int inner_x = x < 0 ? 0 : last, inner_y = y < 0 ? 0 : last;
        return (s.fetch(inner_x, inner_y, face) + fetch_seamless(s, face, x, inner_y) + fetch_seamless(s, face, inner_x, y)) /
               real(3);
    }
    const auto centre = [&](int i) { return (2.0 * i + 1) / s.width - 1; };
    const CubePlace<double> place = cube_place(cube_direction(face, centre(x), centre(y)));
    const auto texel = [&](double u) { return taps(u, s.width, false, Address::clamp).a; };
    return s.fetch(texel(place.u), texel(place.v), place.face);
}
/// Filters across the edges of faces, as GPUs do.
template <class real>
inline glm::vec<4, real> SAMPLE(const SamplerCube<real>& s, const glm::vec<3, real>& d) {
    if (s.counts) ++s.counts->samples;
    const CubePlace<real> place = cube_place(d);
    if (!s.linear)
        return s.fetch(taps(place.u, s.width, false, Address::clamp).a, taps(place.v, s.height, false, Address::clamp).a,
                       place.face);
    const real x = place.u * real(s.width) - real(0.5), y = place.v * real(s.height) - real(0.5);
    const real fx = std::floor(x), fy = std::floor(y);
    const int i = static_cast<int>(fx), j = static_cast<int>(fy);
    const auto row = [&](int k) {
        return glm::mix(fetch_seamless(s, place.face, i, k), fetch_seamless(s, place.face, i + 1, k), x - fx);
    };
    return glm::mix(row(j), row(j + 1), y - fy);
}

/// Out-of-range fetches return 0, as robust GPU access does.
template <class real>
inline glm::vec<4, real> texelFetch(const Sampler2D<real>& s, const glm::ivec2& p, int) {
    if (s.counts) ++s.counts->fetches;
    if (p.x < 0 || p.y < 0 || p.x >= s.width || p.y >= s.height) return glm::vec<4, real>(real(0));
    return s.fetch(p.x, p.y, 0);
}
template <class real>
inline glm::vec<4, real> texelFetch(const Sampler3D<real>& s, const glm::ivec3& p, int) {
    if (s.counts) ++s.counts->fetches;
    if (p.x < 0 || p.y < 0 || p.z < 0 || p.x >= s.width || p.y >= s.height || p.z >= s.depth) return glm::vec<4, real>(real(0));
    return s.fetch(p.x, p.y, p.z);
}
template <class real>
inline glm::ivec2 textureSize(const Sampler2D<real>& s, int) {
    return {s.width, s.height};
}
template <class real>
inline glm::ivec3 textureSize(const Sampler3D<real>& s, int) {
    return {s.width, s.height, s.depth};
}
template <class real>
inline glm::ivec2 textureSize(const SamplerCube<real>& s, int) {
    return {s.width, s.height};
}

template <class real>
inline void imageStore(const Image2D<real>& i, const glm::ivec2& p, const glm::vec<4, real>& v) {
    i.store(p.x, p.y, 0, v);
}
template <class real>
inline void imageStore(const Image3D<real>& i, const glm::ivec3& p, const glm::vec<4, real>& v) {
    i.store(p.x, p.y, p.z, v);
}
template <class real>
inline void imageStore(const ImageCube<real>& i, const glm::ivec3& p, const glm::vec<4, real>& v) {
    i.store(p.x, p.y, p.z, v);
}
template <class real>
inline glm::ivec2 imageSize(const Image2D<real>& i) {
    return {i.width, i.height};
}
template <class real>
inline glm::ivec3 imageSize(const Image3D<real>& i) {
    return {i.width, i.height, i.depth};
}
template <class real>
inline glm::ivec3 imageSize(const ImageCube<real>& i) {
    return {i.width, i.height, 6};
}

/// Base of every kernel class: hands out the resources that the kernel's members are initialized with.
template <class real>
struct Context {
    const CpuArguments* arguments_ = nullptr;

    explicit Context(const CpuArguments& arguments) : arguments_(&arguments) {}

    void count_(int evaluations) const {
        if (arguments_->counts) arguments_->counts->evaluations += static_cast<std::uint64_t>(evaluations);
    }

    template <class T>
    [[nodiscard]] T specialization(std::uint32_t id, T fallback) const {
        for (const Specialization& s : arguments_->specialization) {
            if (s.id != id) continue;
            if constexpr (std::is_same_v<T, bool>)
                return s.bits != 0;
            else if constexpr (std::is_same_v<T, int>)
                return static_cast<int>(s.bits);
            else {
                float f;
                std::memcpy(&f, &s.bits, sizeof f);
                return static_cast<T>(f);
            }
        }
        return fallback;
    }
    template <class T>
    [[nodiscard]] T sampled(std::uint32_t slot) const {
        const CpuBinding& b = arguments_->bindings[slot];
        T t;
        t.texels = static_cast<const real*>(b.texels);
        t.width = static_cast<int>(b.extent.width), t.height = static_cast<int>(b.extent.height);
        t.depth = static_cast<int>(b.extent.depth), t.linear = b.filter == Filter::linear;
        t.address[0] = b.address_u, t.address[1] = b.address_v, t.address[2] = b.address_w;
        t.counts = arguments_->counts;
        return t;
    }
    template <class T>
    [[nodiscard]] T storage(std::uint32_t slot) const {
        const CpuBinding& b = arguments_->bindings[slot];
        T t;
        t.texels = static_cast<real*>(b.texels);
        t.width = static_cast<int>(b.extent.width), t.height = static_cast<int>(b.extent.height);
        t.depth = static_cast<int>(b.extent.depth), t.format = b.format, t.exact = b.exact;
        t.counts = arguments_->counts;
        return t;
    }
    /// Uniform data is an array of 32-bit floats; the kernel sees it in its own precision.
    template <class T>
    [[nodiscard]] static T widen(const std::byte* bytes, std::uint64_t size) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(real) == 0);
        T block{};
        real values[sizeof(T) / sizeof(real)] = {};
        for (std::size_t i = 0; i < sizeof(T) / sizeof(real) && (i + 1) * sizeof(float) <= size; ++i) {
            float f;
            std::memcpy(&f, bytes + i * sizeof(float), sizeof f);
            values[i] = static_cast<real>(f);
        }
        std::memcpy(static_cast<void*>(&block), values, sizeof block);
        return block;
    }
    template <class T>
    [[nodiscard]] T uniforms(std::uint32_t slot) const {
        const CpuBinding& b = arguments_->bindings[slot];
        return widen<T>(b.constants, b.constants_size);
    }
    template <class T>
    [[nodiscard]] T pushed() const {
        return widen<T>(arguments_->push_constants.data(), arguments_->push_constants.size());
    }
};

template <template <class> class Kernel, class real>
void run(const CpuArguments& arguments, const CpuRange& range, const CpuBinding* target) {
    Kernel<real> kernel(arguments);
    for (std::uint32_t z = range.begin[2]; z < range.end[2]; ++z)
        for (std::uint32_t y = range.begin[1]; y < range.end[1]; ++y)
            for (std::uint32_t x = range.begin[0]; x < range.end[0]; ++x) {
                const glm::ivec3 id(x, y, z);
                if constexpr (requires { kernel.kernel_main(glm::ivec2(id)).x; }) {
                    StorageImage<real> image;
                    image.texels = static_cast<real*>(target->texels);
                    image.width = static_cast<int>(target->extent.width);
                    image.height = static_cast<int>(target->extent.height);
                    image.format = target->format, image.exact = target->exact;
                    image.counts = arguments.counts;
                    image.store(id.x, id.y, 0, kernel.kernel_main(glm::ivec2(id)));
                } else {
                    kernel.kernel_main(id);
                }
            }
}

}  // namespace aureole::rhi::kernel

// Scalar functions of GLSL for the kernels' namespace; those on vectors are found by argument.
namespace aureole::kernels {
using glm::abs, glm::acos, glm::asin, glm::atan, glm::ceil, glm::clamp, glm::cos, glm::exp, glm::exp2, glm::floor, glm::fract,
    glm::inversesqrt, glm::log, glm::log2, glm::max, glm::min, glm::mix, glm::mod, glm::pow, glm::sign, glm::sin,
    glm::smoothstep, glm::sqrt, glm::step, glm::tan;
}  // namespace aureole::kernels

#define OUT(T) T&
#define INOUT(T) T&
#define CONST(T, NAME, VALUE) static constexpr T NAME = VALUE;
#define COUNT(n) this->count_(n)
#define UNROLL
#define LOCAL_ARRAY(T, name, SIZE, MAX) T name[MAX];
#define SPEC_INT(id, NAME, VALUE) int NAME = this->template specialization<int>(id, VALUE);
#define SPEC_BOOL(id, NAME, VALUE) bool NAME = this->template specialization<bool>(id, VALUE);
#define SPEC_REAL(id, NAME, VALUE) real NAME = this->template specialization<real>(id, real(VALUE));
#define SAMPLER_2D(slot, name) \
    ::aureole::rhi::kernel::Sampler2D<real> name = this->template sampled<::aureole::rhi::kernel::Sampler2D<real>>(slot);
#define SAMPLER_3D(slot, name) \
    ::aureole::rhi::kernel::Sampler3D<real> name = this->template sampled<::aureole::rhi::kernel::Sampler3D<real>>(slot);
#define SAMPLER_CUBE(slot, name) \
    ::aureole::rhi::kernel::SamplerCube<real> name = this->template sampled<::aureole::rhi::kernel::SamplerCube<real>>(slot);
#define IMAGE_2D(slot, name) \
    ::aureole::rhi::kernel::Image2D<real> name = this->template storage<::aureole::rhi::kernel::Image2D<real>>(slot);
#define IMAGE_3D(slot, name) \
    ::aureole::rhi::kernel::Image3D<real> name = this->template storage<::aureole::rhi::kernel::Image3D<real>>(slot);
#define IMAGE_CUBE(slot, name) \
    ::aureole::rhi::kernel::ImageCube<real> name = this->template storage<::aureole::rhi::kernel::ImageCube<real>>(slot);
#define UNIFORMS(slot, Block, name) Block name = this->template uniforms<Block>(slot);
#define PUSH_CONSTANTS(Block, name) Block name = this->template pushed<Block>();
#define LOCAL_SIZE(x, y, z)
#define COMPUTE_MAIN(id) void kernel_main(const ivec3& id)
#define FRAGMENT_MAIN(pixel) vec4 kernel_main(const ivec2& pixel)

/// First line of a kernel's class body: the type names of GLSL.
#define AUREOLE_KERNEL_TYPES           \
    using vec2 = glm::vec<2, real>;    \
    using vec3 = glm::vec<3, real>;    \
    using vec4 = glm::vec<4, real>;    \
    using mat3 = glm::mat<3, 3, real>; \
    using mat4 = glm::mat<4, 4, real>; \
    using ivec2 = glm::ivec2;          \
    using ivec3 = glm::ivec3;          \
    using ivec4 = glm::ivec4;          \
    using uint = std::uint32_t;
/// Opens the class template of a kernel; close it with `};` after including the kernel file.
#define AUREOLE_DEFINE_CPU_KERNEL(Name)                       \
    template <class real>                                     \
    struct Name : ::aureole::rhi::kernel::Context<real> {     \
        using ::aureole::rhi::kernel::Context<real>::Context; \
        AUREOLE_KERNEL_TYPES
/// Both precisions of a kernel as an entry of a Shader.
#define AUREOLE_CPU_ENTRY(Name) \
    ::aureole::rhi::CpuEntry { &::aureole::rhi::kernel::run<Name, float>, &::aureole::rhi::kernel::run<Name, double> }
