#!/usr/bin/env python3
"""The checks of the sources see a planted defect, each on a made tree: tools/house, duplicates.sh and the scripts beside this."""
import contextlib
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools/house"), str(ROOT / "tools/interface")]
import calls
import figures
import functions
import headers
import references

SOURCE = '''\
#include "a.hpp"
#define TWICE(x) \\
  { (x) + (x); }
namespace house {
struct Pair { double one = 1.0; alignas(64) double other[2] = {1.0, 2.0}; };
const char* const text = "int no(int a) {";
Pair::Pair(double first, const std::map<int, double>& second)
    : one{first}, other{second} {
  one = 2.0;
}
// int neither() {
template <typename Number>
Number sum(const Number (&values)[3], Number (*of)(Number, Number)) {
  auto add = [&](Number a) { return a; };

  // the sum
  for (Number each : values) {
    add(each);
  }
  return values[0];
}
bool operator()(int a, int b) const { return a < b; }
extern "C" int wrc_entry(void) { return 0; }
}
'''


class Functions(unittest.TestCase):
    def test_names_lines_and_parameters(self):
        found = [(each.name, each.first, each.last, each.parameters) for each in functions.functions(SOURCE)]
        self.assertEqual(found, [("Pair::Pair", 7, 10, 2), ("sum", 12, 21, 2), ("operator()", 22, 22, 2), ("wrc_entry", 23, 23, 0)])


