#include "context.hpp"

#include "text.hpp"

#include <stdexcept>

namespace page {

Context::Context(std::filesystem::path root, std::filesystem::path runs)
    : root_{std::move(root)}, runs_{std::move(runs)}, chapters_{load_chapters(root_)} {
    for (const Chapter& chapter : chapters_) {
        data_.emplace(chapter.folder, RunData{chapter.folder, runs_ / chapter.folder / "run"});
        inputs.insert(root_ / chapter.about());
    }
}

void Context::set_chapter(const std::string& folder, const std::filesystem::path& input) {
    for (const Chapter& chapter : chapters_) {
        if (chapter.folder == folder) {
            chapter_ = &chapter;
            more_ = input.filename() == "more.md";
            return;
        }
    }
    throw std::out_of_range{"there is no chapter " + folder};
}

const std::string& Context::folder_of(const std::string& reference) {
    const std::size_t slash = reference.find('/');
    if (slash == std::string::npos) {
        if (chapter_ == nullptr)
            throw std::out_of_range{"\"" + reference + "\" needs its chapter before it: NN_name/" + reference};
        return chapter_->folder;
    }
    const std::string folder = reference.substr(0, slash);
    auto found = data_.find(folder);
    if (found == data_.end()) {
        // What is measured beside the chapters leaves a run of its own.
        if (!std::filesystem::is_directory(runs_ / folder / "run")) throw NotYet{"there is no run of " + folder};
        found = data_.emplace(folder, RunData{folder, runs_ / folder / "run"}).first;
    }
    return found->first;
}

RunData& Context::run_of(const std::string& reference, std::string& name) {
    const std::size_t slash = reference.find('/');
    name = slash == std::string::npos ? reference : reference.substr(slash + 1);
    const std::string& folder = folder_of(reference);
    if (const std::filesystem::path done = runs_ / folder / "run/done"; std::filesystem::exists(done)) {
        inputs.insert(done);  // the page is out of date when that run is made again
    }
    return data_.at(folder);
}

}  // namespace page
