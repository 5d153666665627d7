#include <array>
#include <cmath>
#include <iostream>
#include <sstream>

#include "bench/measurements.h"
#include "bench/timed_worlds.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr std::size_t kEpisodes = 60, kSteps = 6000;  // of 10 ms: an hour in all
constexpr std::size_t kTurn = 50, kReferenceTurn = 5;

struct Cell {
  const char* vision;  // pixels a side of each eye
  const char* touch;   // density
};

// In the order of the paper's bars.
constexpr std::array<Cell, 7> kCells = {
    {{"64", "0.25"}, {"64", "0.5"}, {"64", "1"}, {"64", "2"}, {"128", "1"}, {"256", "1"}, {"512", "1"}}};

struct Row {
  Cell cell;
  std::size_t sensors, steps;
  double step_ms, reference_us, realtime;
  std::vector<std::pair<std::string, double>> split;

  // Not a number where there is no reference.
  double reference_steps() const { return reference_us > 0 ? step_ms * 1e3 / reference_us : std::nan(""); }
};

Row measure(const Cell& cell, const Figure3Options& options, Progress& progress, std::size_t done) {
  const std::size_t episodes = options.brief ? 1 : kEpisodes;
  WorldOptions world = options.world;
  world.vision = cell.vision;
  world.touch = cell.touch;
  SensingWorld full(world, episodes * kSteps);
  ReferenceStep reference(0, episodes * kSteps / kTurn * kReferenceTurn);
  RandomActions actions(full.env(), 0);
  full.warm_up(draw(actions, 1));
  reference.warm_up();
  for (std::size_t episode = 0; episode < episodes; ++episode) {
    full.reset(episode);
    for (std::size_t step = 0; step < kSteps; step += kTurn) {
      full.run(draw(actions, kTurn));
      reference.run(kReferenceTurn);
      progress.show(done += kTurn);
    }
  }
  const double step = full.times().mean();
  const double simulated = full.env().timestep() * full.env().frame_skip();
  return {cell,
          touch_sensors(full.env()),
          episodes * kSteps,
          step * 1e3,
          reference.times().mean() * 1e6,
          simulated / step,
          split_ms(full.env().timing(), step * 1e3)};
}

void print(const std::vector<Row>& rows) {
  Table table(2);
  std::vector<std::string> head = {"eyes", "touch", "sensors"};
  for (const auto& [part, ms] : rows[0].split) head.push_back(part);
  for (const char* column : {"ms a step", "x real time", "reference steps"}) head.emplace_back(column);
  table.add(head);
  for (const Row& row : rows) {
    std::vector<std::string> cells = {row.cell.vision, row.cell.touch, std::to_string(row.sensors)};
    for (const auto& [part, ms] : row.split) cells.push_back(text("%.3f", ms));
    cells.push_back(text("%.3f", row.step_ms));
    cells.push_back(text("%.2f", row.realtime));
    cells.push_back(text("%.2f", row.reference_steps()));
    table.add(cells);
  }
  table.print(std::cout);
  std::cout << "Milliseconds a step of 10 ms. A reference step is one physics step as the original solves it, measured "
               "in turns.\n";
}

void write_csv(const std::vector<Row>& rows, const std::string& path) {
  std::ostringstream file;
  file << "vision_px,touch_scale,touch_sensors,steps,ms_per_step,realtime_factor,reference_us,reference_steps";
  for (const auto& [part, ms] : rows[0].split) file << ',' << part << "_ms";
  file << '\n';
  for (const Row& row : rows) {
    file << row.cell.vision << ',' << row.cell.touch << ',' << row.sensors << ',' << row.steps << ',' << row.step_ms
         << ',' << row.realtime << ',' << row.reference_us << ',' << row.reference_steps();
    for (const auto& [part, ms] : row.split) file << ',' << ms;
    file << '\n';
  }
  write_file(path, file.str());
}

}  // namespace

void run_paper(const Figure3Options& options) {
  const std::size_t steps = (options.brief ? 1 : kEpisodes) * kSteps;
  std::vector<Row> rows;
  {
    Progress progress(kCells.size() * steps);
    for (const Cell& cell : kCells) rows.push_back(measure(cell, options, progress, rows.size() * steps));
  }
  print(rows);
  if (!options.csv.empty()) write_csv(rows, options.csv);
}

}  // namespace cli