class Tree(unittest.TestCase):
    """A tree in a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "tests/unit").mkdir(parents=True)

    def put(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text)


class Figures(Tree):
    def checked(self, **limits):
        """(status, lines beyond the limits) of figures.py --check"""
        usual = dict(MOST_LINES=8, MOST_PARAMETERS=2, LEAST_COMMENTS={"base": 5.0}, MOST_CYCLES=0, MOST_ARROWS_BACK=0, NAMESPACES=True,
                     MOST_WORDS=dict.fromkeys(figures.MOST_WORDS, 0))
        for name, value in {**usual, **limits}.items():
            setattr(figures, name, value)
        sys.argv = ["figures.py", "--check", "--root", str(self.root)]
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            status = figures.main()
        return status, said.getvalue().split("beyond the limits: ")[1]

    def sound(self):
        self.put("src/base/a.hpp", "// A sum.\nint sum(int a, int b) {\n  // both\n  return a + b;\n}\n")
        self.put("src/abi/b.hpp", '#include "base/a.hpp"\nint wrc_sum(int a, int b, int c) { return a; }\n')
        self.put("tests/unit/base_sum_test.cpp", "")

    def test_a_sound_tree_passes(self):
        self.sound()
        self.assertEqual(self.checked(), (0, "0\n"))

    def sees(self, sentence, **limits):
        status, said = self.checked(**limits)
        self.assertEqual((status, said.split("\n")[0]), (1, "1"), said)
        self.assertIn(sentence, said)

    def test_long_function(self):
        self.sound()
        self.sees("sum() has 4 lines", MOST_LINES=3)

    def test_parameters(self):
        self.sound()
        self.put("src/base/c.hpp", "void many(int a, int b, int c) {}\n")
        self.sees("many() has 3 parameters")

    def test_comments(self):
        self.sound()
        self.sees("base: 50.0 % comments", LEAST_COMMENTS={"base": 51.0})

    def test_cycle(self):
        self.sound()
        self.put("src/base/c.hpp", '#include "base/d.hpp"\n')
        self.put("src/base/d.hpp", '#include "base/c.hpp"\n')
        self.sees("cycle: base/c.hpp -> base/d.hpp -> base/c.hpp")

    def test_arrow_back(self):
        self.sound()
        self.put("src/base/c.hpp", '#include "abi/b.hpp"\n')
        self.put("docs/architecture.md", "| `base` | `abi`: a sum |\n")
        self.sees("arrow back: base/c.hpp reads abi/b.hpp")

    def test_arrow_that_the_page_lacks(self):
        self.sound()
        self.put("src/theory/c.hpp", "namespace wrc::theory {\n}\n")
        self.put("src/geometry/d.hpp", '#include "theory/c.hpp"\nnamespace wrc::geometry {\n}\n')
        self.sees("geometry reads theory, there or in src alone")
        self.put("docs/architecture.md", "| `geometry` | `theory`: c |\n")
        self.assertEqual(self.checked(), (0, "0\n"))
        self.put("docs/architecture.md", "| `geometry` | `theory`: c; `patch` |\n")
        self.sees("geometry reads patch, there or in src alone")

    def test_namespace(self):
        self.sound()
        self.put("src/damage/c.hpp", "namespace wrc::damage {\n}\n")
        self.assertEqual(self.checked(), (0, "0\n"))
        self.put("src/damage/c.hpp", "namespace wrc {\n}\n")
        self.sees("src/damage/c.hpp: not in namespace wrc::damage")

    def test_words(self):
        self.sound()
        self.put("src/base/c.hpp", "// Of a cell: its area.\n")
        self.sees("begin with 'of': 1, 0 at most")

    def test_unit_test_without_module(self):
        self.sound()
        self.put("tests/unit/other_test.cpp", "")
        self.sees("other_test.cpp: its first word is no module")

    def test_an_empty_tree_fails(self):
        (self.root / "src").mkdir()
        self.sees("no functions found")


class References(Tree):
    def wrong(self, comment):
        self.put("src/base/curve.hpp", "// arc() stands nowhere but here in a comment.\nint place(int a);\nint other();\n")
        self.put("src/base/use.cpp", comment + "\n")
        return [each for each in references.wrong_references(self.root)[0] if "use.cpp" in each]

    def test_right_ones_pass(self):
        self.assertEqual(self.wrong("// place() and other() of base/curve.hpp; place() (curve.hpp), place()\n// in curve.hpp: e.c, <module>/kernels.cpp, all *.hpp"), [])

    def test_wrong_ones_are_seen(self):
        for comment, said in (("// see gone.hpp", "there is no gone.hpp"), ("// sum() of\n// curve.hpp", "sum() is not in curve.hpp"),
                              ("int a; ///< arc() (base/curve.hpp)", "arc() is not in base/curve.hpp"),
                              ("// as arc() does", "there is no arc()")):
            self.assertTrue(any(said in each for each in self.wrong(comment)), f"{comment}: {self.wrong(comment)}")

    def wrong_on_page(self, page, text):
        self.put("src/base/curve.hpp", "int place(int a);\n")
        self.put("src/base/notes.md", "curve.hpp")
        self.put(page, text)
        return [each for each in references.wrong_references(self.root)[0] if page in each]

    def test_pages(self):
        self.put("docs/decisions/README.md", "| any decision | [any.md](any.md) |\n")
        pages = [page.replace("*", "any") for page in references.PAGES]
        self.assertIn("docs/architecture.md", pages)
        for page in pages:
            self.assertEqual(self.wrong_on_page(page, "`place()` of\n`curve.hpp`, src/base/, `a.place[2]`, methods/<name>.hpp, ../src/base/curve.hpp"), [])
            for text, said in (("see src/base/gone.hpp", "there is no src/base/gone.hpp"), ("`gone()` there", "there is no gone()"),
                               ("other() of\nbase/curve.hpp", "other() is not in base/curve.hpp"), ("in src/gone/ or", "there is no folder src/gone/"),
                               ("the array `w.gone[]`", "there is no `gone`"), ("the array\n`gone`", f"{page}:1: there is no `gone`")):
                self.assertTrue(any(said in each for each in self.wrong_on_page(page, text)), f"{page}, {text}: {self.wrong_on_page(page, text)}")

    def test_functions_of_tests_do_not_count(self):
        self.put("tests/unit/base_curve_test.cpp", "int planted(int a);\n")
        self.assertTrue(any("there is no planted()" in each for each in self.wrong("// as planted() does")))

    def test_decision_that_is_not_listed(self):
        self.put("docs/decisions/any.md", "# Any\n")
        self.assertEqual(references.wrong_references(self.root)[0], ["docs/decisions/README.md: does not list any.md"])

    def test_nothing_to_look_at_fails(self):
        sys.argv = ["references.py", str(self.root)]
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(references.main(), 1)


class Calls(unittest.TestCase):
    SAYS = "Twice. @param a first @param[out] b second @return WRC_OK; WRC_ERROR_NULL, _STRUCT_SIZE, _RANGE, _NOT_FINITE. @rt init @thread free"

    def lacks(self, without="", instead=""):
        number, struct = headers.Type("double", 0, False, (), ""), headers.Type("wrc_sized", 1, False, (), "")
        function = headers.Function("wrc_twice", headers.Type("int32_t", 0, False, (), ""), [("a", number), ("b", struct)],
                                    self.SAYS.replace(without, instead), "wrc.h", True)
        return list(calls.lacks(function, {"wrc_sized"}))

    def test_comments_of_functions(self):
        self.assertEqual(self.lacks(), [])
        for word in ("@param a", "@param[out] b", "@return", "WRC_ERROR_NULL", "_STRUCT_SIZE", "_RANGE", "_NOT_FINITE", "@rt", "@thread"):
            self.assertEqual(len(self.lacks(word)), 1, word)
        self.assertEqual(len(self.lacks("@rt init", "@rt hard")), 0)
        self.assertEqual(len(self.lacks("_RANGE, _NOT_FINITE. @rt init", "_RANGE, _NOT_FINITE, _MEMORY. @rt hard")), 1)


class Scripts(Tree):
    def ran(self, *command):
        return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def passes(self, *command):
        ran = self.ran(*command)
        self.assertIn(ran.returncode, (0, 77), ran.stdout)

    def fails(self, *command):
        ran = self.ran(*command)
        self.assertFalse(ran.returncode == 0, ran.stdout)
        return ran.stdout

    def test_format(self):
        command = [ROOT / "tests/scripts/formatted.sh", self.root]
        self.fails(*command)  # nothing to look at
        (self.root / ".clang-format").write_text((ROOT / ".clang-format").read_text())
        self.put("src/base/a.cpp", "int f() { return 1; }\n")
        self.passes(*command)
        self.put("src/base/a.cpp", "int  f( ){ return 1; }\n")
        self.fails(*command)

    def test_tidy(self):
        (self.root / ".clang-tidy").write_text((ROOT / ".clang-tidy").read_text())
        file = self.root / "src/base/a.cpp"
        (self.root / "compile_commands.json").write_text(json.dumps(
            [{"directory": str(self.root), "file": str(file), "command": f"g++ -std=c++20 -c {file}"}]))
        self.put("src/base/a.cpp", "int f(const int* a) { return *a; }\n")
        self.passes(ROOT / "tests/scripts/tidy.sh", self.root, file)
        self.put("src/base/a.cpp", "int f() {\n  const int* a = nullptr;\n  return *a;\n}\n")
        self.fails(ROOT / "tests/scripts/tidy.sh", self.root, file)

    def test_duplicates(self):
        body = "".join(f"  sum{k} += values[{k}] * (weights[{k}] - mean) / total;\n  if (sum{k} > {k}.0) {{ limit({k}, sum{k}); }}\n"
                       for k in range(8))
        self.put("src/base/one.cpp", f"void f() {{\n{body}}}\n")
        self.put("src/base/other.cpp", f"void g() {{\n{body}}}\n")
        said = self.fails(ROOT / "tests/duplicates.sh", self.root)
        self.assertTrue("src/base/one.cpp\nsrc/base/other.cpp" in said or "skipped" in said, said)

    def test_suites(self):
        """A program that runs what it is asked for, of two suites."""
        self.put("program", """#!/bin/sh
