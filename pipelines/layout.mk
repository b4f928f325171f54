# From meshes to surfaces, every stage kept in a file of its own. README.md beside this file tells more.
#
#   make -f pipelines/layout.mk out/part.surfaces.json                     one model, looked for in MESH_PATH
#   make -f pipelines/layout.mk -j8 MESH_PATH=meshes                       every model there is
#   make -f pipelines/layout.mk CUT_OPTIONS='--chi 20' out/part.surfaces.json
#
# A stage runs again exactly if the file before it is newer, or its options are not those of the last time.
# A file that was edited by hand is newer than the one before it: it is kept, and what follows is made anew.

SHELL := bash
.SHELLFLAGS := -euo pipefail -c
MAKEFLAGS += --no-builtin-rules --warn-undefined-variables
.SUFFIXES:
.DELETE_ON_ERROR:
.SECONDARY:

here := $(dir $(lastword $(MAKEFILE_LIST)))

# The settings may stand on the command line, in the environment, or in this file.
OPTIONS_FILE ?= layout.options.mk
-include $(OPTIONS_FILE)

MESH_PATH ?= .#     folders to look for part.obj, part.off or part.ply in
OUT       ?= out#   folder of the documents
# Options of the stages. For one model alone: CUT_OPTIONS.part = --chi 20
BASECOMPLEX_OPTIONS ?=
FEATURES_OPTIONS    ?=
CUT_OPTIONS         ?=
ENUMERATION_OPTIONS ?=
LAYOUT_OPTIONS      ?=
PRUNED_OPTIONS      ?=
SURFACES_OPTIONS    ?=

# In how many parts the sub-meshes of a model are searched, so that -j spreads one large model too.
PARTS               ?= 1

# Set, it makes a stage fail that wrote its document but not what was asked for (exit status 3).
STRICT              ?=
# Options that change no result, for every tool: --quiet, --verbose, --jobs N. They make nothing run again.
COMMON_OPTIONS ?=

# The tools: in a source tree, installed, or wherever PATH finds them.
QM_BIN ?=
beside := $(firstword $(wildcard $(here)../bin/qm-basecomplex $(here)../../../bin/qm-basecomplex))
bin    := $(or $(QM_BIN),$(patsubst %/qm-basecomplex,%,$(beside)))
export PATH := $(if $(bin),$(abspath $(bin)):)$(PATH)

folders := $(subst :, ,$(MESH_PATH))
meshes  := $(foreach folder,$(folders),$(wildcard $(folder)/*.obj $(folder)/*.off $(folder)/*.ply))
vpath %.obj $(folders)
vpath %.off $(folders)
vpath %.ply $(folders)

.PHONY: all
all: $(sort $(patsubst %,$(OUT)/%.surfaces.json,$(basename $(notdir $(meshes)))))

# --------------------------------------------------------------------------------------------- one stage

# $(call options,STAGE,model): those of the model, or else of all models.
options = $(strip $(if $(filter undefined,$(flavor $(1)_OPTIONS.$(2))),$($(1)_OPTIONS),$($(1)_OPTIONS.$(2))))

# $(call stage,kind,STAGE,tool,file before): the rule of a stage.
define stage
$(OUT)/%.$(1).json: $(4) $(OUT)/.stages/%.$(1).options
	@$$(call put_edits_aside,$(OUT)/.stages/$$*.$(1).sha256)
	$(3) $$(strip $$(COMMON_OPTIONS) $$(call options,$(2),$$*) $$< -o $$@) || [[ $$$$? == 3 && -z '$$(STRICT)' ]]
	@sha256sum $$@ > $(OUT)/.stages/$$*.$(1).sha256
endef

# $(call part_rule,enumeration.I-N): the rule of a part of the search.
define part_rule
$(OUT)/.stages/%.$(1).json: $(OUT)/%.cut.json $(OUT)/.stages/%.enumeration.options
	qm-enum --part $(subst -,/,$(1:enumeration.%=%)) $$(strip $$(COMMON_OPTIONS) $$(call options,ENUMERATION,$$*) $$< -o $$@) || \
	    [[ $$$$? == 3 && -z '$$(STRICT)' ]]
endef

# $(call stamp,kind,STAGE): the options of the last run; touched when they change.
define stamp
$(OUT)/.stages/%.$(1).options: FORCE
	@mkdir -p $$(@D) $$(dir $(OUT)/$$*)
	@echo "$$$$stamp" | cmp -s - $$@ || echo "$$$$stamp" > $$@
$(OUT)/.stages/%.$(1).options: export stamp = $$(call options,$(2),$$*)
endef

# Nobody's work is lost: a file that was edited and is about to be made again is renamed first.
put_edits_aside = if [[ -e $@ && -e $(1) ]] && ! sha256sum --status --check $(1); then \
    mv $@ $@.edited; \
    echo "layout.mk: $@ was edited by hand, but what it is made from has changed. It is now $@.edited" >&2; \
fi

.PHONY: FORCE
FORCE:

# -------------------------------------------------------------------------------------------- all stages

$(foreach suffix,obj off ply,$(eval $(call stage,basecomplex,BASECOMPLEX,qm-basecomplex,%.$(suffix))))
$(eval $(call stage,features,FEATURES,qm-features,$(OUT)/%.basecomplex.json))
$(eval $(call stage,cut,CUT,qm-cut,$(OUT)/%.features.json))
ifeq ($(strip $(PARTS)),1)
$(eval $(call stage,enumeration,ENUMERATION,qm-enum,$(OUT)/%.cut.json))
else
parts := $(foreach number,$(shell seq $(PARTS)),enumeration.$(number)-$(strip $(PARTS)))
$(foreach part,$(parts),$(eval $(call part_rule,$(part))))
$(OUT)/%.enumeration.json: $(foreach part,$(parts),$(OUT)/.stages/%.$(part).json)
	@$(call put_edits_aside,$(OUT)/.stages/$*.enumeration.sha256)
	qm-enum --join $(strip $(COMMON_OPTIONS) $^ -o $@)
	@sha256sum $@ > $(OUT)/.stages/$*.enumeration.sha256
endif
$(eval $(call stage,layout,LAYOUT,qm-merge,$(OUT)/%.enumeration.json))
$(eval $(call stage,pruned,PRUNED,qm-prune,$(OUT)/%.layout.json))
$(eval $(call stage,surfaces,SURFACES,qm-bspline,$(OUT)/%.pruned.json))

$(eval $(call stamp,basecomplex,BASECOMPLEX))
$(eval $(call stamp,features,FEATURES))
$(eval $(call stamp,cut,CUT))
$(eval $(call stamp,enumeration,ENUMERATION))
$(eval $(call stamp,layout,LAYOUT))
$(eval $(call stamp,pruned,PRUNED))
$(eval $(call stamp,surfaces,SURFACES))
