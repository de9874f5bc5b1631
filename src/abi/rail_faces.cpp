/// wrc_profiles.h: measured sections of a turnout behind the C interface. Offline: it allocates.
#include "profiles/rail_faces.hpp"

#include <memory>
#include <string>
#include <vector>

#include "abi/guarded.hpp"
#include "abi/structs.hpp"
#include "wrc/wrc_profiles.h"

/// Faces, and the sections of a model that point into them.
struct wrc_rail_faces {
  std::uint64_t tag;
  wrc::profiles::RailFaces found;
  std::vector<wrc_rail_section> sections;
};

namespace wrc::abi {
namespace {

constexpr std::uint64_t faces_tag = 0x7365636166;  // "faces"

bool is_faces(const wrc_rail_faces* handle) { return handle != nullptr && handle->tag == faces_tag; }

using profiles::FaceKind;
static_assert(same<WRC_FACE_RAIL>(FaceKind::rail) && same<WRC_FACE_STOCK>(FaceKind::stock) &&
              same<WRC_FACE_BLADE>(FaceKind::blade) && same<WRC_FACE_WING>(FaceKind::wing) &&
              same<WRC_FACE_NOSE>(FaceKind::nose) && same<WRC_FACE_CHECK>(FaceKind::check));

/// Lines of the caller, which may have gaps.
Fault read_lines(const wrc_rail_faces_problem& ours, std::vector<profiles::MeasuredSection>& sections) {
  for (std::uint32_t k = 0; k < ours.section_count; ++k) {
    wrc_section_line section;
    Fault fault = read(&ours.sections[k], "problem.sections", section);
    fault.index = static_cast<std::int32_t>(k);
    fault.distance = section.distance;
    if (fault.failed()) return fault;
    sections.push_back(
        {section.distance, {{section.y, section.y + section.count}, {section.z, section.z + section.count}}});
  }
  return {};
}

/// Sections of a model: faces one after the other, without check rails.
std::vector<wrc_rail_section> sections_of(const std::vector<profiles::Face>& faces) {
  std::vector<wrc_rail_section> sections;
  std::int32_t surface = 0;
  for (const profiles::Face& face : faces) {
    if (face.kind == FaceKind::check) continue;
    for (const profiles::FaceOutline& each : face.outlines) {
      wrc_rail_section section = defaults<wrc_rail_section>();
      section.distance = each.distance;
      section.z = each.top;
      section.surface = surface;
      section.mark_count = static_cast<std::uint32_t>(each.marks.size());
      section.marks = each.marks.empty() ? nullptr : each.marks.data();
      section.profile.kind = WRC_PROFILE_POINTS;
      section.profile.count = static_cast<std::uint32_t>(each.profile.size());
      section.profile.y = each.profile.y.data();
      section.profile.z = each.profile.z.data();
      sections.push_back(section);
    }
    ++surface;
  }
  return sections;
}

/// `why`: sentence of a section that cannot be used, which outlives the fault.
Fault create_faces(const wrc_rail_faces_problem* theirs, wrc_rail_faces*& handle, std::string& why) {
  wrc_rail_faces_problem ours;
  RETURN_IF_FAILED(read(theirs, "problem", ours));
  profiles::FacesProblem problem;
  RETURN_IF_FAILED(read_lines(ours, problem.sections));
  problem.interruptions.assign(ours.interruptions, ours.interruptions + ours.interruption_count);
  problem.first = ours.first;
  problem.last = ours.last;
  problem.depth = ours.depth;
  problem.gap = ours.gap;
  problem.kink = ours.kink;
  problem.least_width = ours.least_width;
  problem.tolerance = ours.tolerance;
  problem.most_faces = static_cast<std::size_t>(MEMBER(wrc_rail_section, "surface").high) + 1;
  auto made = std::make_unique<wrc_rail_faces>();
  made->tag = faces_tag;
  RETURN_IF_FAILED(profiles::find_faces(problem, made->found, why));
  made->sections = sections_of(made->found.faces);
  handle = made.release();
  return {};
}

Fault faces_found(const wrc_rail_faces* handle, wrc_found_faces* found) {
  wrc_found_faces into;
  RETURN_IF_FAILED(clear(found));
  RETURN_IF_FAILED(read(found, "found", into));
  if (!is_faces(handle)) return Fault::null("faces");
  into.face_count = static_cast<std::uint32_t>(handle->found.faces.size());
  for (const profiles::Face& face : handle->found.faces)
    into.outline_count += static_cast<std::uint32_t>(face.outlines.size());
  into.rail_section_count = static_cast<std::uint32_t>(handle->sections.size());
  into.rail_section_size = sizeof(wrc_rail_section);
  into.rail_sections = handle->sections.data();
  into.notes = handle->found.notes.c_str();
  into.thin = handle->found.thin.c_str();
  write(into, found);
  return {};
}

Fault face_outline(const wrc_rail_faces* handle, std::uint32_t index, wrc_face_outline* outline) {
  wrc_face_outline into;
  RETURN_IF_FAILED(clear(outline));
  RETURN_IF_FAILED(read(outline, "outline", into));
  if (!is_faces(handle)) return Fault::null("faces");
  std::size_t first = 0, f = 0;
  const std::vector<profiles::Face>& faces = handle->found.faces;
  while (f < faces.size() && index - first >= faces[f].outlines.size()) first += faces[f++].outlines.size();
  if (f == faces.size())
    return Fault::range("index", {index, ""}, "found.outline_count says how many there are");
  const profiles::FaceOutline& each = faces[f].outlines[index - first];
  into.kind = static_cast<std::int32_t>(faces[f].kind);
  into.face = static_cast<std::uint32_t>(f);
  into.number = static_cast<std::uint32_t>(each.number);
  into.count = static_cast<std::uint32_t>(each.line.size());
  into.mark_count = static_cast<std::uint32_t>(each.marks.size());
  into.distance = each.distance;
  into.spacing_error = each.spacing_error;
  into.y = each.line.y.data();
  into.z = each.line.z.data();
  into.marks = each.marks.empty() ? nullptr : each.marks.data();
  write(into, outline);
  return {};
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;

extern "C" {

int32_t wrc_rail_faces_create(const wrc_rail_faces_problem* problem, wrc_rail_faces** faces, char* text,
                              uint64_t size) {
  if (faces != nullptr) *faces = nullptr;
  std::string why;
  const auto create = [&] {
    return faces == nullptr ? wrc::Fault::null("faces") : abi::create_faces(problem, *faces, why);
  };
  return abi::finish(__func__, abi::guarded(create, "problem.section_count", "there is not enough memory"),
                     text, size);
}

int32_t wrc_rail_faces_found(const wrc_rail_faces* faces, wrc_found_faces* found) {
  return abi::faces_found(faces, found).status;
}

int32_t wrc_rail_faces_outline(const wrc_rail_faces* faces, uint32_t index, wrc_face_outline* outline) {
  return abi::face_outline(faces, index, outline).status;
}

void wrc_rail_faces_destroy(wrc_rail_faces* faces) {
  if (!abi::is_faces(faces)) return;
  faces->tag = 0;
  delete faces;
}

}  // extern "C"
