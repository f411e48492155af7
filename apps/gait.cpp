#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <memory>

#include "apps/commands.hpp"
#include "apps/draw_gait.hpp"
#include "apps/inputs.hpp"
#include "apps/optimise.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"
#include "gait/crawl/envelope.hpp"
#include "gait/crawl/library.hpp"
#include "gait/crawl/recipes.hpp"
#include "gait/crawl/switches.hpp"
#include "gait/nao.hpp"
#include "gait/table_text.hpp"

namespace underway {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExamples =
    "Examples:\n"
    "  underway gait list\n"
    "  underway gait crawl --gait efficient --cycles 5 --out crawl.csv\n"
    "  underway gait crawl --gait nominal --plot nominal.svg --html nominal.html\n"
    "  underway gait crawl --gait fast --cycles 10 --standing --out under_the_table.json\n"
    "  underway gait optimise --aim torque --out mine.json\n"
    "  underway gait make --out gaits";

constexpr const char* kCrawlExamples =
    "CSV: a line a row, time_s and the joints' angles in rad. JSON: names, angleLists, timeLists and "
    "isAbsolute,\n"
    "as NAOqi's angleInterpolation takes them. --plot draws the push's free angles, the chain, the joints "
    "and\n"
    "the torques; --html is an animation.\n"
    "Examples:\n"
    "  underway gait crawl --gait efficient --cycles 5 --out crawl.csv\n"
    "  underway gait crawl --gait narrow --push-s 4 --turn-rad 0.03 --out curve.json --html curve.html";

struct CrawlArguments {
  std::string gait = "nominal";
  int cycles = 1;
  double push_s = 0.0;  ///< 0: the gait's own
  double turn_rad = 0.0;
  bool is_from_standing = false;
  std::string out;
  std::string plot;
  std::string html;
};

/// Says it, and what the program ends with.
ExitCode refuse(const std::string& sentence, ExitCode code = ExitCode::kInvalidInput) {
  complain(sentence);
  return code;
}

Expected<gait::GaitFile> read(const std::string& name) {
  const auto data = findDataFolder();
  if (!data) return tl::unexpected(data.error());
  auto file = gait::readGait(*data / "gaits", name);
  if (!file) return fail(ErrorCode::kInvalidRequest, file.error().message);
  return *file;
}

std::string figuresOf(const gait::GaitFile& file, const gait::Envelope& room, const gait::JointTable& motion,
                      int cycles) {
  const gait::CrawlTimes& times = file.gait.times;
  Table table({{"gait"}, {file.gait.name}});
  const auto add = [&](const char* what, std::string value) { table.add({{what}, {std::move(value)}}); };
  add("", file.about);
  add("cycles", fmt::format("{}, {:.1f} s in all", cycles, motion.duration()));
  add("a cycle", fmt::format("{:.2f} s: extension {:.2f}, push {:.2f}, lowering {:.2f}", times.cycle(),
                             times.extension_s, times.push_s, times.lowering_s));
  add("advance", fmt::format("{:.0f} mm a cycle, {:.1f} mm/s (at rest, level floor)", 1e3 * room.advance_m,
                             1e3 * room.advance_m / times.cycle()));
  add("highest", fmt::format("{:.0f} mm", 1e3 * room.high.z()));
  add("room", fmt::format("{:.0f} mm behind to {:.0f} mm ahead of the hips, {:.0f} mm to each side",
                          -1e3 * room.low.x(), 1e3 * room.high.x(), 1e3 * room.high.y()));
  add("stability",
      room.least_margin_m >= 0.0
          ? fmt::format("centre of mass at least {:.0f} mm inside its support", 1e3 * room.least_margin_m)
          : fmt::format("at rest it would tip over: centre of mass up to {:.0f} mm outside its support",
                        -1e3 * room.least_margin_m));
  return table.text(wantsColour());
}

/// Down from standing, the crawl, and up again, in rows as close as the crawl's.
gait::JointTable withSwitches(const gait::JointTable& crawl) {
  constexpr double kRow_s = 0.025;
  gait::JointTable motion = gait::goDown(crawl);
  motion.append(crawl);
  motion.append(gait::getUp(crawl));
  return motion.denser(kRow_s);
}

Expected<void> writeMotion(const gait::JointTable& motion, const std::string& out) {
  if (out.empty()) return {};
  if (out == "-") return writeOutput(gait::toCsv(motion));
  if (fs::path(out).extension() == ".csv") return writeText(out, gait::toCsv(motion));
  if (fs::path(out).extension() == ".json") return writeText(out, gait::toNaoqiJson(motion));
  return fail(ErrorCode::kInvalidRequest, "--out: \"" + out + "\" must end in .csv or .json");
}

Expected<void> writeAll(const CrawlArguments& arguments, const gait::CrawlGait& crawl,
                        const gait::JointTable& cycles, const gait::JointTable& motion) {
  if (const auto written = writeMotion(motion, arguments.out); !written) return written;
  if (!arguments.plot.empty())
    if (const auto written = writeText(arguments.plot, drawGait(crawl, cycles)); !written) return written;
  if (arguments.html.empty()) return {};
  return writeText(arguments.html, animateGait("Crawl " + crawl.name, cycles));
}

ExitCode runCrawl(const CrawlArguments& arguments) {
  auto file = read(arguments.gait);
  if (!file) return refuse(file.error().message, exitCodeOf(file.error().code));
  gait::CrawlGait& crawl = file->gait;
  if (arguments.push_s > 0.0) crawl.times.push_s = arguments.push_s;
  crawl.turn_rad += arguments.turn_rad;
  const auto cycles = gait::crawlMotion(gait::naoCrawler(), crawl, arguments.cycles);
  if (!cycles) return refuse("gait \"" + crawl.name + "\": " + cycles.error().message);
  const auto room = gait::crawlEnvelope(gait::nao(), gait::naoCrawler(), crawl);
  if (!room) return refuse(room.error().message);
  const gait::JointTable motion = arguments.is_from_standing ? withSwitches(*cycles) : *cycles;
  if (const auto written = writeAll(arguments, crawl, *cycles, motion); !written)
    return refuse(written.error().message, exitCodeOf(written.error().code));
  if (arguments.out == "-") return ExitCode::kDone;
  const auto told = writeOutput(figuresOf(*file, *room, motion, arguments.cycles));
  return told ? ExitCode::kDone : refuse(told.error().message, ExitCode::kOther);
}

ExitCode runList() {
  const auto data = findDataFolder();
  if (!data) return refuse(data.error().message, ExitCode::kOther);
  Table table({{"gait"}, {"push", Table::Align::kRight}, {"cycle", Table::Align::kRight}, {"for"}});
  for (const std::string& name : gait::gaitNames(*data / "gaits")) {
    const auto file = gait::readGait(*data / "gaits", name);
    if (!file) return refuse(file.error().message);
    table.add({{name},
               {fmt::format("{:g} to {:g} s", file->for_push_s_least, file->for_push_s_most)},
               {fmt::format("{:.1f} s", file->gait.times.cycle())},
               {file->about}});
  }
  const auto told = writeOutput(table.text(wantsColour()));
  return told ? ExitCode::kDone : refuse(told.error().message, ExitCode::kOther);
}

ExitCode runMake(const std::string& folder) {
  std::error_code failed;  // writing says it
  fs::create_directories(folder, failed);
  const std::vector<gait::Recipe> recipes = gait::naoRecipes();
  for (std::size_t i = 0; i < recipes.size(); ++i) {
    ProgressBar bar("optimising " + recipes[i].from.name);
    const gait::GaitFile file = gait::make(recipes[i], [&](double share, double) { bar.show(share); });
    const fs::path path = fs::path(folder) / (file.gait.name + ".json");
    if (const auto written = writeText(path, gait::toJson(file)); !written)
      return refuse(written.error().message, ExitCode::kOther);
  }
  const auto told = writeOutput(fmt::format("{} gaits written to {}\n", recipes.size(), folder));
  return told ? ExitCode::kDone : refuse(told.error().message, ExitCode::kOther);
}

CLI::App& addCrawl(CLI::App& command, CrawlArguments& arguments) {
  CLI::App& crawl = *command.add_subcommand("crawl", "Joint angles of some cycles of a crawl, for NAO");
  crawl.add_option("--gait", arguments.gait, "One of `underway gait list`, or a gait's file")
      ->capture_default_str()
      ->type_name("NAME|FILE");
  addWhole(crawl, "--cycles", arguments.cycles, 1, 10'000, "How many (1)");
  addNumber(crawl, "--push-s", arguments.push_s, 0.1, 60.0, "S", "Duration of a push, else the gait's own");
  addNumber(crawl, "--turn-rad", arguments.turn_rad, -0.2, 0.2, "RAD",
            "Turn by this in each push, to the left (0)");
  crawl.add_flag("--standing", arguments.is_from_standing,
                 "The table also goes down from standing before, and gets up after");
  addOutputFile(crawl, "--out", arguments.out, "FILE|-",
                "The joint table; .csv, or .json as NAOqi takes it; - for CSV on standard output");
  addOutputFile(crawl, "--plot", arguments.plot, "FILE.svg", "Draw the push and the cycles");
  addOutputFile(crawl, "--html", arguments.html, "FILE.html", "Animate the cycles, seen from the side");
  crawl.footer(kCrawlExamples);
  return crawl;
}

}  // namespace

Subcommand addGaitCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("gait", "Make, choose and look at gaits");
  command.require_subcommand(0, 1);  // none at all is told below, in our own words
  command.footer(kExamples);
  const auto arguments = std::make_shared<CrawlArguments>();
  const auto folder = std::make_shared<std::string>("gaits");
  CLI::App& crawl = addCrawl(command, *arguments);
  CLI::App& list = *command.add_subcommand("list", "The gaits that come along");
  CLI::App& made = *command.add_subcommand("make", "Make the gaits that come along again, from fixed seeds");
  made.add_option("--out", *folder, "Where to write them")->capture_default_str()->type_name("DIR");
  CLI::App* optimised = nullptr;
  const auto optimise = addOptimise(command, optimised);
  return {&command, [=, crawl = &crawl, list = &list, made = &made] {
            if (crawl->parsed()) return runCrawl(*arguments);
            if (list->parsed()) return runList();
            if (made->parsed()) return runMake(*folder);
            if (optimised->parsed()) return optimise();
            return refuse("what to do with gaits is missing; give list, crawl, optimise or make, or --help");
          }};
}

}  // namespace underway
