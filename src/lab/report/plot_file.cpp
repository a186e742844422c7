#include "lab/report/plot_file.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "io/gnuplot.h"
#include "lab/report/inline_svg.h"
#include "lab/report/plot_script.h"
#include "lab/report/report.h"
#include "weft/error.h"

namespace weft::lab {

namespace {

Error not_found() {
    return file_error("gnuplot", "the plots need this program, which is not found",
                      "Install it: apt install gnuplot-nox");
}

std::string drawn(const PlotJob& job, PlotCanvas::Kind kind) {
    const GnuplotRun run = run_gnuplot(plot_script(*job.plot, {kind, job.narrow}));
    if (run.status == -1) throw not_found();
    const bool whole = kind == PlotCanvas::Kind::png ? run.output.starts_with("\x89PNG")
                                                     : run.output.ends_with("</svg>\n\n");
    if (!run.ok() || !whole) {
        throw file_error(job.plot->id, "gnuplot failed on this plot", run.messages);
    }
    return run.output;
}

DrawnPlot draw(const PlotJob& job) {
    return {
        inline_svg(drawn(job, PlotCanvas::Kind::page), job.name, {job.plot->title, job.plot->text}),
        drawn(job, PlotCanvas::Kind::svg), drawn(job, PlotCanvas::Kind::png)};
}

}  // namespace

void check_plotting() {
    const GnuplotRun run = run_gnuplot("exit\n");
    if (run.status == -1) throw not_found();
    if (!run.ok()) throw file_error("gnuplot", "this program fails", run.messages);
}

std::vector<DrawnPlot> draw_plots(std::span<const PlotJob> jobs) {
    std::vector<DrawnPlot> drawings(jobs.size());
    std::atomic<std::size_t> next{0};
    std::exception_ptr problem;
    std::mutex guard;
    const auto work = [&] {
        try {
            for (std::size_t n = next++; n < jobs.size(); n = next++) drawings[n] = draw(jobs[n]);
        } catch (...) {
            const std::lock_guard lock(guard);
            if (!problem) problem = std::current_exception();
            next = jobs.size();
        }
    };
    {
        const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
        std::vector<std::jthread> threads;
        for (std::size_t n = 0; n < std::min(most, jobs.size()); ++n) threads.emplace_back(work);
    }
    if (problem) std::rethrow_exception(problem);
    return drawings;
}

}  // namespace weft::lab
