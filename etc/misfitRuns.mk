# SPDX-License-Identifier: GPL-3.0-or-later
# Runs of misfitFoam side by side: make -j N <run>/finished ...
%/finished:
	@"$(INTERDEMFOAM_DIR)/etc/misfitRun" $*
