#include "verdict.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <random>
#include <sstream>

#include <sys/prctl.h>

#include "../checker/finding_json.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "sandbox.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

// How to compile and link, as the build wrote it.
struct Commands {
    Words compile, bare, sanitize, lists, link;
    std::string check, worker_object, worker_library;
};

Commands read_commands(const Exercise& exercise) {
    const fs::path file = paths().build / "exercises/commands.json";
    try {
        const auto json = nlohmann::json::parse(contents(file));
        return {json.at(exercise.eigen ? "compile_eigen" : "compile"),
                json.at(exercise.eigen ? "bare_eigen" : "bare"),
                json.at("sanitize"),
                json.at("lists"),
                json.at("link"),
                json.at("checks").at(exercise.name),
                json.at("workers").at(exercise.name),
                json.at("worker")};
    } catch (const nlohmann::json::exception&) {
        throw Stop(Status::missing,
                   file.string() + " is damaged; delete the folder build, and ./course will make it again");
    }
}

void put_before(Words& words, const Words& others) { words.insert(words.begin(), others.begin(), others.end()); }

// These words may be the learner's, so bubblewrap is asked again.
void stop_if_broken(const Words& around, const std::string& said) {
    if (around.empty() || !said.starts_with("bwrap: ")) return;
    const std::string fault = Sandbox::fault_of(around);
    if (!fault.empty()) throw Stop(Status::missing, fault);
}

void stop_if_full(const fs::path& folder) {
    try {
        write_whole(folder / "room", std::string(4 << 20, ' '));
    } catch (const Stop&) {
        throw Stop(Status::bad_use, paths().build.string() + ": no space left on the device");
    }
}

// The name of the signal that ended the compiler or one of its programs. The driver prints a line about the latter:
// "c++: fatal error: Killed signal terminated program cc1plus".
std::string ended_by(const Outcome& outcome) {
    if (outcome.status == 0) return "";
    if (outcome.status > 128) return strsignal(outcome.status - 128);
    const std::string& said = outcome.said;
    const auto end = said.rfind(" signal terminated program ");
    if (end == std::string::npos) return "";
    const auto before = said.rfind('\n', end);
    const auto begin = before == std::string::npos ? 0 : before + 1;
    const std::string line = said.substr(begin, end - begin);
    const auto name = line.find_first_of(": /");  // of a program, which is no place in the answer
    for (const std::string mark : {": fatal error: ", ": internal compiler error: "})
        if (name != std::string::npos && line.substr(name).starts_with(mark)) return line.substr(name + mark.size());
    return "";
}

// Runs the compiler; false if it refuses or is stopped.
bool succeeds(const Words& command, const TemporaryFolder& temporary, Verdict& verdict, int patience) {
    const int seconds = paths().compiler_seconds * patience;
    const Outcome outcome = run_within(
        command, {10. * seconds, 4096, 64, 64, temporary.folder().string(), seconds, "Waiting for the compiler"});
    // The words may be the answer's own, so the disk is tried, too.
    if (outcome.status != 0 && outcome.said.find("No space left on device") != std::string::npos)
        stop_if_full(temporary.folder());
    const std::string signal = ended_by(outcome);
    const bool too_much_work = signal == strsignal(SIGXCPU);
    // Killed: out of memory, or a template bomb.
    if (outcome.too_slow || !signal.empty()) verdict.in_time = false;
    if (outcome.too_slow || too_much_work)
        verdict.compiler += "The compiler had not come to an end after " +
                            std::to_string(too_much_work ? seconds : 10 * seconds) + " s" +
                            (too_much_work ? " of work" : "") + ".\n";
    if (signal == strsignal(SIGXFSZ)) verdict.compiler += "What the compiler makes of the file is larger than 64 MB.\n";
    if (!too_much_work) verdict.compiler += outcome.said;  // "Please submit a full bug report"
    return outcome.status == 0 && !outcome.too_slow;
}

// The innermost line of the learner's file among the addresses of a crash; 0 if there is none.
int line_of_crash(const std::string& trace, const Words& around, const fs::path& worker, const fs::path& file) {
    if (trace.empty()) return 0;
    Words command{"addr2line", "-i", "-e", worker.string()};
    put_before(command, around);  // a stranger may have written what it reads
    std::istringstream addresses(trace);
    for (std::string address; addresses >> address;) command.push_back(address);
    std::istringstream places(run_within(command, {.seconds = 60, .megabytes = 512, .processor_seconds = 5}).said);
    for (std::string place; std::getline(places, place);)
        if (place.starts_with(file.string() + ":")) return std::atoi(place.c_str() + file.string().size() + 1);
    return 0;
}

