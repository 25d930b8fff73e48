// The models of the ladder with tables so small that thousands of skies are affordable.
#pragma once

#include <aureole/model.h>

#include <span>

namespace aureole::stability {

struct Rung {
    const char* name;
    ModelPtr model;
    bool scaled = true;  ///< The same in another unit: no length of its own.
    bool random = false;
};
/// Every model, those with settings that take other ways through their kernels more than once.
[[nodiscard]] std::span<const Rung> rungs();

}  // namespace aureole::stability
