// The largest error over many cases, by name of what is checked, with the case that has it.
#pragma once

#include "stability/cases.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <string>

namespace aureole::stability {

/// Errors in units of what is allowed: 1 is the bound.
class Ledger {
public:
    explicit Ledger(std::string title) : title_(std::move(title)) {}

    /// A number that is none counts as infinite.
    void add(const std::string& what, const Case& c, double error) {
        Entry& entry = worst_[what];
        ++entry.count;
        if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
        if (error > 1) ++entry.failed;
        if (error > 1 && std::getenv("AUREOLE_STABILITY_PRINT") != nullptr)
            std::printf("%s: %s: %.3g of its bound, case %llu\n", title_.c_str(), what.c_str(), error,
                        static_cast<unsigned long long>(c.index()));
        if (entry.count > 1 && !(error > entry.error)) return;
        entry.error = error;
        entry.index = c.index();
    }
    /// Yes is 0, no is 2.
    void check(const std::string& what, const Case& c, bool holds) { add(what, c, holds ? 0 : 2); }

    /// Every one within its bound. With AUREOLE_STABILITY_PRINT set: prints all.
    void verify() const {
        const bool print = std::getenv("AUREOLE_STABILITY_PRINT") != nullptr;
        CHECK(!worst_.empty());
        for (const auto& one : worst_) {
            const auto& what = one.first;
            const auto& entry = one.second;
            if (print)
                std::printf("%s: %s: %.3g of its bound, case %llu, of %llu\n", title_.c_str(), what.c_str(), entry.error,
                            static_cast<unsigned long long>(entry.index), static_cast<unsigned long long>(entry.count));
            CHECK_MESSAGE(entry.error <= 1, title_ << ": " << what << ": " << entry.error << " of its bound, " << entry.failed
                                                   << " fail; the worst: " << Case(entry.index).text());
        }
    }

    /// Of a case that is known to fail: this one is more than its bound, but no more than `most` times it, and all else is
    /// within.
    void verify_known(const std::string& known, double most) const {
        REQUIRE(worst_.contains(known));
        for (const auto& one : worst_) {
            const auto& what = one.first;
            const auto& entry = one.second;
            INFO(title_ << ": " << what << ": " << entry.error << " of its bound. " << Case(entry.index).text());
            CHECK(entry.error <= (what == known ? most : 1));
            if (what == known)
                CHECK_MESSAGE(entry.error > 1, "It holds now: take it from the known ones, here and in stability.md");
        }
    }

    /// The same where it is not one check alone that fails.
    void verify_known(double most) const {
        double worst = 0;
        for (const auto& one : worst_) {
            const auto& what = one.first;
            const auto& entry = one.second;
            INFO(title_ << ": " << what << ": " << entry.error << " of its bound. " << Case(entry.index).text());
            CHECK(entry.error <= most);
            worst = std::max(worst, entry.error);
        }
        CHECK_MESSAGE(worst > 1, "It holds now: take it from the known ones, here and in stability.md");
    }

private:
    struct Entry {
        double error = 0;
        std::uint64_t index = 0, count = 0, failed = 0;
    };
    std::string title_;
    std::map<std::string, Entry> worst_;
};

}  // namespace aureole::stability
