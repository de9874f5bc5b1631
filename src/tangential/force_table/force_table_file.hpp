/// The file a force table comes in: a header, then the spline coefficients as 32-bit floats in the order of
/// ForceTable. Little-endian machines write and read it; on others the byte order mark is wrong and the file
/// refused.
///
/// Reading belongs to the making of a model: it opens the file, and nothing stays open or allocated.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/fault.hpp"
#include "tangential/force_table/force_table.hpp"

namespace wrc::tangential {

struct ForceTableFileHeader {
  char name[8] = {'w', 'r', 'c', 'f', 'o', 'r', 'c', 'e'};
  std::uint32_t byte_order = 0x01020304;
  std::uint32_t version = 1;
  std::int32_t nodes[5] = {};  ///< ratios, shapes, elevations, azimuths, saturations
  std::int32_t values = force_table_values;
  double largest_ratio = 0.0, largest_shape_number = 0.0, half_saturation = 0.0, poisson = 0.0;
  std::uint64_t checksum = 0;  ///< checksum of the header with zero here, and of all that follows
};
static_assert(sizeof(ForceTableFileHeader) == 80);

/// FNV-1a, 64 bit (Fowler, Noll, Vo), of more bytes after those `so_far` stands for.
std::uint64_t file_checksum(const void* bytes, std::size_t count, std::uint64_t so_far = 0xcbf29ce484222325);

/// Reads the axes of the table in this file. Faults are WRC_ERROR_FILE about config.tangential.force_table.
Fault read_force_table_axes(const char* path, ForceTableAxes& axes);

/// Reads the table into `coefficients`, of force_table_size(axes) numbers; `axes` are those read
/// before. Checks the length, the checksum and that every number is finite.
Fault read_force_table(const char* path, const ForceTableAxes& axes, float* coefficients);

}  // namespace wrc::tangential
