# quadmesh: `make help` lists the targets.
#
# Everything that is built lies below build/$(config); the release tools are also linked into bin/.
# Private settings (CXX, CXXFLAGS, jobs, prefix, ...) may stand in config.mk, which is never committed.

MAKEFLAGS += --no-builtin-rules --warn-undefined-variables
SHELL := bash
.SHELLFLAGS := -euo pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:
.SUFFIXES:

# -------------------------------------------------------------------------------------------- settings

config  ?= release#     release | debug | sanitize | tsan | coverage | fuzz
prefix  ?= /usr/local#  where `make install` puts things, below DESTDIR
DESTDIR ?=
only    ?=#             regular expression: run only the tests whose name matches
killed  ?= 200#         how often `make check-faults` kills, and does anything else to, some tool
tried   ?= 2000#        how many command lines `make check-options` tries
seed    ?= 1#           where, when and which
seconds ?= 60#          how long `make fuzz` runs each fuzzer
CINOLIB ?=#             a copy of cinolib, for `make bench-peers`
jobs    ?= $(shell nproc)

-include config.mk

O       := build/$(config)
version := $(shell cat VERSION)

# clang++ compiles a release in little more than half the time of g++; the tools run as fast and write the same bytes.
# libFuzzer is clang's, too; the other configurations need what comes with g++. Make's own CXX counts as unset.
ifeq ($(origin CXX),default)
CXX := $(or $(if $(filter fuzz,$(config)),clang++),$(if $(filter release,$(config)),$(notdir $(shell type -P clang++ || true))),g++)
endif

# The loops over the three coordinates of OpenMesh's vectors unrolled: a third of the time of a fit. Clang does so anyway.
unrolled          := $(if $(findstring clang,$(CXX)),,-fpeel-loops)
optimise.release  := -O2 $(unrolled) -DNDEBUG
optimise.debug    := -O0 -g -D_GLIBCXX_ASSERTIONS
optimise.sanitize := -O1 -g -D_GLIBCXX_ASSERTIONS -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
optimise.tsan     := -O1 -g -D_GLIBCXX_ASSERTIONS -fno-omit-frame-pointer -fsanitize=thread
optimise.coverage := -O0 -g --coverage -fprofile-update=atomic
optimise.fuzz     := -O1 -g -D_GLIBCXX_ASSERTIONS -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
$(if $(optimise.$(config)),,$(error config=$(config) is unknown. Use release, debug, sanitize, tsan, coverage or fuzz))
CXXFLAGS ?= $(optimise.$(config))
LDFLAGS  ?=

# One short line for each thing made; V=1 shows the commands.
V ?=
quietly = $(if $(V),,@printf '%9s  %s\n' $(1) $(2) &&)

warnings := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
# With sanitizers GCC 12 takes initialised temporaries of the standard library for uninitialised.
warnings += $(if $(unrolled),$(if $(filter sanitize tsan,$(config)),-Wno-maybe-uninitialized))
defines  := -DQM_VERSION='"$(version)"' -DVALIJSON_USE_EXCEPTIONS=1
# Boost.Graph warns about deprecated headers of its own.
defines  += -DBOOST_ALLOW_DEPRECATED_HEADERS

# Headers of libraries are system headers: our warnings are not theirs.
packages := openmesh eigen3 CLI11 nlohmann_json cbc clp osi-clp nettle
library_paths := $(shell pkg-config --cflags-only-I $(packages) 2>/dev/null | sed 's/-I/-isystem /g') -isystem /usr/include/opencascade
# --as-needed: a tool depends on a library only if it calls it. OpenCASCADE is for qm-export alone.
opencascade := TKSTEP TKSTEP209 TKSTEPAttr TKSTEPBase TKIGES TKXSBase TKShHealing TKTopAlgo TKGeomAlgo TKPrim \
               TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel
# Libraries of which pkg-config knows nothing.
others    := amd $(opencascade)
libraries := -Wl,--as-needed $(shell pkg-config --libs $(packages) 2>/dev/null) $(others:%=-l%) -pthread

