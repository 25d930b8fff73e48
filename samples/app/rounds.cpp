#include "app/rounds.h"

#include <algorithm>

namespace aureole::app {
namespace {

constexpr std::string_view traced = "reference";
constexpr int paths_of_land = 4;  // in each round

}  // namespace

std::optional<Rounds> rounds_of(const SceneModel& model, std::uint32_t width, std::uint32_t height, std::uint32_t samples,
                                bool land) {
    if (model.name != traced) return std::nullopt;
    Rounds rounds{models::ReferenceSettings::by_name(model.quality)};
    const int of_picture = 4 * rounds.settings.paths_per_frame;
    const int pixels = static_cast<int>(samples * samples), paths = (of_picture + pixels - 1) / pixels;
    rounds.settings.paths_per_frame = land ? std::min(paths_of_land, paths) : 1;
    if (!land) {
        rounds.settings.film_width = width * samples;
        rounds.settings.film_height = height * samples;
        rounds.settings.max_paths = paths;
    }
    const int each = rounds.settings.paths_per_frame;
    rounds.count = static_cast<std::uint32_t>((paths + each - 1) / each);
    return rounds;
}

ModelPtr metering_model(const SceneModel& model) {
    if (model.name != traced) return model.make();
    models::ReferenceSettings settings = models::ReferenceSettings::by_name("low");
    settings.first_order_parts = 2;
    return model.in_its_colours(models::reference(settings));
}

}  // namespace aureole::app
