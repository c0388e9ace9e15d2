#include "at_work.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace course {

namespace {

struct Process {
    char state = '?';
    pid_t parent = 0;
    long ticks = 0;  // its own and those of its children that have ended
};

// /proc/PID/stat is "PID (any name) state parent …", of which the fields 14 to 17 are processor times.
Process read_process(const std::filesystem::path& entry) {
    std::ifstream file(entry / "stat");
    std::string line;
    std::getline(file, line, '\0');
    const auto name_ends = line.rfind(')');
    Process process;
    if (name_ends == std::string::npos) return process;
    std::istringstream fields(line.substr(name_ends + 1));
    fields >> process.state >> process.parent;
    std::string skipped;
    for (int field = 5; field < 14; ++field) fields >> skipped;
    for (int field = 14; field <= 17; ++field) {
        long ticks = 0;
        fields >> ticks;
        process.ticks += ticks;
    }
    return process;
}

}  // namespace

long work_of(pid_t process) {
    namespace fs = std::filesystem;
    std::map<pid_t, Process> all;
    std::error_code error;
    for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error))
        if (const std::string name = entry->path().filename(); std::isdigit(static_cast<unsigned char>(name[0])))
            all[std::stoi(name)] = read_process(entry->path());
    if (error || !all.contains(process)) return -1;

    long ticks = 0;
    for (const auto& [id, member] : all) {
        pid_t ancestor = id;
        for (std::size_t i = 0; i < all.size() && ancestor != process && all.contains(ancestor); ++i)
            ancestor = all[ancestor].parent;
        if (ancestor != process) continue;
        if (member.state == 'R' || member.state == 'D') return -1;
        ticks += member.ticks;
    }
    return ticks;
}

}  // namespace course