compile = $(CXX) -std=c++20 $(warnings) $(CXXFLAGS) $(defines) -Ilib -Itests $(library_paths) -pthread
link    = $(CXX) $(CXXFLAGS) $(LDFLAGS)

# ----------------------------------------------------------------------------------------------- files

sources     := $(shell find lib -name "*.cpp" | LC_ALL=C sort)
headers     := $(shell find lib -name "*.h" | LC_ALL=C sort)
own_headers := $(filter $(sources:.cpp=.h),$(headers))
schemas     := $(wildcard schemas/*.schema.json)
three       := /usr/share/javascript/three
page_parts  := $(wildcard lib/view/page/*) $(three)/three.min.js $(three)/examples/js/controls/OrbitControls.js
scripts     := $(wildcard lib/cli/tools/remesh/*.py)
tool_names  := $(patsubst tools/%.cpp,%,$(wildcard tools/qm-*.cpp))
library     := $(O)/libquadmesh.a
# The release tools are what people use, so they lie where they are found.
bin         := $(if $(filter release,$(config)),bin,$(O)/bin)
tools       := $(tool_names:%=$(bin)/%)
# Sanitizers allocate memory themselves.
allocation  := $(if $(filter sanitize tsan fuzz,$(config)),,$(O)/tools/large_blocks.o)
support     := $(patsubst %.cpp,$(O)/%.o,$(wildcard tests/support/*.cpp))
unit_tests  := $(patsubst %.cpp,$(O)/%.o,$(shell find tests/unit -name "*_test.cpp" | LC_ALL=C sort))
properties  := $(patsubst %.cpp,$(O)/%.o,$(wildcard tests/property/*_test.cpp))
benchmarks  := $(patsubst %.cpp,$(O)/%.o,$(wildcard tests/bench/*.cpp))
tables      := $(patsubst %.cpp,$(O)/%.o,$(wildcard tests/bench/search/*.cpp))
bench_parts := $(addprefix $(O)/tests/bench/,plain_cbc.o sample_models.o search_problem.o staircase.o)
programs    := $(patsubst tests/programs/%.cpp,$(O)/tests/%,$(wildcard tests/programs/*.cpp))
samples     := $(addprefix $(O)/tests/support/,polycube.o sample_document.o)
fuzzers     := $(patsubst tests/fuzz/%.cpp,$(O)/fuzz/%,$(wildcard tests/fuzz/*_fuzz.cpp))
parts       := unit property programs cli layers schemas docs

# ------------------------------------------------------------------------------------------ everything

.PHONY: all
all: $(tools) $(bin)/quadmesh ## build the tools

.PHONY: help
help: ## this list
	@echo 'make [TARGET] [config=release|debug|sanitize|tsan|coverage|fuzz] [only=REGEX]'
	@sed -nE 's/^([a-z-]+):[^#]*## (.*)/  \1\t\2/p' Makefile | expand -t 20

.PHONY: deps
deps: ## install what building and `make check` need of Debian (as root, or with sudo)
	@scripts/install-dependencies build check

# `check` and `demo` must work on a machine that has nothing but git and make: the packages come first, and
# a second make then sees them.
again = $(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,-j$(jobs))

.PHONY: check
check: ## install what is missing, build, run the tests; ends with "N passed, N failed"
	@scripts/install-dependencies build check
	@$(again) --keep-going all programs-of-tests || true
	@scripts/check $(config) '$(only)' $(parts)

.PHONY: demo
demo: ## install what is missing, build, lay out sample parts, say where to look
	@scripts/install-dependencies build demo
	@$(again) all
	@scripts/demo bin out/demo

# ----------------------------------------------------------------------------------------------- build

$(tools): $(bin)/%: $(O)/tools/%.o $(allocation) $(library)
	@mkdir -p $(@D)
	$(call quietly,link,$@) $(link) $^ -o $@ $(libraries)

# The one command is a script; it finds the tools beside itself.
$(bin)/quadmesh: pipelines/quadmesh
	@mkdir -p $(@D)
	$(call quietly,link,$@) ln -sfr $< $@

$(library): $(sources:%.cpp=$(O)/%.o) $(O)/gen/schemas.o $(O)/gen/page_parts.o $(O)/gen/blender_scripts.o
	@rm -f $@
	$(call quietly,archive,$@) $(AR) rcs $@ $(filter %.o,$^)

# Parsing headers takes two thirds of the time of a build, so those that most sources include are compiled once. No
# source relies on it: `make lint` compiles each without. clang++ can keep the templates that they use as well, which
# saves a third more. GCC 12 warns falsely of texts of the standard library that are inlined from there.
common           := algorithm array cmath functional limits map memory numbers numeric optional random ranges set span \
                    sstream string string_view thread unordered_map utility vector \
                    Eigen/Core Eigen/Geometry OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh nlohmann/json.hpp
common.library   := $(common)
common.tests     := $(common) gtest/gtest.h
kept_templates   := $(if $(findstring clang,$(CXX)),-fpch-instantiate-templates)
# clang++ takes no precompiled header that is older than what is in it. Files of Debian's packages are dated by their
# build, so only the lists of these files tell when they were installed.
precompiled_from := libc6-dev linux-libc-dev libstdc++-*-dev libgcc-*-dev libclang-common-*-dev \
                    libeigen3-dev libopenmesh-dev nlohmann-json3-dev libgtest-dev
package_lists    := $(subst :,\:,$(wildcard $(foreach package,$(precompiled_from),/var/lib/dpkg/info/$(package).list \
                    /var/lib/dpkg/info/$(package):*.list)))
with_precompiled  = -Winvalid-pch $(kept_templates) -include $(O)/precompiled/$(strip $(1)).h \
                    $(if $(unrolled),-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)

# Compilers take a fifteenth less time where their memory lies on huge pages.
$(O)/%.o $(O)/precompiled/%.h.gch: export GLIBC_TUNABLES := glibc.malloc.hugetlb=1

$(O)/%.o: %.cpp $(O)/flags $(O)/precompiled/library.h.gch
	@mkdir -p $(@D)
	$(call quietly,compile,$<) $(compile) $(call with_precompiled,library) -MMD -MP -c $< -o $@

# Unit tests are compiled in half the time without optimisation, and run as fast: what takes time is in the library.
$(unit_tests) $(O)/precompiled/tests.h.gch: private compile += $(if $(filter release,$(config)),-O0)
$(unit_tests): $(O)/%.o: %.cpp $(O)/flags $(O)/precompiled/tests.h.gch
	@mkdir -p $(@D)
	$(call quietly,compile,$<) $(compile) $(call with_precompiled,tests) -MMD -MP -c $< -o $@

$(O)/precompiled/%.h.gch: $(O)/flags $(package_lists)
	@mkdir -p $(@D)
	@printf '#include <%s>\n' $(common.$*) > $(@:.gch=)
	$(call quietly,compile,$*.h) $(compile) $(kept_templates) -MD -MP -c -x c++-header $(@:.gch=) -o $@

$(O)/gen/schemas.cpp: $(schemas) scripts/embed
	@mkdir -p $(@D)
	$(call quietly,embed,$@) scripts/embed embeddedSchemas $(schemas) > $@

$(O)/gen/page_parts.cpp: $(page_parts) scripts/embed
	@mkdir -p $(@D)
	$(call quietly,embed,$@) scripts/embed embeddedPageParts $(page_parts) > $@

$(O)/gen/blender_scripts.cpp: $(scripts) scripts/embed
	@mkdir -p $(@D)
	$(call quietly,embed,$@) scripts/embed embeddedBlenderScripts $(scripts) > $@

# clang warns of the length of texts.
$(O)/gen/%.o: $(O)/gen/%.cpp $(O)/flags
	$(call quietly,compile,$<) $(compile) -Wno-overlength-strings -MMD -MP -c $< -o $@

# A change of the flags rebuilds what was built with others; a list of objects that lost one relinks.
$(O)/flags: FORCE
	@mkdir -p $(@D)
	@echo "$$stamp" | cmp -s - $@ || echo "$$stamp" > $@
$(O)/flags: export stamp = $(compile) $(common.tests)
$(O)/objects: FORCE
	@mkdir -p $(@D)
	@echo "$$stamp" | cmp -s - $@ || echo "$$stamp" > $@
$(O)/objects: export stamp = $(sources) $(unit_tests) $(properties) $(support)
$(library): $(O)/objects

-include $(shell find $(O) -name '*.d' 2>/dev/null)

# ----------------------------------------------------------------------------------------------- tests

gtest = -lgtest_main -lgtest

# Small programs that scripts ask: no tools. One of them borrows the checker's readers.
$(O)/tests/measure-surfaces: $(O)/tests/programs/measure/subdivision.o $(library)
$(O)/tests/refine: $(library)
$(programs): $(O)/tests/%: $(O)/tests/programs/%.o
	@mkdir -p $(@D)
	$(call quietly,link,$@) $(link) $^ -o $@ $(libraries)

$(O)/tests/property-tests: $(properties) $(support) $(library)
	@mkdir -p $(@D)
	$(call quietly,link,$@) $(link) $^ -o $@ $(gtest) $(libraries)

# The library comes first and whole: of inline functions that both contain, the linker takes the optimised ones.
$(O)/tests/unit-tests: $(library) $(unit_tests) $(support)
	@mkdir -p $(@D)
	$(call quietly,link,$@) $(link) -Wl,--whole-archive $< -Wl,--no-whole-archive $(filter-out $<,$^) -o $@ $(gtest) $(libraries)

.PHONY: programs-of-tests
programs-of-tests: $(O)/tests/unit-tests $(O)/tests/property-tests $(programs) $(O)/tests/search-tables

.PHONY: check-unit check-property
check-unit: $(O)/tests/unit-tests ## unit tests; only=REGEX to filter
check-property: $(O)/tests/property-tests ## property tests; only=REGEX to filter
check-unit check-property:
	@scripts/check-gtest $< $(@:check-%=%) $(O)/$@ '$(only)'

.PHONY: check-programs
check-programs: $(programs) $(O)/tests/search-tables ## what only benchmarks run can be built
	@echo 'programs: $(words $^) passed, 0 failed'

.PHONY: check-cli
check-cli: $(tools) $(bin)/quadmesh ## tests of the tools; only=REGEX to filter
	@QM_BIN=$(abspath $(bin)) scripts/check-cli $(O)/$@ '$(only)'

.PHONY: check-layers
check-layers: ## no module includes what lib/LAYERS does not allow
	@scripts/check-layers

.PHONY: check-headers
check-headers: $(headers:%=$(O)/%.ok) ## every header compiles on its own
	@echo 'headers: $(words $(headers)) passed, 0 failed'

# Headers with a source of their own are its first include, and `make lint` compiles it without what is precompiled;
# other headers are compiled alone.
$(own_headers:%=$(O)/%.ok): $(O)/%.h.ok: %.cpp
	@mkdir -p $(@D)
	@first=$$(grep -m 1 '^#include' $<); [[ $$first == '#include "$(<:lib/%.cpp=%.h)"' ]] || \
	    { echo "$<: include $(<:lib/%.cpp=%.h) before anything else" >&2; exit 1; }
	@touch $@
$(patsubst %,$(O)/%.ok,$(filter-out $(own_headers),$(headers))): $(O)/%.h.ok: %.h $(O)/flags
	@mkdir -p $(@D)
	$(call quietly,header,$<) echo '#include "$(<:lib/%=%)"' | $(compile) -MMD -MP -MF $(@:.ok=.d) -MT $@ -fsyntax-only -x c++ -
	@touch $@

.PHONY: check-schemas
check-schemas: $(tools) ## the schemas are valid, and every tool prints the one it writes
	@QM_BIN=$(abspath $(bin)) scripts/check-schemas

.PHONY: check-docs
check-docs: $(tools) $(bin)/quadmesh ## the examples in the documents and in --help run; links and names hold
	@QM_BIN=$(abspath $(bin)) scripts/check-docs

.PHONY: check-slurm
check-slurm: $(tools) ## forty models on a Slurm cluster of this host, whose second node is killed in the middle
	@scripts/install-dependencies --verify build slurm
	@QM_BIN=$(abspath $(bin)) tests/slurm/run $(abspath $(O))/check-slurm 40

.PHONY: check-faults
check-faults: $(tools) ## what the tools leave when killed=200 times, without disk or memory, with damaged input; seed=1
	@QM_BIN=$(abspath $(bin)) tests/faults/run $(abspath $(O))/check-faults $(killed) $(seed)

.PHONY: check-options
check-options: $(tools) $(bin)/quadmesh ## tried=2000 command lines made at random; seed=1 chooses them
	@QM_BIN=$(abspath $(bin)) JOBS=$(jobs) tests/faults/options $(abspath $(O))/check-options $(tried) $(seed)

.PHONY: check-pairs
check-pairs: $(tools) $(bin)/quadmesh ## every option of every tool together with every other one
	@QM_BIN=$(abspath $(bin)) JOBS=$(jobs) tests/faults/pairs $(abspath $(O))/check-pairs

# One test file alone, the quick way while writing it: `make test-cut` builds and runs tests/unit/cut/cut_test.cpp.
test-%: $(O)/tests/%_test
	$< $(if $(only),--gtest_filter='*$(only)*')
test_object = $(or $(filter %/$1_test.o,$(unit_tests) $(properties)),$(error no file below tests is $1_test.cpp))
.SECONDEXPANSION:
$(O)/tests/%_test: $$(call test_object,$$*) $(support) $(library)
	$(call quietly,link,$@) $(link) $^ -o $@ $(gtest) $(libraries)

# ------------------------------------------------------------------------------------------ more checks

.PHONY: lint
lint: ## clang-format and clang-tidy; every header compiles on its own
	@scripts/install-dependencies --verify build check lint
	@$(again) check-headers
	@JOBS=$(jobs) scripts/lint $(O) -- $(filter-out -Werror $(unrolled),$(compile))

.PHONY: check-packages
check-packages: ## compare what is used with the packages that `make deps` installs
	@scripts/check-packages $(compile)

.PHONY: format
format: ## lay out the sources as .clang-format says
	@clang-format -i $(shell find lib tools tests -name '*.h' -o -name '*.cpp')

.PHONY: fuzz
fuzz: ## run every fuzzer for seconds=60
	@scripts/install-dependencies --verify build fuzz
	@$(again) config=fuzz run-fuzzers

.PHONY: run-fuzzers
run-fuzzers: $(fuzzers)
	@for fuzzer in $^; do \
	    corpus=$(O)/corpus/$${fuzzer##*/}; \
	    mkdir -p $$corpus; \
	    echo "$$fuzzer"; \
	    $$fuzzer -max_total_time=$(seconds) -timeout=20 -rss_limit_mb=2048 -verbosity=0 $$corpus tests/data; \
	done