// Reads what the hidden tests' program printed: the verdict's kind and its finding. False if it is neither.
bool read_finding(const std::string& said, Verdict& verdict) {
    const auto json = nlohmann::json::parse(said, nullptr, false);
    if (!json.is_object() || !json.contains("kind")) return false;
    verdict.kind = json.at("kind");
    static_cast<checker::Finding&>(verdict) = json.at("finding");
    return true;
}

// Compiles the answer in `file`, or the course's own.
Words compiling(Words words, const Exercise& exercise, const fs::path& file, const fs::path& object) {
    words.insert(words.end(),
                 {"-include", exercise.declared().string(), "-x", "c++", "-c", file.string(), "-o", object.string()});
    return words;
}

Words linking(Words words, const Commands& commands, const fs::path& object, const fs::path& program) {
    words.insert(words.end(),
                 {object.string(), commands.worker_object, commands.worker_library, "-o", program.string()});
    return words;
}

// Called when an answer does not compile or link. If the stub that everybody starts with does not either, the answer is
// not at fault.
void stop_if_damaged(const Exercise& exercise, const Commands& commands, const Sandbox* sandbox,
                     const TemporaryFolder& temporary, bool links, int patience) {
    const fs::path object = temporary.folder() / "own.o";
    Verdict own;
    const auto works = [&](Words words) {
        if (sandbox != nullptr)
            put_before(words, sandbox->before_compiler(words, temporary.folder(), {exercise.declared()}));
        return succeeds(words, temporary, own, patience);
    };
    if (works(compiling(commands.compile, exercise, exercise.stub(), object)) &&
        (!links || works(linking(commands.link, commands, object, temporary.folder() / "own"))))
        return;
    throw Stop(Status::missing,
               "the compiler refuses the course's own file, so no answer was checked; delete the folder build, and "
               "./course will make it again. The compiler says: " +
                   own.compiler.substr(0, own.compiler.find('\n')));
}

// What the learner's code printed; nothing if it put something else in the file's place, which may be endless.
std::optional<std::string> printed_in(const fs::path& file) {
    std::error_code error;
    const auto type = fs::symlink_status(file, error).type();
    if (type == fs::file_type::not_found) return "";
    if (type != fs::file_type::regular) return {};
    return contents(file);
}

// The learner's code runs beside the hidden tests' program, and may end it or write in its place: what that program
// prints counts only if its exit status says the same.
bool meddled_with(const Outcome& outcome, const std::string& verdict) {
    if (outcome.too_slow) return false;
    if (outcome.status == 128 + SIGKILL || outcome.status == 128 + SIGTERM) return true;
    return outcome.status < 2 && outcome.status != (verdict == "pass" ? 0 : 1);
}

}  // namespace

std::uint64_t new_seed() {
    std::random_device random;
    return (static_cast<std::uint64_t>(random()) << 32) | random();
}

std::vector<fs::path> parts_of_check(const Exercise& exercise) {
    const Commands commands = read_commands(exercise);
    const char* const header = exercise.eigen ? "exercise_eigen.hpp" : "exercise.hpp";
    const fs::path ready = paths().build / "exercises/ready";
    const bool gnu = fs::exists(ready / header);  // clang++ needs no copy of it
    return {commands.check, commands.worker_object, commands.worker_library,
            ready / (header + std::string(gnu ? ".gch" : ".pch"))};
}

bool commands_are_whole(const Exercise& exercise) {
    try {
        read_commands(exercise);
        return true;
    } catch (const Stop&) {
        return false;
    }
}

Verdict check_file(const Exercise& exercise, const fs::path& given, std::uint64_t seed, const Manner& manner) {
    const auto& [sandbox, sanitizers, usual_patience] = manner;
    int patience = usual_patience;
    const auto begin = std::chrono::steady_clock::now();
    const std::string answer = answer_in(exercise, given);  // or one clear line
    const Commands commands = read_commands(exercise);
    const TemporaryFolder temporary;
    fs::path file = fs::canonical(given);
    if (sandbox != nullptr) {  // which does not see the submission's folder
        file = temporary.folder() / (exercise.name + ".cpp");
        write_whole(file, answer);
    }
    const fs::path object = temporary.folder() / "answer.o", worker = temporary.folder() / "worker",
                   printed = temporary.folder() / "printed.txt";

    Verdict verdict;
    verdict.seed = seed;
    const auto ended = [&](const std::string& kind) {
        verdict.kind = kind;
        replace_all(verdict.compiler, file.string(), shown(given));
        for (auto text : {&verdict.compiler, &verdict.printed, &verdict.detail}) *text = sanitized(*text);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        verdict.seconds = taken.count();
        return verdict;
    };

    Words compile = sanitizers ? commands.bare : commands.compile, link = commands.link;
    if (exercise.eigen || answer.find("Eigen") != std::string::npos)
        patience *= 2;              // its solvers take 5 to 9 s to compile, everything else about 2 s
    if (sanitizers) patience *= 3;  // nothing is precompiled
    if (sanitizers)
        for (Words* const words : {&compile, &link})
            words->insert(words->end(), commands.sanitize.begin(), commands.sanitize.end());
    compile = compiling(compile, exercise, file, object);
    for (std::string word : commands.lists) {  // lists what it reads
        replace_all(word, "@", object.string());
        compile.push_back(word);
    }
    Words around;
    if (sandbox != nullptr) around = sandbox->before_compiler(compile, temporary.folder(), {exercise.declared()});
    put_before(compile, around);
    const bool compiles = succeeds(compile, temporary, verdict, patience);
    if (!compiles) stop_if_broken(around, verdict.compiler);
    const std::string not_own = forbidden_include(object.string() + ".d", file);
    if (!compiles && not_own.empty() && !sanitizers)
        stop_if_damaged(exercise, commands, sandbox, temporary, false, patience);
    if (!not_own.empty()) verdict.compiler = not_own;
    if (!compiles || !not_own.empty()) return ended("does_not_compile");
    link = linking(link, commands, object, worker);
    if (sandbox != nullptr) put_before(link, sandbox->before_compiler(link, temporary.folder(), {}));
    if (!succeeds(link, temporary, verdict, patience)) {
        if (!sanitizers) stop_if_damaged(exercise, commands, sandbox, temporary, true, patience);
        return ended("does_not_compile");
    }

    // The learner's code must not reach our files through /proc: what we print is the verdict.
    prctl(PR_SET_DUMPABLE, 0);
    Words check{commands.check, exercise.name, worker.string(), printed.string()};
    if (sanitizers) check.push_back("sanitizers");
    around = sandbox != nullptr ? sandbox->before_worker(worker) : Words{};
    check.insert(check.end(), around.begin(), around.end());
    // That program limits the learner's code itself, and allows a few minutes by the clock for all calls.
    const Outcome outcome =
        run_within(check, {.seconds = 600, .processor_seconds = 60, .waiting_for = "Waiting for your code to answer"},
                   std::to_string(seed) + "\n");
    Verdict found;
    const bool is_found = read_finding(outcome.said, found);
    const auto text = printed_in(printed);
    verdict.printed = text.value_or("");
    stop_if_broken(around, verdict.printed);
    static_cast<checker::Finding&>(verdict) = found;
    if (found.kind != "wrong" && found.kind != "not_finite") verdict.property.clear();
    if (meddled_with(outcome, found.kind)) {
        verdict.detail = "The program ended the checker, or wrote in its place";
        verdict.arguments = "(…)";
        return ended("left_early");
    }
    if (!text) {
        verdict.detail = "The program replaced the file that holds what it prints";
        verdict.arguments = "(…)";
        return ended("left_early");
    }
    // The tests worked for a minute on the answer's results, where a second is long. That is the answer's fault.
    if (outcome.status == 128 + SIGXCPU) {
        verdict.detail = too_much_work_for_the_tests;
        verdict.in_time = false;
        return ended("too_slow");
    }
    if (outcome.status > 1 || !is_found) {
        verdict.detail = outcome.too_slow ? "the hidden tests did not come to an end" : outcome.said;
        return ended("course_error");
    }
    verdict.line = line_of_crash(verdict.trace, around, worker, file);
    if (found.kind == "too_slow") verdict.in_time = false;
    return ended(found.kind);
}

Verdict check_sanitized(const Exercise& exercise, const fs::path& file, std::uint64_t seed) {
    if (read_commands(exercise).sanitize.empty())
        throw Stop(Status::missing,
                   "check --sanitize: the compiler has no AddressSanitizer and no "
                   "UndefinedBehaviorSanitizer to link with");
    Verdict verdict = check_file(exercise, file, seed, {.sanitizers = true});
    for (const char* report : {"allocation-size-too-big", "rss-limit-exceeded", "out-of-memory"})
        if (verdict.kind == "crash" && verdict.printed.find(report) != std::string::npos)
            verdict.kind = "too_much_memory";
    if (verdict.kind != "too_slow") return verdict;
    // Under sanitizers everything takes many times as long. The usual check counts.
    verdict = check_file(exercise, file, seed);
    if (verdict.kind == "pass")
        verdict.remark = "The answer is right, but too slow to be watched: not all of it has been.";
    return verdict;
}

}  // namespace course
