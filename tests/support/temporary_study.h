// A laboratory whose directory lives as long as it does.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "lab/laboratory.h"

namespace weft::test {

/// Of flights that nobody interrupts.
inline const lab::Watch no_watch = [] {};

/// A quick study of some methods; none: of all.
inline lab::LabOptions quick_study(std::vector<std::string> methods = {}, int threads = 2) {
    lab::LabOptions options;
    options.quick = true;
    options.threads = threads;
    options.methods = std::move(methods);
    return options;
}

class TemporaryStudy {
public:
    explicit TemporaryStudy(SceneDescription scene, lab::LabOptions options = {})
        : directory_(make_directory()),
          laboratory_(std::move(scene), directory_, std::move(options)) {
        laboratory_.begin_experiment("test", 1.0, 1);
    }
    TemporaryStudy(const TemporaryStudy&) = delete;
    TemporaryStudy& operator=(const TemporaryStudy&) = delete;
    ~TemporaryStudy() { std::filesystem::remove_all(directory_); }

    [[nodiscard]] lab::Laboratory& laboratory() { return laboratory_; }
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

private:
    static std::filesystem::path make_directory() {
        static int count = 0;
        const std::filesystem::path path =
            std::filesystem::temp_directory_path() /
            ("weft-study-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        std::filesystem::remove_all(path);
        return path;
    }

    std::filesystem::path directory_;
    lab::Laboratory laboratory_;
};

}  // namespace weft::test