$(O)/fuzz/%: $(O)/tests/fuzz/%.o $(samples) $(library)
	@mkdir -p $(@D)
	$(call quietly,link,$@) $(link) -fsanitize=fuzzer $^ -o $@ $(libraries)

.PHONY: coverage
coverage: ## run the tests with config=coverage and print the lines that they reach, file by file
	@scripts/install-dependencies --verify build check coverage
	@$(again) config=coverage all programs-of-tests
	@find build/coverage -name '*.gcda' -delete
	@scripts/check coverage '$(only)' unit property cli
	@scripts/coverage build/coverage

.PHONY: bench
bench: ## time the kernels (Google Benchmark; only=REGEX to filter) and print the tables of bench-search
	@scripts/install-dependencies --verify build bench check
	@$(again) run-benchmarks only='$(only)'
	@$(if $(only),,$(again) run-search-tables)

.PHONY: bench-search
bench-search: ## the search beside plain CBC and the paper's algorithms, as tables; only=REGEX to filter meshes
	@scripts/install-dependencies --verify build bench check
	@$(again) run-search-tables only='$(only)'

.PHONY: run-benchmarks run-search-tables
run-benchmarks: $(O)/tests/benchmarks
	$< $(if $(only),--benchmark_filter='$(only)')
run-search-tables: $(O)/tests/search-tables
	$< '$(only)'

