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
# Make/options goes through cpp, where `linux` is a macro: paths that may hold
# it (MPI's) are asked for here. This file does not go through cpp.

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
INTERDEMFOAM_ARCH ?= native
c++OPT = -std=c++17 -O3 -march=$(INTERDEMFOAM_ARCH) -ffp-contract=off \
    -D__restrict__= -fno-tree-slp-vectorize
c++WARN = -Wall -Wextra -Wnon-virtual-dtor $(FOAM_EXTRA_CXXFLAGS)

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

# OpenFOAM's headers do not change: only ours are looked at for dependencies
WMKDEP_FLAGS += -q
