// The page of the report, packed into the program by pack.py.
#pragma once

#include <string_view>

namespace aureole::app::report {

/// The page up to the data and from there on; both empty where the program was built without the libraries of its charts.
extern const std::string_view page_before_data, page_after_data;

}  // namespace aureole::app::report