# What tests share needs gtest.
$(O)/tests/benchmarks: $(benchmarks) $(support) $(library)
	@mkdir -p $(@D)
	$(call quietly,link,$@) $(link) $^ -o $@ -lbenchmark_main -lbenchmark -lgtest $(libraries)

$(O)/tests/search-tables: $(tables) $(bench_parts) $(support) $(library)
	@mkdir -p $(@D)
	$(call quietly,link,$@) $(link) $^ -o $@ -lgtest $(libraries)

.PHONY: bench-dev
bench-dev: ## run the pipeline on a folder of real meshes and print a table; only=REGEX to filter
	@scripts/install-dependencies --verify build bench
	@$(again) all
	@QM_BIN=$(abspath $(bin)) scripts/bench-dev '$(only)'

.PHONY: bench-surfaces
bench-surfaces: ## fit and export surfaces for a folder of real meshes and print tables; only=REGEX to filter
	@scripts/install-dependencies --verify build bench
	@$(again) all $(programs)
	@QM_BIN=$(abspath $(bin)) PROGRAMS=$(abspath $(O)/tests) scripts/bench-surfaces '$(only)'

.PHONY: bench-scale
bench-scale: ## how time and memory of every stage grow up to QUADS=4000000, as tables
	@scripts/install-dependencies --verify build bench
	@$(again) all $(O)/tests/refine
	@QM_BIN=$(abspath $(bin)) REFINE=$(abspath $(O)/tests/refine) scripts/bench-scale

