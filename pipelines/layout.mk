# From meshes to surfaces, every stage kept in a file of its own. README.md beside this file tells more.
#
#   make -f pipelines/layout.mk out/part.step out/part.html                one model, looked for in MESH_PATH
#   make -f pipelines/layout.mk -j8 MESH_PATH=meshes                       surfaces of every model there is
#   make -f pipelines/layout.mk -j8 MESH_PATH=meshes report                one page for all of them
#   make -f pipelines/layout.mk CUT_OPTIONS='--chi 20' out/part.step
#
# A stage runs again exactly if the file before it is newer, or its options are not those of the last time.
# A file that was edited by hand is newer than the one before it: it is kept, and what follows is made anew.

SHELL := bash
.SHELLFLAGS := -euo pipefail -c
MAKEFLAGS += --no-builtin-rules
.SUFFIXES:
.DELETE_ON_ERROR:
.SECONDARY:

here := $(dir $(lastword $(MAKEFILE_LIST)))

# The settings may stand on the command line, in the environment, or in this file.
OPTIONS_FILE ?= layout.options.mk
-include $(OPTIONS_FILE)

MESH_PATH ?= .#     folders to look for part.obj, part.off, part.ply or part.stl in
OUT       ?= out#   folder of the documents
# Meshes of triangles: about so many quads are made of each; other meshes that are not all quads: the word subdivide.
# For one model alone: QUADS.part = 5000
QUADS     ?=
# Options of the stages. For one model alone: CUT_OPTIONS.part = --chi 20
QUADS_OPTIONS       ?=
BASECOMPLEX_OPTIONS ?=
FEATURES_OPTIONS    ?=
CUT_OPTIONS         ?=
ENUMERATION_OPTIONS ?=
LAYOUT_OPTIONS      ?=
PRUNED_OPTIONS      ?=
SURFACES_OPTIONS    ?=
STEP_OPTIONS        ?=
HTML_OPTIONS        ?=
PNG_OPTIONS         ?= --show surfaces,borders --no-key
SUMMARY_OPTIONS     ?=
# In how many parts the sub-meshes of a model are searched, so that -j spreads one large model too.
PARTS               ?= 1
# Set, it makes a stage fail that wrote its file but not what was asked for (exit status 3).
STRICT              ?=
export STRICT OUT
# Options that change no result, for every tool: --quiet, --verbose, --jobs N. They make nothing run again.
COMMON_OPTIONS ?=

# Memory on huge pages, which are set up faster. C libraries without that setting ignore it.
GLIBC_TUNABLES ?= glibc.malloc.hugetlb=1
export GLIBC_TUNABLES

# The tools: in a source tree, installed, or wherever PATH finds them.
QM_BIN ?=
beside := $(firstword $(wildcard $(here)../bin/qm-basecomplex $(here)../../../bin/qm-basecomplex))
bin    := $(or $(QM_BIN),$(patsubst %/qm-basecomplex,%,$(beside)))
export PATH := $(if $(bin),$(abspath $(bin)):)$(PATH)

# What make cannot handle.
ifeq ($(wildcard $(here)run-stage),)
$(error the path of layout.mk has blanks, which make cannot handle. Move or link it)
endif
ifneq ($(words $(OUT))$(findstring :,$(OUT))$(findstring %,$(OUT))$(findstring =,$(OUT)),1)
$(error OUT is '$(OUT)': make needs the name of one folder, without blanks, colons, % and =)
endif
$(foreach name,$(filter $(OUT)/%,$(.VARIABLES)),$(error $(name)=...: targets have no =. Write an underscore for each))

# Meshes whose names make cannot handle, such as those with blanks, are linked under other names.
links    := $(OUT)/.meshes
meshes   := $(shell $(here)find-meshes '$(subst ','\'',$(MESH_PATH))' '$(links)' $(and $(MESHES_ARE_TOLD),2>/dev/null))
left_out := $(filter-out 0,$(.SHELLSTATUS))
folders := $(sort $(dir $(meshes)) $(wildcard $(subst :, ,$(MESH_PATH))))
models  := $(sort $(basename $(notdir $(meshes))))
endings := obj off ply stl
$(foreach ending,$(endings),$(eval vpath %.$(ending) $(folders)))

