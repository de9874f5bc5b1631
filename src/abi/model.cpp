/// wrc_model and wrc_contact: size, init in the caller's memory, create, destroy, save, restore.
#include <cmath>
#include <cstdlib>
#include <cstring>
#if defined(_WIN32)
#include <malloc.h>
#endif

#include "abi/guarded.hpp"
#include "abi/handles.hpp"
#include "abi/message.hpp"
#include "abi/model_options.hpp"
#include "abi/structs.hpp"

namespace wrc::abi {
namespace {

bool aligned(const void* memory) {
  return reinterpret_cast<std::uintptr_t>(memory) % contact::block_alignment == 0;
}

#if defined(_WIN32)  // its C library has no aligned_alloc, and free() takes no aligned memory
void* default_allocate(void*, std::uint64_t bytes, std::uint64_t alignment) {
  return _aligned_malloc(bytes, alignment);
}
void default_release(void*, void* memory) { _aligned_free(memory); }
#else
void* default_allocate(void*, std::uint64_t bytes, std::uint64_t alignment) {
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}
void default_release(void*, void* memory) { std::free(memory); }
#endif

Fault buffer_fault(const void* memory, std::uint64_t bytes, std::size_t needed) {
  if (memory == nullptr) return Fault::null("memory");
  if (!aligned(memory)) {
    return Fault::buffer("memory", "it must be aligned to 64 bytes");
  }
  if (bytes < needed) {
    return Fault::buffer("bytes", {bytes, "bytes", needed, 1e18});
  }
  return {};
}

/// The file that a fault is about.
const char* file_of(const Fault& fault, const contact::ModelOptions& options) {
  return fault.status == WRC_ERROR_FILE ? options.force_table : nullptr;
}

Fault init_model(const contact::ModelOptions& options, void* memory, std::uint64_t bytes,
                 wrc_model*& handle) {
  RETURN_IF_FAILED(buffer_fault(memory, bytes, sizeof(wrc_model) + contact::model_bytes(options)));
  auto* made = static_cast<wrc_model*>(memory);
  *made = {};
  const Fault shape =
      contact::make_model(options, static_cast<char*>(memory) + sizeof(wrc_model), made->model);
  if (shape.failed()) return shape;
  made->tag = model_tag;
  handle = made;
  constexpr double rounding = 1e-9;
  if (std::abs(options.coupling) > rounding)
    return Fault::dissimilar_materials("K", {options.coupling, ""},
                                       "its leading part is in wrc_contact_wrench(), by strip FASTSIM");
  return {};
}

Fault check_contact(const wrc_model* model, std::int32_t side, wrc_contact** contact) {
  if (contact == nullptr) return Fault::null("contact");
  if (!valid(model))
    return Fault::null("model",
                       "it is NULL, or it is not a model: was wrc_model_create called, and did it succeed?");
  if (side == WRC_SIDE_RIGHT || side == WRC_SIDE_LEFT) return {};
  return Fault::unsupported("side", {side, ""}, enumerations::wrc_side.names);
}

/// Makes a contact in memory that is large enough and aligned.
wrc_contact* init_contact(const wrc_model& model, std::int32_t side, void* memory) {
  auto* made = static_cast<wrc_contact*>(memory);
  *made = {};
  made->contact = &contact::make_contact(*model.model, static_cast<geometry::Side>(side),
                                         static_cast<char*>(memory) + sizeof(wrc_contact));
  made->tag = contact_tag;
  return made;
}

/// guarded() for calls whose memory is the model's: its status says enough.
template <typename Work>
Fault guarded_model(Work&& work) {
  return guarded(work, nullptr, nullptr);
}

Fault check_state_room(const void* buffer, std::uint64_t bytes, std::size_t needed) {
  if (buffer == nullptr) return Fault::null("buffer");
  if (bytes >= needed) return {};
  return Fault::buffer("bytes", {bytes, ""}, "a saved state is as long as wrc_contact_state_size says");
}

}  // namespace

Fault allocate(const wrc_allocator* allocator, std::size_t bytes, void*& memory, wrc_allocator& source) {
  source = defaults<wrc_allocator>();
  if (allocator != nullptr) {
    RETURN_IF_FAILED(read(allocator, "allocator", source));
    if ((source.allocate == nullptr) != (source.release == nullptr)) {
      return Fault::null("allocator", "give both allocate and release, or neither");
    }
  }
  if (source.allocate == nullptr) {
    source.allocate = default_allocate;
    source.release = default_release;
  }
  memory = source.allocate(source.user, bytes, contact::block_alignment);
  if (memory == nullptr) {
    return Fault::memory("allocate", {bytes, "bytes"}, "the allocator returned NULL");
  }
  if (!aligned(memory)) {
    source.release(source.user, memory);
    return Fault::buffer("allocate", "the allocator ignored the alignment asked for");
  }
  return {};
}

}  // namespace wrc::abi

