#include "lab/laboratory.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <fstream>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "io/output_file.h"
#include "io/scene_json.h"
#include "weft/error.h"
#include "weft/instruction_set.h"
#include "weft/integrators.h"
#include "weft/simulation.h"

namespace weft::lab {

namespace {

// FNV-1a, 64 bits (Fowler, Noll, Vo): for names of files, not for safety.
class Hash {
public:
    void add(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t n = 0; n < size; ++n) value_ = (value_ ^ bytes[n]) * 0x100000001b3u;
    }
    void add(std::string_view text) { add(text.data(), text.size()); }
    [[nodiscard]] std::string text() const { return fmt::format("{:016x}", value_); }

private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

// What results depend on besides their trial. Pictures and recordings are not measured.
std::string fingerprint_of(const SceneDescription& scene, bool quick) {
    nlohmann::ordered_json json = scene_to_json(scene);
    json.erase("name");
    Hash hash;
    hash.add(json.dump());
    hash.add(fmt::format("weft {} {} {}", version(), instruction_set(), quick ? "quick" : "full"));
    if (scene.cloth.mesh) {
        for (const Vec3d& x : scene.cloth.mesh->positions) hash.add(&x, sizeof x);
        for (const Mesh::Face& face : scene.cloth.mesh->faces) {
            hash.add(face.position.data(), sizeof face.position);
        }
    }
    return hash.text();
}

// A file name that tells what it is of, and is no other's.
std::string file_stem(const std::string& trial) {
    std::string stem;
    for (const char c : trial) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.';
        if (plain || (!stem.empty() && stem.back() != '-')) stem += plain ? c : '-';
    }
    Hash hash;
    hash.add(trial);
    return stem.substr(0, 60) + "-" + hash.text();
}

void make_directory(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw file_error(path.string(), "cannot be made: " + error.message());
}

std::vector<std::string_view> chosen_methods(const std::vector<std::string>& names) {
    std::vector<std::string_view> methods;
    for (const IntegratorInfo& info : integrator_catalogue()) {
        if (names.empty() || std::ranges::find(names, info.name) != names.end()) {
            methods.push_back(info.name);
        }
    }
    return methods;
}

}  // namespace

Laboratory::Laboratory(SceneDescription scene, std::filesystem::path directory, LabOptions options)
    : scene_(std::move(scene)),
      directory_(std::move(directory)),
      options_(std::move(options)),
      methods_(chosen_methods(options_.methods)),
      fingerprint_(fingerprint_of(scene_, options_.quick)) {
    if (options_.threads <= 0) {
        options_.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    }
    make_directory(directory_ / "trials");
}

std::filesystem::path Laboratory::media_directory() const {
    const std::filesystem::path path = directory_ / experiment_;
    make_directory(path);
    return path;
}

void Laboratory::check_interrupt() const {
    if (options_.stop && options_.stop()) throw Interrupted{};
}

void Laboratory::begin_experiment(std::string_view experiment, double share, int batches) {
    done_share_ += share_;
    share_ = share;
    experiment_ = experiment;
    batches_ = batches;
    batch_ = 0;
    make_directory(directory_ / "trials" / experiment_);
    tell({}, 0, 0, 0.0);
}

std::filesystem::path Laboratory::file_of(const Trial& trial) const {
    return directory_ / "trials" / experiment_ / (file_stem(trial.name) + ".json");
}

// A file that is not whole, or of another scene, is measured anew.
std::optional<nlohmann::json> Laboratory::kept(const Trial& trial) const {
    std::ifstream file(file_of(trial));
    if (!file) return std::nullopt;
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    if (!json.is_object() || json.value("fingerprint", "") != fingerprint_ ||
        json.value("trial", "") != trial.name || !json.contains("result")) {
        return std::nullopt;
    }
    return json.at("result");
}

nlohmann::json Laboratory::keep(const Trial& trial, const nlohmann::json& result) const {
    const std::string text = nlohmann::json{
        {"trial", trial.name},
        {"fingerprint", fingerprint_},
        {"result", result}}.dump();
    OutputFile file(file_of(trial));
    file.write(text);
    file.commit();
    return nlohmann::json::parse(text).at("result");
}

void Laboratory::tell(const std::string& trial, std::size_t done, std::size_t of,
                      double fraction) const {
    if (!options_.progress) return;
    const double of_experiment = (static_cast<double>(batch_) + fraction) / batches_;
    options_.progress(
        {experiment_, trial, done, of, done_share_ + share_ * std::min(of_experiment, 1.0)});
}

namespace {

// Trials taken in turn by several threads. The first exception ends all of them.
class Workers {
public:
    template <typename Work>
    void run(std::size_t count, int threads, const Work& work) {
        const auto take = [&] {
            for (std::size_t n = next_++; n < count && !failed_; n = next_++) {
                try {
                    work(n);
                } catch (...) {
                    const std::lock_guard lock(mutex_);
                    if (!failed_) exception_ = std::current_exception();
                    failed_ = true;
                }
            }
        };
        std::vector<std::thread> others;
        for (int n = 1; n < threads; ++n) others.emplace_back(take);
        take();
        for (std::thread& other : others) other.join();
        if (exception_) std::rethrow_exception(exception_);
    }

    [[nodiscard]] bool failed() const { return failed_; }

private:
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    std::exception_ptr exception_;
};

}  // namespace

std::vector<nlohmann::json> Laboratory::run(std::span<const Trial> trials, Batch batch) {
    std::vector<nlohmann::json> results(trials.size());
    std::vector<std::size_t> missing;
    double work = 0.0, done_work = 0.0;
    for (std::size_t n = 0; n < trials.size(); ++n) {
        work += trials[n].work;
        if (std::optional<nlohmann::json> found = kept(trials[n])) {
            results[n] = std::move(*found);
            done_work += trials[n].work;
        } else {
            missing.push_back(n);
        }
    }
    // Long ones first, so that no thread is left alone with one at the end.
    std::ranges::stable_sort(
        missing, [&](std::size_t a, std::size_t b) { return trials[a].work > trials[b].work; });
    std::mutex telling;
    std::size_t done = trials.size() - missing.size();
    Workers workers;
    const Watch watch = [&] {
        if (workers.failed()) throw Interrupted{};
        check_interrupt();
    };
    const int threads =
        batch == Batch::timed
            ? 1
            : static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(options_.threads),
                                                     std::max<std::size_t>(missing.size(), 1)));
    workers.run(missing.size(), threads, [&](std::size_t place) {
        const Trial& trial = trials[missing[place]];
        watch();
        results[missing[place]] = keep(trial, trial.measure(watch));
        const std::lock_guard lock(telling);
        done_work += trial.work;
        tell(trial.name, ++done, trials.size(), work > 0.0 ? done_work / work : 1.0);
    });
    ++batch_;
    tell({}, done, trials.size(), 0.0);
    return results;
}

}  // namespace weft::lab
