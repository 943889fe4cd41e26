# SPDX-License-Identifier: MIT
load "tools/chart/power.gp"