# The peer is a library of headers, which brings the ones that it needs.
.PHONY: bench-peers
bench-peers: ## base complexes and layouts beside those of CINOLIB=FOLDER, a copy of cinolib, as a table; only=REGEX to filter
	@scripts/install-dependencies --verify build bench
	@$(if $(CINOLIB),$(again) all $(O)/peers/cinolib,echo 'bench-peers: skipped: set CINOLIB to a folder that holds cinolib')
	@$(if $(CINOLIB),QM_BIN=$(abspath $(bin)) scripts/bench-peers $(O)/peers/cinolib '$(only)')

$(O)/peers/cinolib: scripts/peers/cinolib.cpp
	@mkdir -p $(@D)
	$(call quietly,compile,$<) $(CXX) -std=c++17 -w $(CXXFLAGS) -I$(CINOLIB)/include -I$(CINOLIB)/external \
	    $(shell pkg-config --cflags eigen3 2>/dev/null) $< -o $@

.PHONY: bench-cad
bench-cad: ## what CAD systems and meshers do with our STEP files, as a table; only=REGEX to filter models
	@scripts/install-dependencies --verify build bench
	@$(again) all $(programs)
	@QM_BIN=$(abspath $(bin)) BILINEAR_STEP=$(abspath $(O)/tests/bilinear-step) scripts/bench-cad '$(only)'

