#include "apps/roadmap_store.hpp"

#include <filesystem>
#include <system_error>

#include "apps/terminal.hpp"
#include "apps/text_file.hpp"

namespace underway {
namespace {

std::string sentenceOf(const Loaded& loaded) {
  const std::string batches = std::to_string(loaded.batches) + " batches";
  if (loaded.is_of_this_world) return "loaded, " + batches;
  return "loaded, " + batches + "; it was made for another map, so its ways were looked at again: " +
         std::to_string(loaded.repair.closed) + " are blocked here, " + std::to_string(loaded.repair.opened) +
         " have become free";
}

}  // namespace

void RoadmapStore::tell(const std::string& what) const { complain("roadmap " + file_ + ": " + what); }

void RoadmapStore::loadInto(Planner& planner) {
  std::error_code error;
  if (file_.empty() || !std::filesystem::exists(file_, error)) return;
  Expected<std::string> bytes = readText(file_);
  is_ours_ = bytes && (bytes->empty() || isRoadmapFile(*bytes));
  if (!bytes) return tell("not used, " + bytes.error().message);
  if (!is_ours_) return tell("not used and not written over, it is no roadmap file; give another name");
  const Expected<Loaded> loaded = planner.load(*bytes);
  if (!loaded) return tell("refused, growing anew; " + loaded.error().message);
  kept_ = *std::move(bytes);
  tell(sentenceOf(*loaded));
}

void RoadmapStore::saveFrom(const Planner& planner) {
  if (file_.empty() || !is_ours_) return;
  std::string bytes = planner.save();
  if (bytes.empty() || bytes == kept_) return;
  if (const Expected<void> written = replaceText(file_, bytes); !written)
    return tell(written.error().message);
  kept_ = std::move(bytes);
  tell("saved, " + std::to_string(planner.roadmap()->batches) + " batches");
}

}  // namespace underway
