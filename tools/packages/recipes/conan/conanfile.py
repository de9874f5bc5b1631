"""wrc for Conan 2, of the sources around this file:  conan create tools/packages/recipes/conan"""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Wrc(ConanFile):
    name = "wrc"
    description = "Wheel/rail contact for real-time multibody simulation: an embeddable C library"
    license = "Apache-2.0"
    topics = ("railway", "contact mechanics", "multibody")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": True}

    @property
    def _root(self):
        return os.path.join(self.recipe_folder, "..", "..", "..", "..")

    def set_version(self):
        self.version = re.search(r"project\(wrc VERSION ([0-9.]+)", load(self, os.path.join(self._root, "CMakeLists.txt")))[1]

    def export_sources(self):
        for each in ("CMakeLists.txt", "LICENSE", "README.md", "CHANGELOG.md", "cmake/*", "src/*", "include_c/*", "data/*", "docs/*",
                     "bindings/*"):
            copy(self, each, self._root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for each in ("TESTS", "EXAMPLES", "FORTRAN", "FMI", "WERROR"):
            toolchain.cache_variables[f"WRC_{each}"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "third_party.md", os.path.join(self.source_folder, "docs"), os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.libs = ["wrc"]
        self.cpp_info.set_property("cmake_file_name", "wrc")
        self.cpp_info.set_property("cmake_target_name", "wrc::wrc")
        self.cpp_info.set_property("pkg_config_name", "wrc")
