// How much a model has to do in one air beside another: what its settings for that air say, and no measurement does.
#pragma once

#include <aureole/model.h>

namespace aureole::detail {

/// Each in units of its own, of use as ratios between airs of the same setting; 1 where all airs take the same.
struct TableWork {
    double rebuild = 1;  ///< Tables of the air: more orders are followed where they fade slowly, more moments are kept and more
                         ///< directions looked into where phase functions are sharp.
    double view = 1;     ///< Tables of the camera: every node along a ray adds up those moments.
    double air_memory = 1, view_memory = 1, aerial_perspective_memory = 1;
    double composite = 1,
           light = 1;  ///< Columns of air are integrated for every pixel, or direction, by models without tables.
    [[nodiscard]] bool operator==(const TableWork&) const = default;
};

/// `model` as it makes its tables for `air`, which is valid.
[[nodiscard]] TableWork table_work(const Model& model, const AtmosphereParameters& air);

}  // namespace aureole::detail
