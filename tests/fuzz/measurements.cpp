// What `aureole measure` has written, and the reports made of it.
#include "fuzz.h"

#include "io/json_file.h"
#include "report/report.h"

using namespace aureole;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::filesystem::path path = fuzz::file_of(data, size, "measurements.json");
    fuzz::accepts([&] {
        const nlohmann::json measurements = app::read_json(path);
        const bool read = fuzz::accepts([&] { (void)app::csv_lines(measurements); });
        const bool again = fuzz::accepts([&] { (void)app::markdown_tables(measurements); });
        fuzz::require(read == again, "reports agree about what can be read");
    });
    return 0;
}
