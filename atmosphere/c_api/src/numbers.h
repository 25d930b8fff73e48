// Settings of models by number.
#pragma once

#include <aureole/c/atmosphere.h>
#include <aureole/setting.h>

#include <span>
#include <vector>

namespace aureole::c_api {

/// A model, and all its numbers: names are literals.
struct Numbers {
    ModelPtr model;
    std::vector<aureole_number> values;
};
/// The setting's model in its quality, but for these numbers. Throws Error(invalid_argument) for a name that there is not, what
/// is no number, and what is out of its range.
[[nodiscard]] Numbers make_by_numbers(const Setting& setting, std::span<const aureole_number> numbers);

}  // namespace aureole::c_api
