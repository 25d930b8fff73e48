// The models of the ladder with tables so small that thousands of skies are affordable.
#pragma once

#include <aureole/model.h>

#include <cstdint>
#include <span>
#include <vector>

namespace aureole::stability {

struct Rung {
    const char* name;
    ModelPtr model;
    bool scaled = true;  ///< The same in another unit: no length of its own.
    bool random = false;
};
/// Every model, those with settings that take other ways through their kernels more than once.
[[nodiscard]] std::span<const Rung> rungs();

/// Every model that keeps tables, with tables of this format and `finer` times as long along each side; and all the others.
[[nodiscard]] std::vector<Rung> stored_rungs(rhi::Format format, std::uint32_t finer = 1);
[[nodiscard]] std::vector<Rung> bare_rungs();
/// `aureole` and `bruneton`, floats, with directions enough for a haze: of two on a side of the horizon and its peaked phase
/// function all of the light that is scattered first may come out as less than nothing, in double too.
[[nodiscard]] std::vector<Rung> finely_gathered_rungs();
/// Models with one table, or all of one kind, as small as it may be, and 4096 wide or high (as long as `validate` lets it be),
/// floats.
[[nodiscard]] std::vector<Rung> extreme_rungs();

}  // namespace aureole::stability