.PHONY: all
all: $(models:%=$(OUT)/%.surfaces.json)
	$(require_meshes)
	@$(list_unmet)
	@$(fail_if_left_out)

require_meshes   = $(if $(meshes),,$(error no meshes in '$(MESH_PATH)'))
fail_if_left_out = $(if $(left_out),echo 'layout.mk: not every mesh was made: see the first lines' >&2; exit 1,:)

# What missed a limit is told once more when all is done.
list_unmet = find $(OUT)/.stages -name '*.unmet' ! -name '*.summary.json.unmet' -print0 | sort -z | xargs -r0 sed 's/^/layout.mk: /' >&2

# --------------------------------------------------------------------------------------------- one stage

# $(call options,STAGE,model): those of the model, or else of all models.
own     = $(if $(filter undefined,$(flavor $(1).$(2))),$($(1)),$($(1).$(2)))
options = $(strip $(call own,$(1)_OPTIONS,$(2)) $(and $(call own,QUADS,$(2)),$(call of_scan.$(1),$(2))))
# A mesh of triangles is what quads are made of, and what the surfaces are fitted to.
subdivided       = $(filter subdivide,$(call own,QUADS,$(1)))
of_scan.QUADS    = $(if $(subdivided),--subdivide,--quads $(call own,QUADS,$(1)))
of_scan.SURFACES = $(if $(subdivided),,--reference $(call mesh_of,$(1)))
mesh_of = $(or $(mesh_of.$(1)),$(1).stl)
$(foreach mesh,$(meshes),$(eval mesh_of.$(basename $(notdir $(mesh))) := $(mesh)))

# $(call stage,ending,STAGE,tool,file before,option for the output,model): the rule of a stage; of one model if one is named.
define stage
$(if $(6),$(OUT)/$(6).$(1): )$(OUT)/%.$(1): $(4) $(OUT)/.stages/%.$(1).options
	$(here)run-stage $(3) $$(strip $$(COMMON_OPTIONS) $$(call options,$(2),$$*) $$< $(5) $$@)
endef

# $(call part_rule,enumeration.I-N): the rule of a part of the search.
define part_rule
$(OUT)/.stages/%.$(1).json: $(OUT)/%.cut.json $(OUT)/.stages/%.enumeration.json.options
	$(here)run-stage qm-enum --part $(subst -,/,$(1:enumeration.%=%)) $$(strip $$(COMMON_OPTIONS) $$(call options,ENUMERATION,$$*) $$< -o $$@)
endef

# Make takes the words of a target for several files.
require_one_word = $(if $(word 2,$*),$(error $*: targets have no blanks. Write underscores: $(subst $(empty) $(empty),_,$*)))

# $(call stamp,ending,STAGE): the options of the last run, written when they change. Make itself compares them, when it
# expands prerequisites for the second time, without a process for each stage of each model.
define stamp
$(OUT)/.stages/%.$(1).options: $$$$(require_one_word)$$$$(call force_if_other,$$$$@,$$$$(call options,$(2),$$$$*))
	@mkdir -p $$(@D) $$(dir $(OUT)/$$*)
	@printf '%s\n' "$$$$stamp" > $$@
$(OUT)/.stages/%.$(1).options: export stamp = $$(call options,$(2),$$*)
endef
force_if_other = $(if $(wildcard $(1)),$(if $(call are_equal,$(file <$(1)),$(2)),,FORCE),FORCE)
are_equal      = $(if $(subst <$(1)>,,<$(2)>)$(subst <$(2)>,,<$(1)>),,1)

.PHONY: FORCE
FORCE:

# -------------------------------------------------------------------------------------------- all stages

# Quads of triangles, where a number of them is asked for: of all models, or of some.
quads_of := $(patsubst QUADS.%,%,$(filter QUADS.%,$(.VARIABLES)))
$(if $(QUADS),$(foreach ending,$(endings),$(eval $(call stage,quads.obj,QUADS,qm-remesh,%.$(ending),-o,))))
$(foreach model,$(sort $(quads_of) $(and $(QUADS),$(models))),$(eval $(call stage,quads.obj,QUADS,qm-remesh,$(call mesh_of,$(model)),-o,$(model))))
$(foreach model,$(or $(and $(QUADS),%),$(quads_of)),\
    $(eval $(call stage,basecomplex.json,BASECOMPLEX,qm-basecomplex,$(OUT)/%.quads.obj,-o,$(filter-out %,$(model)))))

