/// How a stage of a contact is run, whichever file it lies in.
#pragma once

#include <type_traits>

#include "abi/fp_environment.hpp"
#include "abi/handles.hpp"
#include "abi/structs.hpp"

namespace wrc::abi {

/// Runs one call on a contact: the host's floating-point environment set aside, the outcome kept for
/// wrc_contact_last_error. `function`: its name, with which the sentence begins. `cleared`: fault of clearing
/// the outputs; they are zeroed before the handle is looked at, so that a call without a contact
/// leaves no old numbers behind either.
template <typename Work>
std::int32_t call(const char* function, wrc_contact* handle, const Fault& cleared, Work&& work) noexcept {
  if (!valid(handle)) return WRC_ERROR_NULL;
  const FloatingPointScope scope;
  contact::Contact& contact = *handle->contact;
  return keep(*handle, function, cleared.failed() ? cleared : work(contact));
}

/// Element of an array of the caller's, `offset` bytes behind the first; none of no array.
template <typename Element>
Element* element(Element* first, std::uint64_t offset) {
  using Byte = std::conditional_t<std::is_const_v<Element>, const char, char>;
  return first == nullptr ? nullptr : reinterpret_cast<Element*>(reinterpret_cast<Byte*>(first) + offset);
}

/// `one` for each contact, in order, with its input and its output; the gravest status. An array that is
/// missing is a NULL in every call, so that the outputs there are get zeroed.
template <typename Input, typename Output, typename One>
std::int32_t batch(wrc_contact* const* contacts, std::uint32_t count, const Input* inputs,
                   std::uint64_t input_stride, Output* outputs, std::uint64_t output_stride,
                   std::int32_t* statuses, One&& one) {
  const bool missing = contacts == nullptr || inputs == nullptr || outputs == nullptr;
  Fault gravest{.status = missing ? WRC_ERROR_NULL : WRC_OK};
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int32_t status = one(contacts == nullptr ? nullptr : contacts[i],
                                    element(inputs, i * input_stride), element(outputs, i * output_stride));
    if (statuses != nullptr) statuses[i] = status;
    keep_worst(gravest, Fault{.status = status});
  }
  return gravest.status;
}

}  // namespace wrc::abi