using wrc::Fault;
namespace abi = wrc::abi;

extern "C" {

int32_t wrc_config_check(const wrc_config* config, char* text, uint64_t size) {
  wrc::contact::ModelOptions options;
  const Fault fault = abi::guarded_model([&] {
    Fault found = abi::read_options(config, options);
    if (found.failed()) return found;
    const std::size_t bytes = sizeof(wrc_model) + wrc::contact::model_bytes(options);
    void* memory = abi::default_allocate(nullptr, bytes, wrc::contact::block_alignment);
    if (memory == nullptr) return Fault::memory();
    wrc_model* unused = nullptr;
    found = abi::init_model(options, memory, bytes, unused);
    abi::default_release(nullptr, memory);
    return found;
  });
  return abi::finish(__func__, fault, text, size, abi::file_of(fault, options));
}

int32_t wrc_model_size(const wrc_config* config, uint64_t* bytes, uint64_t* alignment) {
  if (bytes != nullptr) *bytes = 0;
  if (alignment != nullptr) *alignment = 0;
  if (bytes == nullptr || alignment == nullptr) return WRC_ERROR_NULL;
  return abi::guarded_model([&] {
           wrc::contact::ModelOptions options;
           RETURN_IF_FAILED(abi::read_options(config, options));
           *bytes = sizeof(wrc_model) + wrc::contact::model_bytes(options);
           *alignment = wrc::contact::block_alignment;
           return Fault{};
         })
      .status;
}

int32_t wrc_model_init(const wrc_config* config, void* memory, uint64_t bytes, wrc_model** model, char* text,
                       uint64_t size) {
  if (model != nullptr) *model = nullptr;
  wrc::contact::ModelOptions options;
  const Fault fault = abi::guarded_model([&]() -> Fault {
    if (model == nullptr) return Fault::null("model");
    const Fault read = abi::read_options(config, options);
    return read.failed() ? read : abi::init_model(options, memory, bytes, *model);
  });
  return abi::finish(__func__, fault, text, size, abi::file_of(fault, options));
}

int32_t wrc_model_create(const wrc_config* config, const wrc_allocator* allocator, wrc_model** model,
                         char* text, uint64_t size) {
  if (model != nullptr) *model = nullptr;
  wrc::contact::ModelOptions options;
  const Fault outcome = abi::guarded_model([&]() -> Fault {
    if (model == nullptr) return Fault::null("model");
    Fault fault = abi::read_options(config, options);
    if (fault.failed()) return fault;
    const std::size_t bytes = sizeof(wrc_model) + wrc::contact::model_bytes(options);
    void* memory = nullptr;
    wrc_allocator source;
    fault = abi::allocate(allocator, bytes, memory, source);
    if (fault.failed()) return fault;
    fault = abi::init_model(options, memory, bytes, *model);
    if (fault.failed()) {
      source.release(source.user, memory);
      return fault;
    }
    (*model)->release = source.release;
    (*model)->user = source.user;
    return fault;
  });
  return abi::finish(__func__, outcome, text, size, abi::file_of(outcome, options));
}

int32_t wrc_model_profile(const wrc_model* model, int32_t side, int32_t body, wrc_view* y, wrc_view* z,
                          double* deviation) {
  if (deviation != nullptr) *deviation = 0.0;
  const Fault cleared = abi::first_of({abi::clear(y), abi::clear(z)});
  if (!abi::valid(model)) return WRC_ERROR_NULL;
  if (cleared.failed()) return cleared.status;
  const wrc::contact::Model& ours = *model->model;
  if (body != WRC_BODY_WHEEL && body != WRC_BODY_RAIL) return WRC_ERROR_UNSUPPORTED;
  if (side != WRC_SIDE_RIGHT && side != WRC_SIDE_LEFT) return WRC_ERROR_UNSUPPORTED;
  if (!ours.has_geometry) return WRC_ERROR_SEQUENCE;
  const bool wheel = body == WRC_BODY_WHEEL;
  const wrc::contact::Bodies& placed = ours.bodies[side];
  const wrc::geometry::Profile& profile = wheel ? placed.wheel.profile : placed.rail.profile;
  wrc_view view = abi::defaults<wrc_view>();
  view.count = static_cast<uint64_t>(profile.count);
  view.data = profile.y;
  abi::write(view, y);
  view.data = profile.z;
  abi::write(view, z);
  if (deviation != nullptr) *deviation = wheel ? ours.wheel_deviation : ours.rail_deviation;
  return WRC_OK;
}

void wrc_model_destroy(wrc_model* model) {
  if (!abi::valid(model)) return;
  model->tag = 0;
  if (model->release != nullptr) model->release(model->user, model);
}

int32_t wrc_contact_size(const wrc_model* model, uint64_t* bytes, uint64_t* alignment) {
  if (bytes != nullptr) *bytes = 0;
  if (alignment != nullptr) *alignment = 0;
  if (bytes == nullptr || alignment == nullptr || !abi::valid(model)) return WRC_ERROR_NULL;
  *bytes = sizeof(wrc_contact) + wrc::contact::contact_bytes(*model->model);
  *alignment = wrc::contact::block_alignment;
  return WRC_OK;
}

int32_t wrc_contact_init(const wrc_model* model, int32_t side, void* memory, uint64_t bytes,
                         wrc_contact** contact, char* text, uint64_t size) {
  if (contact != nullptr) *contact = nullptr;
  Fault fault = abi::check_contact(model, side, contact);
  if (!fault.failed())
    fault =
        abi::buffer_fault(memory, bytes, sizeof(wrc_contact) + wrc::contact::contact_bytes(*model->model));
  if (!fault.failed()) *contact = abi::init_contact(*model, side, memory);
  return abi::finish(__func__, fault, text, size);
}

int32_t wrc_contact_create(const wrc_model* model, int32_t side, const wrc_allocator* allocator,
                           wrc_contact** contact, char* text, uint64_t size) {
  if (contact != nullptr) *contact = nullptr;
  void* memory = nullptr;
  wrc_allocator source;
  Fault fault = abi::check_contact(model, side, contact);
  if (!fault.failed())
    fault = abi::guarded_model([&] {
      return abi::allocate(allocator, sizeof(wrc_contact) + wrc::contact::contact_bytes(*model->model),
                           memory, source);
    });
  if (!fault.failed()) {
    *contact = abi::init_contact(*model, side, memory);
    (*contact)->release = source.release;
    (*contact)->user = source.user;
  }
  return abi::finish(__func__, fault, text, size);
}

void wrc_contact_destroy(wrc_contact* contact) {
  if (!abi::valid(contact)) return;
  contact->tag = 0;
  if (contact->release != nullptr) contact->release(contact->user, contact);
}

int32_t wrc_contact_state_size(const wrc_model* model, uint64_t* bytes) {
  if (bytes == nullptr) return WRC_ERROR_NULL;
  *bytes = abi::valid(model) ? wrc::contact::state_bytes(*model->model) : 0;
  return *bytes > 0 ? WRC_OK : WRC_ERROR_NULL;
}

int32_t wrc_contact_save(wrc_contact* contact, void* buffer, uint64_t bytes) {
  if (!abi::valid(contact)) return WRC_ERROR_NULL;
  const std::size_t needed = wrc::contact::state_bytes(*contact->contact->model);
  const Fault fault = abi::check_state_room(buffer, bytes, needed);
  if (fault.failed()) return abi::keep(*contact, __func__, fault);
  std::memcpy(buffer, contact->contact, needed);
  return WRC_OK;
}

int32_t wrc_contact_restore(wrc_contact* contact, const void* buffer, uint64_t bytes) {
  if (!abi::valid(contact)) return WRC_ERROR_NULL;
  void* const state = contact->contact;
  const std::size_t needed = wrc::contact::state_bytes(*contact->contact->model);
  Fault fault = abi::check_state_room(buffer, bytes, needed);
  if (fault.failed()) {
    // its sentence stays
  } else if (std::memcmp(buffer, state, sizeof(void*)) != 0) {  // it begins with the pointer to its model
    fault = Fault::sequence("buffer", "it does not hold a state saved from a contact of this model");
  } else if (std::memcmp(static_cast<const char*>(buffer) + offsetof(wrc::contact::Contact, side),
                         &contact->contact->side, sizeof(wrc::geometry::Side)) != 0) {
    fault = Fault::sequence("buffer", "it holds the state of a contact of the other side");
  }
  if (fault.failed()) return abi::keep(*contact, __func__, fault);
  take_state(*contact->contact, buffer);
  return WRC_OK;
}

int32_t wrc_contact_last_error(const wrc_contact* contact, char* buffer, uint64_t size) {
  if (buffer != nullptr && size > 0) buffer[0] = '\0';
  if (!abi::valid(contact) || buffer == nullptr) return WRC_ERROR_NULL;
  if (size == 0) return WRC_ERROR_BUFFER;
  abi::write_sentence(contact->contact->last, buffer, size);
  return WRC_OK;
}

}  // extern "C"
