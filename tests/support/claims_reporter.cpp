// Lists the tests by the claims of the talks that they are tagged with:
//
//     timestep_tests --list-tests --reporter claims
//
// prints, for every such tag, a line  row<TAB>test<TAB>file<TAB>line.  The site's page of the talks
// is made from it. It says nothing of a run's results: for those use any other reporter.

#include <catch2/catch_test_case_info.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <catch2/reporters/catch_reporter_streaming_base.hpp>

#include <cctype>
#include <ostream>
#include <string>
#include <vector>

namespace {

class ClaimsReporter : public Catch::StreamingReporterBase {
public:
    using StreamingReporterBase::StreamingReporterBase;

    static std::string getDescription() { return "Lists tests by claim: row, test, file, line (with --list-tests)"; }

    void listTests(const std::vector<Catch::TestCaseHandle>& tests) override {
        for (const Catch::TestCaseHandle& test : tests) {
            const Catch::TestCaseInfo& info = test.getTestCaseInfo();
            for (const Catch::Tag& tag : info.tags) {
                const std::string row(tag.original.data(), tag.original.size());
                if (is_row(row)) {
                    m_stream << row << '\t' << info.name << '\t' << info.lineInfo.file << '\t' << info.lineInfo.line
                             << '\n';
                }
            }
        }
        m_stream.flush();
    }

private:
    /// N or I and two digits, as in [N22].
    static bool is_row(const std::string& tag) {
        const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(tag[i])) != 0; };
        return tag.size() == 3 && (tag[0] == 'N' || tag[0] == 'I') && digit(1) && digit(2);
    }
};

}  // namespace

CATCH_REGISTER_REPORTER("claims", ClaimsReporter)