case "$*" in
  *list_tests*One.*) echo Other.; echo "  Test" ;;
  *list_tests*) ;;
  *One.*-) echo "[  PASSED  ] 3 tests." ;;
  *) echo "[  PASSED  ] 0 tests." ;;
esac
""")
        (self.root / "program").chmod(0o755)
        self.put("one_test.cpp", "TEST(One, Passes) {}\nTEST_F(One, Also) {}\n")
        self.put("empty_test.cpp", "// TEST(One, IsNone) {}\n")
        suites, one = [ROOT / "tests/scripts/suites.sh", self.root / "program"], self.root / "one_test.cpp"
        self.passes(*suites, "", one)
        self.fails(*suites, "One.*", one)  # none is left
        self.fails(*suites, "", self.root / "empty_test.cpp")
        self.fails(*suites, "--left", one)  # Other's
        self.put("other_test.cpp", "TEST(Other, Test) {}\n")
        self.passes(*suites, "--left", self.root / "other_test.cpp")

    def test_two_structs_of_a_name(self):
        command = [ROOT / "tests/scripts/one_definition.sh", "g++", self.root / "src"]
        self.put("src/base/one.cpp", "namespace a { struct Range { int first; }; int f(Range r) { return r.first; } }")
        self.put("src/base/other.cpp", "namespace b { struct Range { double first; }; double f(Range r) { return r.first; } }")
        self.passes(*command)
        self.put("src/base/other.cpp", "namespace a { struct Range { double first; }; double g(Range r) { return r.first; } }")
        self.fails(*command)


if __name__ == "__main__":
    unittest.main()
