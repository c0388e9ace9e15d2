#include "look.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace checker {

namespace {

namespace fs = std::filesystem;

struct Stat {
    char state = '?';
    pid_t parent = 0;
    long ticks = 0;  // its own and those of its children that have ended
};

// A file stat is "PID (any name) state parent …", of which the fields 14 to 17 are processor times.
Stat read_stat(const fs::path& folder) {
    std::ifstream file(folder / "stat");
    std::string line;
    std::getline(file, line, '\0');
    Stat stat;
    const auto name_ends = line.rfind(')');
    if (name_ends == std::string::npos) return stat;
    std::istringstream fields(line.substr(name_ends + 1));
    fields >> stat.state >> stat.parent;
    std::string skipped;
    for (int field = 5; field < 14; ++field) fields >> skipped;
    for (int field = 14; field <= 17; ++field) {
        long ticks = 0;
        fields >> ticks;
        stat.ticks += ticks;
    }
    return stat;
}

std::vector<fs::path> numbered(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (std::isdigit(static_cast<unsigned char>(entry->path().filename().string()[0])))
            found.push_back(entry->path());
    return found;
}

// A thread that has a processor or waits for one (R), or for a disk (D), is at work; so is one that
// somebody has stopped (T, t), for it cannot help it.
bool sleeps(const fs::path& process) {
    bool all = true;
    for (const fs::path& thread : numbered(process / "task"))
        all = all && std::string("SZX").find(read_stat(thread).state) != std::string::npos;
    return all;
}

}  // namespace

Look look_at(pid_t process) {
    static const double ticks_a_second = static_cast<double>(sysconf(_SC_CLK_TCK));
    std::map<pid_t, Stat> all;
    for (const fs::path& place : numbered("/proc"))
        if (const Stat stat = read_stat(place); stat.state != '?') all[std::stoi(place.filename())] = stat;
    Look look;
    if (!all.contains(process)) return look;
    look.known = look.asleep = true;
    for (const auto& [id, stat] : all) {
        pid_t ancestor = id;
        for (std::size_t i = 0; i < all.size() && ancestor != process && all.contains(ancestor); ++i)
            ancestor = all.at(ancestor).parent;
        if (ancestor != process) continue;
        look.seconds += static_cast<double>(stat.ticks) / ticks_a_second;
        look.asleep = look.asleep && sleeps("/proc/" + std::to_string(id));
    }
    return look;
}

}  // namespace checker