.PHONY: pictures
pictures: ## make the pictures of README.md anew
	@scripts/install-dependencies --verify build view remesh
	@$(again) all
	@QM_BIN=$(abspath $(bin)) scripts/pictures docs/pictures

.PHONY: compile-commands
compile-commands: compile_commands.json ## compile_commands.json, how every source is compiled, for editors and clang's tools
compile_commands.json: FORCE
	@scripts/compile-commands $(sort $(sources) $(shell find tools tests -name "*.cpp")) > $@
compile_commands.json: export command = $(filter-out ccache $(unrolled),$(compile))

# --------------------------------------------------------------------------------------------- install

commands    := quadmesh $(tool_names)
man_pages   := $(commands:%=$(O)/man/%.1)
shells      := bash zsh fish
completions := $(shells:%=$(O)/completion/%)

.PHONY: man
man: $(man_pages) ## the manual pages, from the tools' own --help

$(O)/man/%.1: $(bin)/% scripts/man VERSION
	@mkdir -p $(@D)
	$(call quietly,man,$@) scripts/man $< > $@

.PHONY: completion
completion: $(completions) ## completion for bash, zsh and fish, from the tools' own descriptions

$(completions): $(O)/completion/%: $(tools) $(bin)/quadmesh scripts/completion
	@mkdir -p $(@D)
	$(call quietly,complete,$@) scripts/completion $* $(commands:%=$(bin)/%) > $@

