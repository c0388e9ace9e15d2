#include "count.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "process.hpp"
#include "stop.hpp"

namespace fs = std::filesystem;

// callgrind finds it by its name: not inlined, not copied.
extern "C" [[gnu::noinline]] void bench_counted_work(const std::function<void()>* work) {
    (*work)();
    asm volatile("" ::: "memory");  // a call, and no jump at the end
}

namespace bench {

namespace {

// A folder for what callgrind writes, gone with it.
class Folder {
public:
    Folder() : path_((fs::temp_directory_path() / "timestep_count_XXXXXX").string()) {
        if (mkdtemp(path_.data()) == nullptr) path_.clear();
    }
    ~Folder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

// The line "totals: 1234" of a dump.
bool read_total(const fs::path& dump, double& total) {
    std::ifstream file(dump);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("totals: ")) {
            total = std::strtod(line.c_str() + 8, nullptr);
            return true;
        }
    return false;
}

}  // namespace

void counted(const std::function<void()>& work) { bench_counted_work(&work); }

Counts count_instructions(const std::vector<std::string>& arguments, const std::function<void()>& tick) {
    const Folder folder;
    if (folder.path().empty()) return {{}, "there is no folder for temporary files"};
    std::vector<std::string> command{"valgrind",
                                     "--tool=callgrind",
                                     "--toggle-collect=bench_counted_work",
                                     "--dump-after=bench_counted_work",
                                     "--callgrind-out-file=" + folder.path() + "/dump",
                                     fs::read_symlink("/proc/self/exe").string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    std::string last;
    course::Lines lines([&](const std::string& line) { last = line; });
    int status = 0;
    try {
        status = course::listen(command, std::ref(lines), tick);
    } catch (const course::Stop& stop) {
        // An older valgrind does not know every instruction of a new processor.
        if (stop.status() == course::Status::interrupted) throw;
        return {{}, stop.what()};
    }
    if (status == 127) return {{}, "valgrind is not installed (package valgrind)"};
    if (status != 0) return {{}, "valgrind failed: " + last};
    // One dump a call, numbered from 1; a dump of the rest, at the end, has no number.
    Counts counts;
    double total = 0;
    for (int i = 1; read_total(folder.path() + "/dump." + std::to_string(i), total); ++i)
        counts.instructions.push_back(total);
    return counts;
}

}  // namespace bench
