# SPDX-License-Identifier: MIT
load "tools/chart/frames.gp"
