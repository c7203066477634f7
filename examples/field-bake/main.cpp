// field-bake: a sequence of light probes to a grid of coefficients (Loew et al., HDR light probe sequence resampling
// for realtime incident light field rendering, SCCG 2009).
//
// Pictures are read once and their samples sorted by direction into files; direction by direction they are resampled to
// all points of the grid. Both steps keep what they have in the work folder, and go on from there.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>

#include <tbb/parallel_for.h>

#include "baking.hpp"
#include "options.hpp"
#include "probe_pictures.hpp"
#include "ranks.hpp"
#include "report.hpp"
#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"
#include "shared/output_file.hpp"
#include "shared/program.hpp"
#include "shared/progress.hpp"

namespace example::field_bake {
namespace {

constexpr const char* program_name = "field-bake";

namespace stage_name {
constexpr const char* thinning = "thinning";
constexpr const char* sorting = "sorting pictures";
constexpr const char* resampling = "resampling";
}  // namespace stage_name

const auto for_each = [](int count, const auto& body) { tbb::parallel_for(0, count, body); };

Bounds box_of(const zonal::ProbeSequence& sequence) {
  Bounds box{sequence.probes[0].position, sequence.probes[0].position};
  for (const zonal::SequenceProbe& probe : sequence.probes) {
    box.lower = glm::min(box.lower, probe.position);
    box.upper = glm::max(box.upper, probe.position);
  }
  return box;
}

/// The sequence without those of its probes that tell nothing new: it is kept in the work folder, for the next run.
zonal::ProbeSequence thinned(const zonal::ProbeSequence& sequence, const zonal::DirectionBuckets& buckets,
                             const std::filesystem::path& path, const Ranks& ranks, const Options& options,
                             Progress& progress) {
  if (ranks.is_first() && !std::filesystem::exists(path)) {
    const ProbePictures pictures(sequence);
    const auto load = [&](const zonal::SequenceProbe& probe, const auto& use) {
      pictures(probe, use);
      progress.advance(stage_name::thinning, 1);
    };
    zonal::ProbeSequence kept = sequence;
    kept.probes.clear();
    for (const std::size_t n : zonal::thin(sequence, buckets, *options.thinning, load, for_each)) {
      kept.probes.push_back(sequence.probes[n]);
    }
    std::filesystem::create_directories(path.parent_path());
    zonal::write_sequence(path, kept);
  }
  ranks.wait();
  return zonal::read_sequence(path);
}

std::filesystem::path thinned_path(const zonal::ProbeSequence& sequence, const zonal::DirectionBuckets& buckets,
                                   const Options& options) {
  zonal::detail::Fingerprint print;
  print.add(zonal::fingerprint(sequence, buckets)).add(options.thinning->difference).add(options.thinning->distance);
  return std::filesystem::path(options.work) / ("thinned-" + std::to_string(print.value()) + ".txt");
}

/// Writes the files of samples that are not there.
void sort(const zonal::ProbeSequence& sequence, const zonal::DirectionBuckets& buckets, const zonal::BakeFolder& folder,
          const Ranks& ranks, Report& report, Progress& progress) {
  const ProbePictures pictures(sequence);
  const auto load = [&](const zonal::SequenceProbe& probe, const auto& use) {
    pictures(probe, use);
    progress.advance(stage_name::sorting, 1);
  };
  for (std::size_t n = ranks.index(); n < folder.file_count(); n += ranks.count()) {
    throw_if_interrupted();
    const std::size_t probes = folder.header(n).probes;
    if (folder.has(n)) {
      progress.advance(stage_name::sorting, double(probes));
      continue;
    }
    report.faults += zonal::sort_samples(folder, n, sequence, buckets, load, for_each);
    report.pictures_read += probes;
  }
}

/// Keeps its sums now and then, as often as that takes a twentieth of the time, and where it is stopped.
void resample(Baking& baking, double block_cost, Report& report, Progress& progress) {
  using Clock = std::chrono::steady_clock;
  Clock::duration between = std::chrono::seconds(10);
  Clock::time_point saved = Clock::now();
  progress.advance(stage_name::resampling, block_cost * double(baking.done()));
  const std::size_t begin = baking.done();
  while (baking.done() < baking.count()) {
    baking.step();
    progress.advance(stage_name::resampling, block_cost);
    const bool is_last = baking.done() == baking.count(), is_time = Clock::now() - saved > between;
    if (is_time || stop_requested() || (is_last && report.ranks > 1)) {
      const Clock::time_point begin_of_save = Clock::now();
      baking.save();
      saved = Clock::now();
      between = std::max(between, 20 * (saved - begin_of_save));
    }
    throw_if_interrupted();
  }
  report.blocks_done = baking.done() - begin;
}

/// In units of reading a picture and sorting it.
double cost_of_block(const Options& options, std::size_t probes) {
  const double points = double(options.resolution.x) * options.resolution.y * options.resolution.z;
  const double gather = points * (options.gradients ? 4 : 1) * options.bands * options.bands,
               splat = double(probes) * 60;
  return (gather + splat) * (options.path == Path::space ? 30 : 1) / 2e5;
}

/// All that can be wrong with the input comes to light before the work begins; but each picture when it is read.
zonal::ProbeSequence opened_sequence(const Options& options, Report& report) {
  zonal::ProbeSequence sequence = zonal::read_sequence(options.sequence);
  report.probes = sequence.probes.size();
  report.box = options.box ? *options.box : box_of(sequence);
  using AnyGrid = zonal::CoefficientGrid<1>;
  const std::string wrong = AnyGrid::what_is_wrong(report.box.lower, report.box.upper, options.resolution);
  if (!wrong.empty()) {
    throw InputError(wrong + (options.box ? "" : "; the box is that of the probes, where --box names no other"));
  }
  std::vector<std::filesystem::path> inputs{options.sequence}, outputs{options.out};
  for (const zonal::SequenceProbe& probe : sequence.probes) inputs.push_back(probe.picture);
  if (!options.report.empty()) outputs.emplace_back(options.report);
  check_outputs(outputs, inputs);
  return sequence;
}

Report bake(const Options& options, const Ranks& ranks) {
  Report report;
  report.options = options;
  report.ranks = ranks.count();
  const ThreadLimit limit(options.threads);
  report.machine = limit.machine();

  zonal::ProbeSequence sequence = opened_sequence(options, report);
  const zonal::DirectionBuckets buckets = ProbePictures(sequence).buckets();
  report.buckets = buckets.size();

  Progress progress(!options.quiet && ranks.is_first());
  const double block_cost = cost_of_block(options, sequence.probes.size());
  report.blocks = zonal::block_count(buckets.size());
  const double share = 1 / double(ranks.count());
  progress.expect(double(report.probes) * (share + (options.thinning ? 1 : 0)) +
                  block_cost * double(report.blocks) * share);

  std::filesystem::path thinned_file;
  if (options.thinning) {
    thinned_file = thinned_path(sequence, buckets, options);
    sequence = report.times.time(stage_name::thinning,
                                 [&] { return thinned(sequence, buckets, thinned_file, ranks, options, progress); });
    report.thinned = report.probes - sequence.probes.size();
  }
  const zonal::BakeFolder folder(options.work, sequence, buckets, std::size_t(options.memory) << 20U);
  if (ranks.is_first()) folder.clean();
  ranks.wait();
  report.times.time(stage_name::sorting, [&] { sort(sequence, buckets, folder, ranks, report, progress); });
  ranks.wait();
  const std::unique_ptr<Baking> baking = make_baking(options, report.box, folder, sequence, buckets, ranks);
  report.grid_bytes = baking->grid_bytes();
  report.times.time(stage_name::resampling, [&] {
    resample(*baking, block_cost, report, progress);
    if (!baking->finish(ranks, options)) {
      throw InputError(options.sequence + ": no ray of any probe comes near the box");
    }
  });
  ranks.wait();
  baking->forget();
  ranks.wait();
  if (ranks.is_first() && !options.keep_work) {
    std::filesystem::remove(thinned_file);
    folder.remove();
  }
  return report;
}

void tell(const Report& report) {
  if (!report.options.report.empty()) {
    OutputBatch batch;
    batch.add(report.options.report, json_text(report));
    batch.move_into_place();
  }
  if (!report.options.quiet) std::fputs(text(report).c_str(), stdout);
}

/// What stopped is in the work folder.
void run_one(const Options& options, const Ranks& ranks) {
  try {
    const Report report = bake(options, ranks);
    if (ranks.is_first()) tell(report);
  } catch (const zonal::FileError& error) {
    throw InputError(one_line(error.what()));
  } catch (const Interrupted&) {
    throw Interrupted{"the same command goes on from here"};
  }
}

/// Where one of several ranks cannot go on all end: the others would wait for it.
void run(const Options& options) {
  const Ranks ranks;
  if (ranks.count() == 1) return run_one(options, ranks);
  const int exit_status = report_errors(program_name, [&] {
    run_one(options, ranks);
    return 0;
  });
  if (exit_status != 0) ranks.end_all(exit_status);
}

}  // namespace
}  // namespace example::field_bake

int main(int argc, char** argv) {
  using namespace example::field_bake;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
