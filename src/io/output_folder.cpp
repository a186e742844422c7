// A folder of files that appears whole or not at all: a temporary folder, renamed.
#include "io/output_folder.h"

#include <system_error>
#include <utility>

#include "weft/error.h"

namespace weft {

OutputFolder::OutputFolder(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code problem;
    const auto status = std::filesystem::symlink_status(path_, problem);
    if (std::filesystem::exists(status) && !std::filesystem::is_directory(status))
        throw file_error(path_.string(), "cannot write the folder: a file of that name exists");
    try {
        temporary_ = temporary_name(path_);
        std::filesystem::create_directory(temporary_);
    } catch (const std::filesystem::filesystem_error& error) {
        throw file_error(path_.string(), "cannot make the folder: " + error.code().message());
    }
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    if (!temporary_.empty()) std::filesystem::remove_all(temporary_, ignored);
}

OutputFile OutputFolder::open(const std::string& name) const {
    return OutputFile(file(name), path_ / name);
}

std::filesystem::path OutputFolder::file(const std::string& name) const {
    return (temporary_.empty() ? path_ : temporary_) / name;
}

void OutputFolder::commit() {
    std::error_code problem, ignored;
    std::filesystem::path earlier;
    if (std::filesystem::exists(path_, ignored)) {
        earlier = temporary_name(path_);
        std::filesystem::rename(path_, earlier, problem);
    }
    if (!problem) {
        std::filesystem::rename(temporary_, path_, problem);
        if (problem && !earlier.empty()) std::filesystem::rename(earlier, path_, ignored);
    }
    if (problem) throw file_error(path_.string(), "cannot rename: " + problem.message());
    temporary_.clear();
    if (!earlier.empty()) std::filesystem::remove_all(earlier, ignored);
}

}  // namespace weft
