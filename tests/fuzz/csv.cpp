// Tables of numbers: as they are, as rows to probe, as the truth of a suite.
#include "fuzz.h"

#include "app/probe.h"
#include "io/csv.h"
#include "measure/truth.h"

#include <array>

using namespace aureole;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = fuzz::text_of(data, size);
    fuzz::accepts([&] {
        constexpr std::array<std::string_view, 2> columns{"altitude_km", "azimuth_deg"};
        const app::CsvTable table = app::parse_csv(text, "table.csv", columns);
        for (const std::vector<double>& column : table.columns)
            fuzz::require(column.size() == table.rows(), "columns are equally long");
    });
    const std::filesystem::path path = fuzz::file_of(data, size, "table.csv");
    fuzz::accepts([&] { (void)app::read_probe_rows(path); });
    fuzz::accepts([&] { (void)app::TruthTable::read(path, {{"air", "earth"}}); });
    return 0;
}
