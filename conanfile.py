"""Conan 2 recipe: `conan create . --build=missing`, or `conan install .` for what a build of this tree needs."""
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class AureoleRecipe(ConanFile):
    name = 'aureole'
    description = 'Real-time planetary atmospheres behind an abstract render interface'
    license = 'MIT'
    topics = 'graphics', 'atmosphere', 'sky', 'vulkan', 'rendering'
    package_type = 'library'
    settings = 'os', 'arch', 'compiler', 'build_type'
    options = {'shared': [True, False], 'vulkan': [True, False], 'app': [True, False]}
    default_options = {'shared': False, 'vulkan': True, 'app': False}
    exports_sources = ('CMakeLists.txt', 'LICENSE', 'README.md', 'CHANGELOG.md', 'cmake/*', 'rhi/*', 'atmosphere/*', 'backends/*',
                       'samples/*', 'docs/*', 'tests/rhi/*')

    def set_version(self):
        self.version = re.search(r'project\(aureole VERSION ([\d.]+)', load(self, 'CMakeLists.txt')).group(1)

    def requirements(self):
        self.requires('glm/0.9.9.8', transitive_headers=True)
        self.requires('spdlog/1.10.0', transitive_headers=True, transitive_libs=True)
        self.requires('onetbb/2021.8.0')
        if self.options.vulkan:
            self.requires('vulkan-headers/1.3.239.0', transitive_headers=True)
            self.requires('volk/1.3.239.0')
        if self.options.app:
            self.requires('cli11/2.1.2')
            self.requires('tomlplusplus/3.3.0')
            self.requires('nlohmann_json/3.11.2')
            self.requires('openexr/3.1.5')
            self.requires('libpng/1.6.39')
            self.requires('libzip/1.7.3')

    def build_requirements(self):
        self.tool_requires('cmake/[>=3.25 <4]')
        self.tool_requires('glslang/1.3.239.0')
        self.tool_requires('spirv-tools/1.3.239.0')

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables['AUREOLE_BUILD_TESTS'] = False
        toolchain.cache_variables['AUREOLE_BUILD_SAMPLES'] = bool(self.options.app)
        toolchain.cache_variables['AUREOLE_BUILD_VULKAN'] = bool(self.options.vulkan)
        toolchain.cache_variables['AUREOLE_REPORT_PAGE'] = False
        toolchain.cache_variables['AUREOLE_WARNINGS_AS_ERRORS'] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, 'LICENSE', self.source_folder, f'{self.package_folder}/licenses')
        CMake(self).install()

    def package_info(self):
        # The package that CMake installs is the one that find_package gives.
        self.cpp_info.set_property('cmake_find_mode', 'none')
        self.cpp_info.builddirs.append('lib/cmake/aureole')
