#include "tangential/force_table/force_table_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

namespace wrc::tangential {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

Fault unusable(const char* cause) { return Fault::file("config.tangential.force_table", cause); }

constexpr const char* ends_early = "the file ends before the table does: is the copy complete?";

bool in_range(std::int32_t nodes, std::int32_t lowest) {
  return nodes >= lowest && nodes <= force_table_nodes;
}

/// Could a table have these axes? Three nodes carry a quadratic; opposite azimuths must both be nodes.
bool plausible(const ForceTableAxes& axes) {
  return in_range(axes.ratios, 3) && in_range(axes.shapes, 3) && in_range(axes.elevations, 3) &&
         in_range(axes.azimuths, 4) && axes.azimuths % 2 == 0 && in_range(axes.saturations, 3) &&
         axes.largest_ratio > 1.0 && axes.largest_ratio <= 1e3 && axes.largest_shape_number > 0.0 &&
         axes.largest_shape_number < 1.0 && axes.half_saturation > 0.0 && axes.half_saturation <= 1e3 &&
         axes.poisson >= 0.0 && axes.poisson <= 0.5;
}

ForceTableAxes axes_of(const ForceTableFileHeader& header) {
  return {.ratios = header.nodes[0],
          .shapes = header.nodes[1],
          .elevations = header.nodes[2],
          .azimuths = header.nodes[3],
          .saturations = header.nodes[4],
          .largest_ratio = header.largest_ratio,
          .largest_shape_number = header.largest_shape_number,
          .half_saturation = header.half_saturation,
          .poisson = header.poisson};
}

Fault open(const char* path, File& file, ForceTableFileHeader& header) {
  file.reset(std::fopen(path, "rb"));
  if (!file) return unusable("the file cannot be opened: is the path right, and may it be read?");
  // Name first, then byte order: the numbers of a file that has another cannot be read.
  const ForceTableFileHeader ours;
  if (std::fread(&header, sizeof header, 1, file.get()) != 1) return unusable(ends_early);
  if (std::memcmp(header.name, ours.name, sizeof ours.name) != 0)
    return unusable("the file is not a force table");
  if (header.byte_order != ours.byte_order) {
    return unusable("the file was written on a machine with the other byte order");
  }
  if (header.version != ours.version || header.values != ours.values) {
    return Fault::file("config.tangential.force_table", {header.version, "(version of the file)"},
                       "this library reads version 1: use the file that came with it");
  }
  if (!plausible(axes_of(header))) return unusable("the file's header is damaged");
  return {};
}

}  // namespace

std::uint64_t file_checksum(const void* bytes, std::size_t count, std::uint64_t so_far) {
  const auto* at = static_cast<const unsigned char*>(bytes);
  for (std::size_t i = 0; i < count; ++i) so_far = (so_far ^ at[i]) * 0x100000001b3;
  return so_far;
}

Fault read_force_table_axes(const char* path, ForceTableAxes& axes) {
  File file;
  ForceTableFileHeader header;
  const Fault fault = open(path, file, header);
  if (fault.failed()) return fault;
  axes = axes_of(header);
  return {};
}

Fault read_force_table(const char* path, const ForceTableAxes& axes, float* coefficients) {
  // The header once more: between the two readings the file may have become another.
  File file;
  ForceTableFileHeader header;
  const Fault fault = open(path, file, header);
  if (fault.failed()) return fault;
  const std::size_t size = force_table_size(axes);
  if (force_table_size(axes_of(header)) != size) return unusable("the file was changed while it was read");
  if (std::fread(coefficients, sizeof(float), size, file.get()) != size) return unusable(ends_early);
  if (std::fgetc(file.get()) != EOF) return unusable("the file goes on after the table's end");

  // the checksum is that of the header with 0 in its place, then the numbers
  const std::uint64_t given = header.checksum;
  header.checksum = 0;
  if (file_checksum(coefficients, size * sizeof(float), file_checksum(&header, sizeof header)) != given) {
    return unusable("the checksum is wrong: the file was damaged on its way");
  }
  const auto usable = [](float value) { return std::isfinite(value) && std::abs(value) < 1e4F; };
  if (!std::all_of(coefficients, coefficients + size, usable))
    return unusable("the table's numbers are out of range");
  return {};
}

}  // namespace wrc::tangential
