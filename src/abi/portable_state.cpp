/// The state of a contact for another process: a header that identifies it, then the bytes of
/// wrc_contact_save() without addresses.
#include <cstddef>
#include <cstring>

#include "abi/handles.hpp"
#include "abi/structs.hpp"
#include "base/checksum.hpp"

namespace wrc::abi {
namespace {

/// All numbers as this machine has them; `byte_order` tells which way that is.
struct PortableHeader {
  char mark[8];                 ///< "wrcstate"
  std::uint32_t byte_order;     ///< 0x01020304
  std::uint32_t format;         ///< version of this header and of the bytes behind it
  std::uint32_t version;        ///< library that wrote it: wrc_version()
  std::uint32_t side;           ///< enum wrc_side
  std::uint64_t bytes;          ///< header included
  std::uint64_t configuration;  ///< fingerprint of the model
  std::uint64_t layout;         ///< checksum of the offsets of its arrays
  std::uint64_t reserved;       ///< 0
  std::uint64_t checksum;       ///< over the header before, and the state
};
static_assert(sizeof(PortableHeader) == 64);

constexpr char portable_mark[8] = {'w', 'r', 'c', 's', 't', 'a', 't', 'e'};
constexpr std::uint32_t native_order = 0x01020304, other_order = 0x04030201, portable_format = 1;
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ || __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__);

std::uint64_t layout_of(const contact::Model& model) {
  Checksum sum;
  sum.add(std::uint64_t{sizeof(contact::Contact)});
  for (const std::size_t offset : model.layout.offset)
    if (offset < model.layout.bytes) sum.add(std::uint64_t{offset});
  return sum.value();
}

std::uint64_t checksum_of(const PortableHeader& header, const void* state, std::size_t bytes) {
  Checksum sum;
  sum.add(&header, offsetof(PortableHeader, checksum));
  sum.add(state, bytes);
  return sum.value();
}

/// Addresses of this process stand in the first member, the model, and in the sentence's parts; the rest are
/// numbers.
static_assert(offsetof(contact::Contact, model) == 0 &&
              offsetof(contact::Contact, last) < 2 * sizeof(double));
constexpr std::size_t addressed = offsetof(contact::Contact, last) + sizeof(Fault);

/// The beginning of a state without addresses: of the last fault its status and number of an element.
void without_addresses(const contact::Contact& contact, unsigned char (&bytes)[addressed]) {
  std::memset(bytes, 0, sizeof bytes);
  const Fault last{.status = contact.last.status, .index = contact.last.index, .flags = contact.last.flags};
  std::memcpy(bytes + sizeof(void*), &last, sizeof last);
}

Fault damaged(const char* cause) { return Fault::file("buffer", cause); }

/// Is this a state of that contact's configuration, whole?
Fault check_header(const contact::Contact& contact, const PortableHeader& header, std::uint64_t bytes) {
  const contact::Model& model = *contact.model;
  if (std::memcmp(header.mark, portable_mark, sizeof portable_mark) != 0)
    return damaged("it does not begin as wrc_contact_save_portable has it");
  if (header.byte_order == other_order)
    return Fault::unsupported("buffer", "it was written on a machine of the other byte order");
  if (header.byte_order != native_order || header.bytes < sizeof header)
    return damaged("its header has changed since it was written");
  if (header.format != portable_format || header.version != wrc_version())
    return Fault::unsupported("version that wrote the state",
                              {header.version, "", wrc_version(), wrc_version()},
                              "as wrc_version() counts: states pass between libraries of one version");
  if (bytes < header.bytes)
    return Fault::file("bytes", {bytes, "", header.bytes, header.bytes}, "the end is missing");
  if (header.configuration != model.configuration || header.layout != layout_of(model) ||
      header.bytes != sizeof header + contact::state_bytes(model))
    return Fault::sequence("buffer", "it is of a contact whose configuration or profiles are others");
  if (header.side != static_cast<std::uint32_t>(contact.side))
    return Fault::sequence("buffer", "it holds the state of a contact of the other side");
  return {};
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;
using wrc::Fault;

extern "C" {

int32_t wrc_contact_portable_size(const wrc_model* model, uint64_t* bytes) {
  if (bytes == nullptr) return WRC_ERROR_NULL;
  *bytes = 0;
  if (!abi::valid(model)) return WRC_ERROR_NULL;
  *bytes = sizeof(abi::PortableHeader) + wrc::contact::state_bytes(*model->model);
  return WRC_OK;
}

int32_t wrc_contact_save_portable(wrc_contact* handle, void* buffer, uint64_t bytes) {
  if (!abi::valid(handle)) return WRC_ERROR_NULL;
  const wrc::contact::Contact& contact = *handle->contact;
  const std::size_t state = wrc::contact::state_bytes(*contact.model);
  if (buffer == nullptr) return abi::keep(*handle, __func__, Fault::null("buffer"));
  if (bytes < sizeof(abi::PortableHeader) + state)
    return abi::keep(
        *handle, __func__,
        Fault::buffer("bytes", {bytes, ""}, "a portable state is as long as wrc_contact_portable_size says"));
  auto* const begin = static_cast<unsigned char*>(buffer) + sizeof(abi::PortableHeader);
  std::memcpy(begin, handle->contact, state);
  unsigned char first[abi::addressed];
  abi::without_addresses(contact, first);
  std::memcpy(begin, first, sizeof first);
  abi::PortableHeader header{};
  std::memcpy(header.mark, abi::portable_mark, sizeof header.mark);
  header.byte_order = abi::native_order;
  header.format = abi::portable_format;
  header.version = wrc_version();
  header.side = static_cast<std::uint32_t>(contact.side);
  header.bytes = sizeof header + state;
  header.configuration = contact.model->configuration;
  header.layout = abi::layout_of(*contact.model);
  header.checksum = abi::checksum_of(header, begin, state);
  std::memcpy(buffer, &header, sizeof header);
  return WRC_OK;
}

int32_t wrc_contact_restore_portable(wrc_contact* handle, const void* buffer, uint64_t bytes) {
  if (!abi::valid(handle)) return WRC_ERROR_NULL;
  wrc::contact::Contact& contact = *handle->contact;
  abi::PortableHeader header{};
  Fault fault;
  if (buffer == nullptr) {
    fault = Fault::null("buffer");
  } else if (bytes < sizeof header) {
    fault = abi::damaged("it is too short for a header: the end is missing");
  } else {
    std::memcpy(&header, buffer, sizeof header);
    fault = abi::check_header(contact, header, bytes);
  }
  const std::size_t state = wrc::contact::state_bytes(*contact.model);
  const auto* const begin =
      fault.failed() ? nullptr : static_cast<const unsigned char*>(buffer) + sizeof header;
  if (!fault.failed() && header.checksum != abi::checksum_of(header, begin, state))
    fault = abi::damaged("bytes of it have changed since it was written");
  if (fault.failed()) return abi::keep(*handle, __func__, fault);
  take_state(contact, begin);
  return WRC_OK;
}

}  // extern "C"
