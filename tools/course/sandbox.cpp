#include "sandbox.hpp"

#include <cstdlib>

#include "paths.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

void add(Words& words, std::initializer_list<std::string> more) { words.insert(words.end(), more); }

void show(Words& words, const fs::path& place) { add(words, {"--ro-bind", place.string(), place.string()}); }

bool is_below(const fs::path& place, const fs::path& folder) {
    return !fs::relative(place, folder).string().starts_with("..");
}

// The folders of this course below /usr, which would be visible with the system's files.
std::vector<fs::path> hidden_again() {
    std::vector<fs::path> own;
    for (const fs::path& place : {paths().source, paths().build})
        if (is_below(place, "/usr")) own.push_back(place);
    return own;
}

// Nothing may be written; called after the last place is shown.
void close(Words& words) {
    for (const fs::path& own : hidden_again()) add(words, {"--remount-ro", own.string()});
    add(words, {"--remount-ro", "/"});
}

// The files and folders that a compiler's words name, without the system's.
std::vector<fs::path> named_in(const Words& command) {
    std::vector<fs::path> named;
    std::error_code ignored;
    const fs::path compiler = fs::canonical(command[0], ignored);  // CMake names it from the root
    if (!is_below(compiler, "/usr")) named.push_back(compiler.parent_path().parent_path());
    for (std::size_t i = 1; i < command.size(); ++i) {
        const std::string& word = command[i];
        const fs::path place = word.starts_with("-I") ? word.substr(2) : word;
        if (place.is_absolute() && fs::exists(place, ignored) && !is_below(place, "/usr")) named.push_back(place);
    }
    return named;
}

const char* const lock = "lock";

// Removes what a killed check has left behind.
void sweep(const fs::path& temporaries) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(temporaries, ignored)) {
        const fs::path folder = entry.path();
        if (folder.filename().string().starts_with("check_") && entry.is_directory(ignored) &&
            !Lock::is_held(folder / lock))
            fs::remove_all(folder, ignored);
    }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    const fs::path temporaries = paths().build / "exercises";
    const Lock no_sweep(temporaries / "temporaries.lock");  // before ours has its lock
    sweep(temporaries);
    std::string name = (temporaries / "check_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Stop(Status::bad_use, temporaries.string() + ": cannot be written");
    folder_ = name;
    in_use_.emplace(folder_ / lock);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

Sandbox::Sandbox() {
    const std::string fault = fault_of(walls());
    if (!fault.empty())
        throw Stop(Status::missing,
                   "grade needs bubblewrap (package bubblewrap), which is missing or cannot work here (" + fault +
                       "). Without it a submission could read this machine's files and reach its network; "
                       "--trust grades all the same, where you would run every file by hand");
}

std::string Sandbox::fault_of(std::vector<std::string> before) {
    before.push_back("true");
    const Outcome outcome = run_within(before, {.seconds = 120, .processor_seconds = 10});
    if (outcome.too_slow) return "bwrap: has not come to an end";
    return outcome.status == 0 ? "" : outcome.said.substr(0, outcome.said.find('\n'));
}

// An empty file system with the system's programs and libraries; this course's own folders below /usr are hidden.
// Nobody is root in it. Everything in it ends with bubblewrap, which ends with us.
Words Sandbox::walls() {
    Words words{"bwrap"};
    add(words, {"--unshare-all", "--unshare-user", "--disable-userns", "--die-with-parent"});
    add(words, {"--new-session", "--uid", "65534", "--gid", "65534", "--hostname", "sandbox"});
    add(words, {"--clearenv", "--setenv", "PATH", "/usr/bin:/bin", "--setenv", "LC_ALL", "C.UTF-8"});
    show(words, "/usr");
    for (const char* place : {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"}) {
        std::error_code error;
        const fs::path target = fs::read_symlink(place, error);
        if (!error)
            add(words, {"--symlink", target.string(), place});
        else
            add(words, {"--ro-bind-try", place, place});
    }
    for (const char* place : {"/etc/alternatives", "/etc/ld.so.cache"}) add(words, {"--ro-bind-try", place, place});
    for (const char* device : {"/dev/null", "/dev/zero", "/dev/urandom"}) add(words, {"--dev-bind", device, device});
    for (const fs::path& own : hidden_again()) add(words, {"--tmpfs", own.string()});
    return words;
}

Words Sandbox::before_compiler(const Words& command, const fs::path& folder, const std::vector<fs::path>& reads) const {
    Words words = walls();
    add(words, {"--size", "268435456", "--tmpfs", "/tmp", "--setenv", "TMPDIR", "/tmp"});
    add(words, {"--setenv", "CCACHE_DISABLE", "1", "--setenv", "HOME", "/"});  // the compiler may be ccache's
    for (const fs::path& place : named_in(command))
        if (!is_below(place, folder)) show(words, place);
    for (const fs::path& place : reads) show(words, place);
    add(words, {"--bind", folder.string(), folder.string(), "--chdir", folder.string()});
    close(words);
    return words;
}

Words Sandbox::before_worker(const fs::path& worker) const {
    Words words = walls();
    show(words, worker);
    add(words, {"--chdir", "/"});
    close(words);
    return words;
}

}  // namespace course
