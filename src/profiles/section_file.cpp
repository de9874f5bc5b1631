#include "profiles/section_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "profiles/text_file.hpp"

namespace wrc::profiles {

namespace {

constexpr double millimetre = 1e-3;  // [m]

Fault unusable(std::string told, std::string& why) {
  why = std::move(told);
  return Fault::file("path", why.c_str());
}

Fault unusable(const std::string& path, int line, const std::string& told, std::string& why) {
  return unusable((path.empty() ? "" : path + ": ") + sentence("line ", line, ": ") + told, why);
}

/// The folder of a path, with its last separator; the file's name without folder and ending.
std::string folder_of(const std::string& path) {
  const std::size_t end = path.find_last_of("/\\");
  return end == std::string::npos ? "" : path.substr(0, end + 1);
}
std::string stem_of(const std::string& path) {
  const std::string name = path.substr(folder_of(path).size());
  return name.substr(0, name.rfind('.'));
}

bool exists(const std::string& path) {
  std::vector<TextLine> lines;
  return read_text(path, "", lines);
}

/// Numbers of a Simpack profile by their names.
using Keys = std::map<std::string, double>;

double key_of(const Keys& keys, const char* name, double otherwise) {
  const auto found = keys.find(name);
  return found == keys.end() ? otherwise : found->second;
}

/// Angle by which it is turned [rad].
double turn_of(const Keys& keys) { return key_of(keys, "rotate", 0.0) / key_of(keys, "units.ang.f", 1.0); }

/// Applies the keys, in the order of Simpack's own reader; points in mm.
void apply_keys(const Keys& keys, Outline& points) {
  const auto key = [&](const char* name, double otherwise) { return key_of(keys, name, otherwise); };
  const double nearest = key("point.dist.min", 0.0), turn = turn_of(keys), cosine = sine_cosine(turn).cosine,
               sine = sine_cosine(turn).sine;
  const double bounds[2][2] = {{key("bound.y.min", 0.0), key("bound.y.max", 0.0)},
                               {key("bound.z.min", 0.0), key("bound.z.max", 0.0)}};
  Outline made;
  double before = 0.0;  // y of the point kept last
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (nearest > 0.0 && i > 0 && !(std::abs(points.y[i] - before) > nearest)) continue;
    before = points.y[i];
    const double y0 = points.y[i] + key("shift.y", 0.0), z0 = points.z[i] + key("shift.z", 0.0);
    double y = cosine * y0 - sine * z0, z = sine * y0 + cosine * z0;
    if (bounds[0][0] < bounds[0][1] && !(y >= bounds[0][0] && y <= bounds[0][1])) continue;
    if (bounds[1][0] < bounds[1][1]) z = std::clamp(z, bounds[1][0], bounds[1][1]);
    if (key("mirror.y", 0.0) == 1.0) y = -y;
    if (key("mirror.z", 0.0) == 1.0) z = -z;
    made.add(y, z);
  }
  const double per_metre = key("units.len.f", 1.0 / millimetre), scale = 1.0 / (per_metre * millimetre);
  for (std::vector<double>* each : {&made.y, &made.z})
    for (double& value : *each) value *= scale;
  points = std::move(made);
}

/// Points of a Simpack profile [mm]: sections header, spline, point.
Fault read_simpack(const std::string& path, Outline& points, std::string& why) {
  std::vector<TextLine> lines;
  if (!read_text(path, "!", lines)) return unusable("there is no file " + path, why);
  Keys keys;
  std::vector<double> numbers;
  bool within_points = false;
  for (const TextLine& line : lines) {
    const std::size_t equals = line.text.find('=');
    if (line.text.find(".begin") != std::string::npos || line.text.find(".end") != std::string::npos) {
      within_points = line.text.compare(0, 11, "point.begin") == 0;
    } else if (equals != std::string::npos) {
      double value = 0.0;
      if (read_number(trimmed(line.text.substr(equals + 1)), value))
        keys[trimmed(line.text.substr(0, equals))] = value;
    } else {
      // a point: y and z, and a weight if wanted
      if (!within_points || !read_numbers(line.text, numbers) || numbers.size() < 2)
        return unusable(path, line.number, "'" + line.text + "' is neither NAME = value nor a point", why);
      points.add(numbers[0], numbers[1]);
    }
  }
  if (keys.count("units.len.f") != 0 && !(keys["units.len.f"] > 0.0))
    return unusable(path + ": units.len.f is not positive: how many of the file's units make a metre?", why);
  if (std::abs(turn_of(keys)) > 0.5 * pi)
    return unusable(path + ": rotate turns it by more than 90 degrees: is its unit degrees?", why);
  apply_keys(keys, points);
  return {};
}

/// Number of a column by its name in MiniProf's ColumnDef, "X,Y,A"; -1: there is none.
int column_of(const std::string& definition, const char* name) {
  int at = 0;
  for (const std::string& cell : cells_of(definition)) {
    if (lower_case(trimmed(cell.substr(0, cell.find('=')))) == name) return at;
    ++at;
  }
  return -1;
}

/// Points in columns y, z behind a heading; MiniProf's heading says which columns.
Fault read_columns(const std::string& path, Outline& points, std::string& why) {
  std::vector<TextLine> lines;
  if (!read_text(path, "#!%", lines)) return unusable("there is no file " + path, why);
  std::size_t of_y = 0, of_z = 1;
  std::vector<double> numbers;
  for (const TextLine& line : lines) {
    const std::size_t equals = line.text.find('=');
    if (points.size() == 0 && equals != std::string::npos) {
      if (lower_case(trimmed(line.text.substr(0, equals))) != "columndef") continue;
      const std::string definition = line.text.substr(equals + 1);
      const int x = column_of(definition, "x"), y = column_of(definition, "y");
      if (x < 0 || y < 0) return unusable(path, line.number, "ColumnDef has no columns X and Y", why);
      of_y = static_cast<std::size_t>(x);
      of_z = static_cast<std::size_t>(y);
      continue;
    }
    const bool read = read_numbers(line.text, numbers);
    if (!read && points.size() == 0 && numbers.size() <= 1) continue;  // a heading in words
    if (!read || numbers.size() <= std::max(of_y, of_z))
      return unusable(path, line.number, "'" + line.text + "' is no point: y and z", why);
    points.add(numbers[of_y], numbers[of_z]);
  }
  return {};
}

Fault read_points(const std::string& path, Outline& points, std::string& why) {
  return ends_with(path, ".prr") ? read_simpack(path, points, why) : read_columns(path, points, why);
}

/// Slices of CONTACT: offset and scale, their number; then places with names of files. Features that follow
/// are not read, since the faces are found from the points.
Fault read_slices(const std::string& path, std::vector<MeasuredSection>& sections, std::string& why) {
  std::vector<TextLine> lines;
  if (!read_text(path, "%", lines)) return unusable("it cannot be opened: is the path right?", why);
  // The heading's texts stand behind its numbers, so only leading cells are read.
  double heading[3] = {};
  const std::vector<std::string> first = cells_of(lines.empty() ? "" : lines[0].text),
                                 second = cells_of(lines.size() < 2 ? "" : lines[1].text);
  if (first.size() < 2 || second.empty() || !read_number(first[0], heading[0]) ||
      !read_number(first[1], heading[1]) || !read_number(second[0], heading[2]))
    return unusable("no heading of slices: offset and scale, then their number", why);
  for (std::size_t k = 2; k < lines.size(); ++k) {
    const std::string& text = lines[k].text;
    const std::size_t begin = text.find('\''), end = text.find('\'', begin + 1);
    double place = 0.0;
    if (begin == std::string::npos || end == std::string::npos ||
        !read_number(trimmed(text.substr(0, begin)), place))
      continue;
    std::string name = text.substr(begin + 1, end - begin - 1);
    std::replace(name.begin(), name.end(), '\\', '/');
    MeasuredSection section;
    section.distance = millimetre * (heading[0] + place) * heading[1];
    name.insert(0, folder_of(path));
    if (!exists(name)) return unusable({}, lines[k].number, "there is no file " + name, why);
    RETURN_IF_FAILED(read_points(name, section.line, why));
    sections.push_back(std::move(section));
  }
  if (static_cast<double>(sections.size()) != heading[2])
    return unusable(sentence(heading[2], " slices are promised, ", static_cast<std::int32_t>(sections.size()),
                             " named: is the file whole?"),
                    why);
  return {};
}

/// A table of numbers and places: the points of section 7 are in NAME_7.txt, beside it or in the folder NAME,
/// where SectionPositionNAME.txt is the table.
Fault read_table(const std::string& path, const std::vector<std::vector<double>>& rows,
                 std::vector<MeasuredSection>& sections, std::string& why) {
  std::string stem = stem_of(path);
  const std::string prefix = "SectionPosition";
  if (stem.compare(0, prefix.size(), prefix) == 0) stem.erase(0, prefix.size());
  for (const std::vector<double>& row : rows) {
    if (row[0] < 0.0 || row[0] != std::floor(row[0]))
      return unusable(sentence("two columns are numbers of sections and their places, and ", row[0],
                               " is no number of one: are these points of a section?"),
                      why);
    const std::string name = stem + "_" + std::to_string(static_cast<std::int64_t>(row[0])) + ".txt";
    std::string file = folder_of(path) + name;
    if (!exists(file)) file = folder_of(path).append(stem).append("/").append(name);
    if (!exists(file))
      return unusable(sentence("section ", row[0], " at ", row[1], " m has no file ") + name, why);
    MeasuredSection section;
    section.distance = row[1];
    RETURN_IF_FAILED(read_points(file, section.line, why));
    sections.push_back(std::move(section));
  }
  return {};
}

/// Columns of numbers in the file itself: x, y, z of points, or number and place. `in_unit`: are distances in
/// the points' unit?
Fault read_rows(const std::string& path, std::vector<MeasuredSection>& sections, bool& in_unit,
                std::string& why) {
  std::vector<TextLine> lines;
  if (!read_text(path, "#!%", lines)) return unusable("it cannot be opened: is the path right?", why);
  std::vector<std::vector<double>> rows;
  for (const TextLine& line : lines) {
    std::vector<double> numbers;
    if (!read_numbers(line.text, numbers)) {
      if (rows.empty()) continue;  // a heading in words
      return unusable({}, line.number, "'" + line.text + "' has a cell that is no number", why);
    }
    if ((numbers.size() != 2 && numbers.size() != 3) || (!rows.empty() && numbers.size() != rows[0].size()))
      return unusable({}, line.number, "neither columns x, y, z nor number and place", why);
    rows.push_back(std::move(numbers));
  }
  if (rows.empty()) return unusable("neither columns x, y, z nor number and place", why);
  in_unit = rows[0].size() == 3;
  if (!in_unit) return read_table(path, rows, sections, why);
  for (const std::vector<double>& row : rows) {
    if (sections.empty() || sections.back().distance != row[0]) sections.push_back({row[0], {}});
    sections.back().line.add(row[1], row[2]);
  }
  return {};
}

/// Unit that fits sections as wide as most are [m]; 0: none.
double fitting_unit(const std::vector<MeasuredSection>& sections, double& width) {
  std::vector<double> widths;
  for (const MeasuredSection& each : sections) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const double y : each.line.y) {
      if (!std::isfinite(y)) continue;
      low = std::min(low, y);
      high = std::max(high, y);
    }
    widths.push_back(high - low);
  }
  std::sort(widths.begin(), widths.end());
  width = widths.empty() ? 0.0 : widths[widths.size() / 2];
  for (const double unit : {millimetre, 1.0})
    if (width * unit >= 0.02 && width * unit <= 1.0) return unit;
  return 0.0;
}

}  // namespace

