// A debug context without a window, for the adapter's tests.
#pragma once

#include <memory>
#include <string>

namespace aureole::gl::test {

class TestContext {
public:
    TestContext() = default;
    virtual ~TestContext() = default;
    TestContext(const TestContext&) = delete;
    TestContext& operator=(const TestContext&) = delete;

    /// Errors and undefined behaviour that the driver has told of since the last call, a line each.
    [[nodiscard]] virtual std::string take_messages() = 0;
};

/// A core context of version 4.3 (or what the driver gives for it), current in this thread until it goes. Null where there is
/// none, and says that the test is skipped.
[[nodiscard]] std::unique_ptr<TestContext> open_context();

}  // namespace aureole::gl::test
