// Instructions, counted by callgrind: the program starts itself a second time below it.

#include "cases.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <sys/wait.h>

namespace fs = std::filesystem;

// callgrind finds it by its name: not inlined, not copied.
extern "C" [[gnu::noinline]] void counted_work(const std::function<void()>* work) {
    (*work)();
    asm volatile("" ::: "memory");  // a call, and no jump at the end
}

void counted(const std::function<void()>& work) { counted_work(&work); }

Counts count_instructions() {
    std::string folder = (fs::temp_directory_path() / "timestep_count_XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) return {{}, "there is no folder for temporary files"};
    std::string command =
        "valgrind --tool=callgrind --toggle-collect=counted_work --dump-after=counted_work"
        " --combine-dumps=yes '--callgrind-out-file=" +
        folder + "/counts' '" + fs::read_symlink("/proc/self/exe").string() + "' --counted 2>&1";
    FILE* const said = popen(command.c_str(), "r");
    std::string last;
    for (char line[1000]; said != nullptr && std::fgets(line, sizeof line, said) != nullptr;) last = line;
    const int status = said == nullptr ? -1 : pclose(said);
    Counts counts;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        counts.failure = "valgrind is not installed (package valgrind)";
    else if (status != 0)  // an older valgrind does not know every instruction of a new processor
        counts.failure = "valgrind failed: " + last.substr(0, last.find('\n'));
    std::ifstream file(folder + "/counts");
    // One dump a call; the last one is of the rest.
    for (std::string line; counts.failure.empty() && std::getline(file, line);)
        if (line.starts_with("totals: ")) counts.instructions.push_back(std::strtod(line.c_str() + 8, nullptr));
    if (!counts.instructions.empty()) counts.instructions.pop_back();
    fs::remove_all(folder);
    return counts;
}