Fault read_section_file(const std::string& path, const FileAxes& axes, std::vector<MeasuredSection>& sections,
                        std::string& why) {
  sections.clear();
  bool in_unit = false;
  RETURN_IF_FAILED(ends_with(path, ".slcs") ? read_slices(path, sections, why)
                                            : read_rows(path, sections, in_unit, why));
  double width = 0.0;
  const double unit = axes.unit > 0.0 ? axes.unit : fitting_unit(sections, width);
  if (unit == 0.0)
    return unusable(
        sentence("sections are ", width, " wide, which is a rail neither in mm nor in m: give the unit"),
        why);
  for (MeasuredSection& each : sections) {
    if (in_unit) each.distance *= unit;
    for (double& y : each.line.y) y *= axes.mirror_y ? -unit : unit;
    for (double& z : each.line.z) z *= axes.mirror_z ? -unit : unit;
    if (!axes.mirror_y) continue;
    std::reverse(each.line.y.begin(), each.line.y.end());
    std::reverse(each.line.z.begin(), each.line.z.end());
  }
  return {};
}

Fault write_section_file(const std::string& path, const std::vector<MeasuredSection>& sections,
                         std::string& why) {
  const auto written = [&](const std::string& file, const std::string& text) {
    return write_text(file, text) ? Fault{} : unusable(file + " cannot be written", why);
  };
  if (!ends_with(path, ".slcs")) {
    std::string text = "# x [m] y [m] z [m]\n";
    for (const MeasuredSection& each : sections)
      for (std::size_t i = 0; i < each.line.size(); ++i)
        text +=
            fixed(each.distance, 9) + " " + fixed(each.line.y[i], 9) + " " + fixed(each.line.z[i], 9) + "\n";
    return written(path, text);
  }
  std::string list =
      "% sections of a rail\n   0.0   1000.0   U_OFFSET [usr], U_SCALE [mm/usr],  usr = m\n   " +
      std::to_string(sections.size()) +
      "   NSLC\n   0   0   0   NFEAT, NKINK, NACCEL\n   1   U_INTPOL (1=intpol, 2=approx)\n\n";
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const MeasuredSection& each = sections[k];
    const std::string name = stem_of(path) + "_" + std::to_string(k + 1) + ".txt";
    std::string text;
    for (std::size_t i = 0; i < each.line.size(); ++i)
      if (std::isfinite(each.line.y[i]) && std::isfinite(each.line.z[i]))
        text += fixed(each.line.y[i] / millimetre, 7) + " " + fixed(each.line.z[i] / millimetre, 7) + "\n";
    RETURN_IF_FAILED(written(folder_of(path) + name, text));
    list += "  " + fixed(each.distance, 7) + "   '" + name + "'\n";
  }
  return written(path, list);
}

}  // namespace wrc::profiles
