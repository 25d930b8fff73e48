// Suite files of `aureole measure`.
#include "fuzz.h"

#include "measure/suite.h"

using namespace aureole;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::accepts([&] {
        const app::Suite suite = app::parse_suite(fuzz::text_of(data, size), "suite.toml");
        for (const app::SuiteAir& air : suite.airs) fuzz::require(fuzz::accepts([&] { validate(air.parameters); }), "air");
        for (const app::SuiteScene& scene : suite.scenes) (void)suite.id(scene);
        for (const Setting& setting : suite.settings) (void)app::is_for(setting, suite.airs.front());
    });
    return 0;
}
