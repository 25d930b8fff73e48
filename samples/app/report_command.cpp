#include "app/commands.h"
#include "io/file.h"
#include "io/json_file.h"
#include "report/report.h"

#include <cstdio>
#include <memory>

namespace aureole::app {
namespace {

struct ReportCommand {
    std::filesystem::path measurements, folder, markdown, overview;
    bool no_html = false;
};

/// The lines between two comments of a page are what the report says now.
void replace_overview(const std::filesystem::path& page, const std::string& tables) {
    constexpr std::string_view begin = "<!-- at a glance: written by `aureole report --overview` -->\n",
                               end = "<!-- end of it -->";
    std::string text = read_text(page);
    const std::size_t from = text.find(begin), to = text.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from)
        throw Error(ErrorCode::invalid_argument, "--overview", page.string(),
                    "a page with the lines \"" + std::string(begin.substr(0, begin.size() - 1)) + "\" and \"" +
                        std::string(end) + "\"");
    text.replace(from + begin.size(), to - from - begin.size(), tables);
    write_text(page, text);
    std::printf("%s\n", page.string().c_str());
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (!std::filesystem::is_directory(folder))
        throw Error(ErrorCode::io, "--output: " + folder.string() + " is no folder and cannot be made one");
}

void write(const std::filesystem::path& path, const std::string& text) {
    write_text(path, text);
    std::printf("%s\n", path.string().c_str());
}

void run_report(const ReportCommand& command) {
    if (command.folder.empty() && command.markdown.empty() && command.overview.empty())
        throw Error(ErrorCode::invalid_argument, "--output: is missing; give it, --markdown or --overview");
    const nlohmann::json measurements = read_json(command.measurements);
    const std::string source = command.measurements.string();
    const std::string tables = markdown_tables(measurements, source);
    if (!command.folder.empty()) {
        const std::string lines = csv_lines(measurements, source);
        const std::string page = command.no_html ? std::string() : html_page(measurements, source);
        make_folder(command.folder);
        if (!command.no_html) write(command.folder / "report.html", page);
        write(command.folder / "results.csv", lines);
        write(command.folder / "tables.md", tables);
    }
    if (!command.markdown.empty()) write(command.markdown, tables);
    if (!command.overview.empty()) replace_overview(command.overview, markdown_overview(measurements, source));
}

}  // namespace

void add_report_command(CLI::App& program) {
    auto options = std::make_shared<ReportCommand>();
    CLI::App* command = program.add_subcommand(
        "report",
        "What was measured, for people: report.html (one page with charts that opens from a disk, without a network), "
        "results.csv (a line for each result, errors as fractions) and tables.md (for each class of scenes: errors and costs, "
        "what the errors are made of, what each simplification costs)");
    command->add_option("MEASUREMENTS.json", options->measurements, "The measurements, as JSON")->required();
    command->add_option("-o,--output", options->folder, "Folder for the three; made if there is none");
    command->add_option("--markdown", options->markdown, "Also, or only, write the tables to this file");
    command->add_option("--overview", options->overview,
                        "Also, or only, replace the tables at a glance in this page, between its two comments");
    command->add_flag("--no-html", options->no_html, "Leave out the page, which a program built without npm does not have");
    command->callback([options] { run_report(*options); });
}

}  // namespace aureole::app
