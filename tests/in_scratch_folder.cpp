// Compiled into a test program, lets its tests run in a folder of their own: whatever they write goes with it, wherever the
// program was started.
#include "scratch_folder.h"

#include <doctest/doctest.h>

#include <optional>

namespace {

struct InScratchFolder final : doctest::IReporter {
    explicit InScratchFolder(const doctest::ContextOptions&) {}

    void test_run_start() override {
        folder_.emplace();
        before_ = std::filesystem::current_path();
        std::filesystem::current_path(folder_->path());
    }
    void test_run_end(const doctest::TestRunStats&) override {
        std::filesystem::current_path(before_);
        folder_.reset();
    }

    void report_query(const doctest::QueryData&) override {}
    void test_case_start(const doctest::TestCaseData&) override {}
    void test_case_reenter(const doctest::TestCaseData&) override {}
    void test_case_end(const doctest::CurrentTestCaseStats&) override {}
    void test_case_exception(const doctest::TestCaseException&) override {}
    void subcase_start(const doctest::SubcaseSignature&) override {}
    void subcase_end() override {}
    void log_assert(const doctest::AssertData&) override {}
    void log_message(const doctest::MessageData&) override {}
    void test_case_skipped(const doctest::TestCaseData&) override {}

private:
    std::optional<aureole::ScratchFolder> folder_;
    std::filesystem::path before_;
};

DOCTEST_REGISTER_LISTENER("scratch folder", 1, InScratchFolder);

}  // namespace
