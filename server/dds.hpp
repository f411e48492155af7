#pragma once

#include <dds/dds.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/error.hpp"
#include "server/domain.hpp"

/// A thin layer over Cyclone DDS' C interface: ownership, and errors as values (kInternal, with the DDS
/// reason).
namespace underway::dds {

using Clock = std::chrono::steady_clock;

/// Owns an entity and with it its children. Move-only; moved-from owns nothing.
class Entity {
 public:
  Entity() = default;
  explicit Entity(dds_entity_t handle) : handle_(handle) {}
  ~Entity() { reset(); }
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    if (this != &other) {
      reset();
      handle_ = std::exchange(other.handle_, 0);
    }
    return *this;
  }
  [[nodiscard]] dds_entity_t get() const { return handle_; }

 private:
  void reset() {
    if (handle_ > 0) dds_delete(handle_);
    handle_ = 0;
  }
  dds_entity_t handle_ = 0;
};

/// The reason of a negative return code, after what was being done: "cannot create ...: ...".
[[nodiscard]] tl::unexpected<Error> failure(const std::string& what, dds_return_t code);

[[nodiscard]] Expected<Entity> createParticipant(const Domain& domain);
[[nodiscard]] Expected<Entity> createTopic(const Entity& participant, const dds_topic_descriptor_t& type,
                                           const char* name);

/// RELIABLE unless it says otherwise, KEEP_LAST.
struct EndpointOptions {
  std::string partition = {};                 ///< "": the default partition
  std::int32_t depth = 1;                     ///< samples kept
  std::string user_data = {};                 ///< told to matched peers
  std::chrono::milliseconds max_blocking{0};  ///< of a write, when a peer does not keep up
  bool is_for_latecomers = false;             ///< TRANSIENT_LOCAL rather than VOLATILE
  bool is_best_effort = false;                ///< of a reader: takes what writers of either kind send
  bool is_plain_cdr = false;                  ///< XCDR version 1 alone, which is what ROS 2 speaks
};
[[nodiscard]] Expected<Entity> createReader(const Entity& participant, const Entity& topic,
                                            const EndpointOptions& options);
[[nodiscard]] Expected<Entity> createWriter(const Entity& participant, const Entity& topic,
                                            const EndpointOptions& options);
/// Triggers while the reader holds anything.
[[nodiscard]] Expected<Entity> createReadCondition(const Entity& reader);
/// Triggered by dds_set_guardcondition, from any thread.
[[nodiscard]] Expected<Entity> createGuardCondition(const Entity& participant);

/// The user data of the readers that a writer is matched with; "" for those that have none.
[[nodiscard]] std::vector<std::string> userDataOfReaders(const Entity& writer);

/// Sleeps until something happens. Attached entities may be deleted before it.
class WaitSet {
 public:
  WaitSet() = default;
  [[nodiscard]] static Expected<WaitSet> create(const Entity& participant);
  [[nodiscard]] Expected<void> attach(const Entity& entity, dds_attach_t token);
  /// The tokens of what is triggered; empty when the time comes first. Clock::time_point::max() waits for
  /// ever.
  [[nodiscard]] Expected<std::vector<dds_attach_t>> wait(Clock::time_point until);

 private:
  explicit WaitSet(Entity entity) : entity_(std::move(entity)) {}
  Entity entity_;
};

/// Samples on loan from a reader, given back at the end.
class Loan {
 public:
  static constexpr std::size_t kMost = 64;
  [[nodiscard]] static Expected<std::unique_ptr<Loan>> take(const Entity& reader);
  ~Loan();
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;

  [[nodiscard]] std::size_t size() const { return count_; }
  /// Calls visit(const T&) for each sample that holds data.
  template <class T, class Visit>
  void forEach(Visit visit) const {
    forEachFrom<T>([&](const T& sample, dds_instance_handle_t) { visit(sample); });
  }
  /// Calls visit(const T&, dds_instance_handle_t writer), which tells writers apart.
  template <class T, class Visit>
  void forEachFrom(Visit visit) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (infos_[i].valid_data) visit(*static_cast<const T*>(samples_[i]), infos_[i].publication_handle);
  }

 private:
  explicit Loan(dds_entity_t reader) : reader_(reader) {}
  dds_entity_t reader_;
  std::size_t count_ = 0;
  void* samples_[kMost] = {};
  dds_sample_info_t infos_[kMost] = {};
};

}  // namespace underway::dds
