# SPDX-License-Identifier: MIT
# The public headers as pages of their own.

.PHONY: doxygen
doxygen: ## the public headers as pages, in build/doxygen/html; what is not documented is an error
	@mkdir -p $(BUILD)/doxygen
	@doxygen tools/doxygen/Doxyfile