# Of the mesh that was found; and of one in a folder below, as out/folder/part.
$(foreach model,$(filter-out $(if $(QUADS),%,$(quads_of)),$(models)),\
    $(eval $(call stage,basecomplex.json,BASECOMPLEX,qm-basecomplex,$(mesh_of.$(model)),-o,$(model))))
$(foreach ending,$(endings),$(eval $(call stage,basecomplex.json,BASECOMPLEX,qm-basecomplex,%.$(ending),-o,)))
$(eval $(call stage,features.json,FEATURES,qm-features,$(OUT)/%.basecomplex.json,-o,))
$(eval $(call stage,cut.json,CUT,qm-cut,$(OUT)/%.features.json,-o,))
ifeq ($(strip $(PARTS)),1)
$(eval $(call stage,enumeration.json,ENUMERATION,qm-enum,$(OUT)/%.cut.json,-o,))
else
numbers := $(shell seq '$(subst ','\'',$(strip $(PARTS)))' 2>/dev/null | head -n 10001)
ifneq ($(firstword $(numbers)) $(lastword $(numbers)),1 $(strip $(PARTS)))
$(error PARTS is '$(PARTS)': it must be a whole number from 1 to 10000)
endif
parts := $(foreach number,$(numbers),enumeration.$(number)-$(strip $(PARTS)))
$(foreach part,$(parts),$(eval $(call part_rule,$(part))))
$(OUT)/%.enumeration.json: $(foreach part,$(parts),$(OUT)/.stages/%.$(part).json)
	$(here)run-stage qm-enum --join $(strip $(COMMON_OPTIONS) $^ -o $@)
endif
$(eval $(call stage,layout.json,LAYOUT,qm-merge,$(OUT)/%.enumeration.json,-o,))
$(eval $(call stage,pruned.json,PRUNED,qm-prune,$(OUT)/%.layout.json,-o,))
$(eval $(call stage,surfaces.json,SURFACES,qm-bspline,$(OUT)/%.pruned.json,-o,))
# What other programs and people want of the surfaces.
$(foreach ending,step igs,$(eval $(call stage,$(ending),STEP,qm-export,$(OUT)/%.surfaces.json,-o,)))
$(eval $(call stage,html,HTML,qm-view,$(OUT)/%.surfaces.json,-o,))
$(eval $(call stage,png,PNG,qm-view,$(OUT)/%.surfaces.json,--png,))
$(eval $(call stage,summary.json,SUMMARY,qm-summary --json --quiet,$(OUT)/%.surfaces.json,-o,))

.SECONDEXPANSION:
$(eval $(call stamp,quads.obj,QUADS))
$(eval $(call stamp,basecomplex.json,BASECOMPLEX))
$(eval $(call stamp,features.json,FEATURES))
$(eval $(call stamp,cut.json,CUT))
$(eval $(call stamp,enumeration.json,ENUMERATION))
$(eval $(call stamp,layout.json,LAYOUT))
$(eval $(call stamp,pruned.json,PRUNED))
$(eval $(call stamp,surfaces.json,SURFACES))
$(foreach ending,step igs,$(eval $(call stamp,$(ending),STEP)))
$(eval $(call stamp,html,HTML))
$(eval $(call stamp,png,PNG))
$(eval $(call stamp,summary.json,SUMMARY))

# -------------------------------------------------------------------------------------------- the report

# Pictures are taken by Chromium; without it the report has none.
pictures := $(if $(shell command -v chromium-headless-shell || command -v chromium || command -v chromium-browser || command -v google-chrome),png)

.PHONY: report report-parts
report-parts: $(foreach model,$(models),$(addprefix $(OUT)/$(model).,summary.json step html $(pictures)))
# A model that fails is a line of the report.
report: ## one page for all models, OUT/report.html
	$(require_meshes)
	@mkdir -p $(OUT)/.stages
	@MESHES_ARE_TOLD=1 $(MAKE) --no-print-directory --keep-going -f $(here)layout.mk report-parts || true
	@$(here)report $(OUT) $(models)
	@$(list_unmet)
	@echo "layout.mk: the report is $(OUT)/report.html"
	@$(fail_if_left_out)
