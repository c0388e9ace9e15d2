// Hands each property's outcome to the session, and prints nothing: what a learner reads of a
// verdict is not Catch2's to say.

#include <catch2/catch_test_case_info.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <catch2/reporters/catch_reporter_streaming_base.hpp>

#include "session.hpp"

namespace {

class VerdictReporter : public Catch::StreamingReporterBase {
public:
    using StreamingReporterBase::StreamingReporterBase;
    static std::string getDescription() { return "Hands outcomes to the checker, prints nothing"; }
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        checker::session().looked_at(stats.testInfo->name, stats.totals.testCases.allOk());
    }
};

}  // namespace

CATCH_REGISTER_REPORTER("verdict", VerdictReporter)
