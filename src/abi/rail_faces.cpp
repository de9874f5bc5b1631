/// wrc_profiles.h: measured sections of a turnout behind the C interface. Offline: it allocates.
#include "profiles/rail_faces.hpp"

#include <memory>
#include <string>
#include <vector>

#include "abi/guarded.hpp"
#include "abi/structs.hpp"
#include "profiles/section_file.hpp"
#include "wrc/wrc_profiles.h"

/// Faces, and the sections of a model that point into them.
struct wrc_rail_faces {
  std::uint64_t tag;
  wrc::profiles::RailFaces found;
  std::vector<wrc_rail_section> sections;
};

/// Sections of a file.
struct wrc_section_file {
  std::uint64_t tag;
  std::vector<wrc::profiles::MeasuredSection> sections;
};

namespace wrc::abi {
namespace {

constexpr std::uint64_t faces_tag = 0x7365636166;     // "faces"
constexpr std::uint64_t file_tag = 0x6e6f6974636573;  // "section"

bool is_faces(const wrc_rail_faces* handle) { return handle != nullptr && handle->tag == faces_tag; }
bool is_file(const wrc_section_file* handle) { return handle != nullptr && handle->tag == file_tag; }

using profiles::FaceKind;
static_assert(same<WRC_FACE_RAIL>(FaceKind::rail) && same<WRC_FACE_STOCK>(FaceKind::stock) &&
              same<WRC_FACE_BLADE>(FaceKind::blade) && same<WRC_FACE_WING>(FaceKind::wing) &&
              same<WRC_FACE_NOSE>(FaceKind::nose) && same<WRC_FACE_CHECK>(FaceKind::check));

/// Lines of the caller, which may have gaps. `name`: of the argument.
Fault read_lines(const wrc_section_line* lines, std::uint32_t count, const char* name,
                 std::vector<profiles::MeasuredSection>& sections) {
  for (std::uint32_t k = 0; k < count; ++k) {
    wrc_section_line section;
    Fault fault = read(&lines[k], name, section);
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
  RETURN_IF_FAILED(read_lines(ours.sections, ours.section_count, "problem.sections", problem.sections));
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
  wrc_found_faces into{};
  RETURN_IF_FAILED(clear(found));
  if (found == nullptr) return Fault::null("found");
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
  wrc_face_outline into{};
  RETURN_IF_FAILED(clear(outline));
  if (outline == nullptr) return Fault::null("outline");
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

/// `why`: sentence of a file that cannot be used, which outlives the fault.
Fault read_file(const char* path, const profiles::FileAxes& axes, wrc_section_file*& handle,
                std::string& why) {
  if (path == nullptr) return Fault::null("path");
  if (axes.unit != 0.0) RETURN_IF_FAILED(check(axes.unit, "unit", "m", 1e-6, 1.0));
  auto made = std::make_unique<wrc_section_file>();
  made->tag = file_tag;
  RETURN_IF_FAILED(profiles::read_section_file(path, axes, made->sections, why));
  handle = made.release();
  return {};
}

Fault file_line(const wrc_section_file* handle, std::uint32_t index, wrc_section_line* line) {
  if (line == nullptr) return Fault::null("line");
  *line = {};
  if (!is_file(handle)) return Fault::null("file");
  if (index >= handle->sections.size())
    return Fault::range("index", {index, ""}, "there are no more sections");
  const profiles::MeasuredSection& section = handle->sections[index];
  line->distance = section.distance;
  line->count = static_cast<std::uint32_t>(section.line.size());
  line->y = section.line.y.data();
  line->z = section.line.z.data();
  return {};
}

Fault write_file(const char* path, const wrc_section_line* lines, std::uint32_t count, std::string& why) {
  if (path == nullptr) return Fault::null("path");
  if (lines == nullptr) return Fault::null("lines");
  RETURN_IF_FAILED(check(count, "count", "", 1.0, 1e5));
  std::vector<profiles::MeasuredSection> sections;
  RETURN_IF_FAILED(read_lines(lines, count, "lines", sections));
  return profiles::write_section_file(path, sections, why);
}

constexpr const char* too_many = "there is not enough memory for so many points";

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
  return abi::finish(__func__, abi::guarded(create, "problem.sections", abi::too_many), text, size);
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

int32_t wrc_section_file_read(const char* path, double unit, int32_t mirror_y, int32_t mirror_z,
                              wrc_section_file** file, char* text, uint64_t size) {
  if (file != nullptr) *file = nullptr;
  std::string why;
  const auto read = [&]() -> wrc::Fault {
    if (file == nullptr) return wrc::Fault::null("file");
    RETURN_IF_FAILED(abi::check(mirror_y, "mirror_y", "", 0.0, 1.0));
    RETURN_IF_FAILED(abi::check(mirror_z, "mirror_z", "", 0.0, 1.0));
    return abi::read_file(path, {unit, mirror_y == 1, mirror_z == 1}, *file, why);
  };
  return abi::finish(__func__, abi::guarded(read, "path", abi::too_many), text, size, path);
}

int32_t wrc_section_file_line(const wrc_section_file* file, uint32_t index, wrc_section_line* line) {
  return abi::file_line(file, index, line).status;
}

void wrc_section_file_destroy(wrc_section_file* file) {
  if (!abi::is_file(file)) return;
  file->tag = 0;
  delete file;
}

int32_t wrc_section_file_write(const char* path, const wrc_section_line* lines, uint32_t count, char* text,
                               uint64_t size) {
  std::string why;
  const auto write = [&] { return abi::write_file(path, lines, count, why); };
  return abi::finish(__func__, abi::guarded(write, "lines", abi::too_many), text, size, path);
}

}  // extern "C"