# What is installed, by the folder it goes to.
man_folder     := share/man/man1
bash_folder    := share/bash-completion/completions
zsh_folder     := share/zsh/site-functions
fish_folder    := share/fish/vendor_completions.d
own_folders    := include/quadmesh share/quadmesh share/doc/quadmesh
installed      := $(commands:%=bin/%) $(commands:%=$(man_folder)/%.1) $(commands:%=$(bash_folder)/%) \
                  $(zsh_folder)/_quadmesh $(commands:%=$(fish_folder)/%.fish) \
                  lib/libquadmesh.a lib/pkgconfig/quadmesh.pc
public_headers := $(filter-out lib/cli/%,$(headers))

# The archive brings no list of what it needs, so whoever links it gets all libraries; --as-needed drops the rest.
define pkg_config
prefix=$(prefix)
includedir=$${prefix}/include
libdir=$${prefix}/lib

Name: quadmesh
Description: From quad meshes to layouts of four-sided patches and B-spline surfaces
Version: $(version)
Requires: $(filter-out CLI11,$(packages))
Cflags: -I$${includedir} -I$${includedir}/quadmesh -DVALIJSON_USE_EXCEPTIONS=1
Libs: -Wl,--as-needed -L$${libdir} -lquadmesh $(others:%=-l%) -pthread
endef

.PHONY: install
install: all man completion ## install tools, library and headers below DESTDIR and prefix=/usr/local
	install -d $(addprefix $(DESTDIR)$(prefix)/,$(sort $(dir $(installed))) $(own_folders))
	install $(tools) pipelines/quadmesh $(DESTDIR)$(prefix)/bin
	install -m 644 $(man_pages) $(DESTDIR)$(prefix)/$(man_folder)
	for command in $(commands); do \
	    install -m 644 $(O)/completion/bash $(DESTDIR)$(prefix)/$(bash_folder)/$$command; \
	    grep -e '^#' -e "^complete -c $$command " $(O)/completion/fish > $(DESTDIR)$(prefix)/$(fish_folder)/$$command.fish; \
	done
	install -m 644 $(O)/completion/zsh $(DESTDIR)$(prefix)/$(zsh_folder)/_quadmesh
	install -m 644 $(library) $(DESTDIR)$(prefix)/lib
	printf '%s\n' "$$pkg_config" > $(DESTDIR)$(prefix)/lib/pkgconfig/quadmesh.pc
	cd lib && cp --parents --no-preserve=all $(public_headers:lib/%=%) $(abspath $(DESTDIR)$(prefix))/include/quadmesh
	chmod -R u=rwX,go=rX $(DESTDIR)$(prefix)/include/quadmesh
	install -D -m 644 -t $(DESTDIR)$(prefix)/share/quadmesh/schemas $(schemas)
	install -D -m 644 -t $(DESTDIR)$(prefix)/share/quadmesh/pipelines pipelines/layout.mk pipelines/report.html
	install -D -t $(DESTDIR)$(prefix)/share/quadmesh/pipelines $(addprefix pipelines/,layout.sh slurm run-stage find-meshes report)
	install -m 644 README.md ARCHITECTURE.md CHANGELOG.md LICENSE schemas/FORMAT.md $(DESTDIR)$(prefix)/share/doc/quadmesh
install: export pkg_config := $(pkg_config)

.PHONY: uninstall
uninstall: ## remove what `make install` put below DESTDIR and prefix
	rm -f $(installed:%=$(DESTDIR)$(prefix)/%)
	rm -rf $(own_folders:%=$(DESTDIR)$(prefix)/%)

.PHONY: deb
deb: ## Debian packages of the tools and the library, in build/deb
	@scripts/install-dependencies --verify build check deb
	@$(again) all man completion
	rm -rf build/deb
	DEB_BUILD_OPTIONS=noautodbgsym debian/rules binary
	debian/rules clean

.PHONY: clean
clean: ## remove what was built
	rm -rf build bin

.PHONY: FORCE
FORCE:
