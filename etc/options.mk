# SPDX-License-Identifier: GPL-3.0-or-later
# What all our Make/options share. Use:
#
#   include $(INTERDEMFOAM_DIR)/etc/options.mk
#   EXE_INC  = $(call foam,finiteVolume meshTools) $(call ours,granular)
#   LIB_LIBS = $(OUR_LIBS) -lgranular
#
# foam  folders below OpenFOAM's src: their headers, as system headers so that
#       warnings in them do not count
# ours  folders below our src
# MPI_INC MPI_LIBS GRAINS_INC GRAINS_LIBS EIGEN_INC   where these are called
#
# Make/options goes through cpp, where `linux` is a macro. Paths that may contain it
# (MPI's) are determined here, since this file does not go through cpp.

# Code is made for the machine that builds it. A fused multiply-add rounds once
# where OpenFOAM's packaged libraries round twice; without contraction a run
# without grains is interFoam's to the last bit.
#
# OpenFOAM promises the compiler (__restrict__, in ListLoopM.H, v1912 to v2506)
# that the result of a product of fields is not one of its operands, and then
# writes the result of `tensor & tmp<vector>` over the vector. In v1912 at -O3
# every number but the first is wrong by it. The promise is taken away here; for
# OpenFOAM's own libraries see src/common/fieldProducts.
#
# With AVX-512, GCC 12 packs the unrolled products of tensors wrongly (a plain loop
# over `a[i] & b[i]`: off by a half in the last element of an odd number); loops
# are still vectorised without.
#
# Roots that need not report an error are taken of several numbers in one instruction.
INTERDEMFOAM_ARCH ?= native
optimise ?= -O3
c++OPT = -std=c++17 $(optimise) -march=$(INTERDEMFOAM_ARCH) -ffp-contract=off \
    -fno-math-errno -D__restrict__= -fno-tree-slp-vectorize $(usePrecompiled)
c++WARN = -Wall -Wextra -Wnon-virtual-dtor -Winvalid-pch $(FOAM_EXTRA_CXXFLAGS)

foam = $(foreach d,$(1),-isystem $(LIB_SRC)/$(d)/lnInclude)
ours = $(foreach d,$(1),-I$(INTERDEMFOAM_DIR)/src/$(d)/lnInclude)
OUR_LIBS = -L$(FOAM_USER_LIBBIN)

PROJECT_INC = $(call foam,$(WM_PROJECT) OSspecific/$(WM_OSTYPE))

MPI_INC := -DOMPI_SKIP_MPICXX \
    $(patsubst -I%,-isystem %,$(shell mpicxx --showme:compile))
MPI_LIBS := $(shell mpicxx --showme:link)
GRAINS_INC = -isystem /usr/include/liggghts
GRAINS_LIBS = -lliggghts

# GCC 12 takes its own AVX-512 header for a cause of uninitialised numbers. With
# AVX-512, Eigen's fast root of zero is infinity times zero on the way, at which
# OpenFOAM's trap stops the program
EIGEN_INC = -isystem /usr/include/eigen3 -DEIGEN_FAST_MATH=0 \
    -Wno-maybe-uninitialized

# Headers of others take three quarters of a compilation. What a part names in "precompile"
# (nothing where that is empty) is read once, by Allwmake with "wmake precompiled", for all
# parts that name the same; where one of its headers changes, again.
precompile ?= $(INTERDEMFOAM_DIR)/etc/openfoam.H
PRECOMPILED = $(INTERDEMFOAM_DIR)/platforms/$(WM_OPTIONS)/$(subst \
    /,.,$(patsubst $(INTERDEMFOAM_DIR)/%,%,$(precompile)))
usePrecompiled = $(patsubst %.gch,-include %,$(wildcard $(PRECOMPILED).gch))

.PHONY: precompiled
precompiled: $(PRECOMPILED).gch ; @:
$(PRECOMPILED).gch: usePrecompiled =
$(PRECOMPILED).gch: $(precompile)
	echo '#include "$(precompile)"' > $(PRECOMPILED)
	$(CC) $(c++FLAGS) -MD -MF $(PRECOMPILED).d -x c++-header $(PRECOMPILED) -o $@.part
	mv $@.part $@
# The first target of wmake's own files stays what is made by default
.DEFAULT_GOAL :=

# OpenFOAM's headers do not change: only ours are looked at for dependencies
WMKDEP_FLAGS += -q
