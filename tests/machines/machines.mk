# SPDX-License-Identifier: MIT
# The library as programs of other machines, by QEMU's user mode: one of big-endian byte order, one of 32 bits, one whose
# char is unsigned, one without any of these.

MACHINES := i686 armhf s390x riscv64
MACHINE_CC_i686    := i686-linux-gnu-gcc -O2
MACHINE_CC_armhf   := arm-linux-gnueabihf-gcc -O2
MACHINE_CC_s390x   := s390x-linux-gnu-gcc -O2
MACHINE_CC_riscv64 := riscv64-linux-gnu-gcc -O2
MACHINE_QEMU_i686    := qemu-i386
MACHINE_QEMU_armhf   := qemu-arm
MACHINE_QEMU_s390x   := qemu-s390x
MACHINE_QEMU_riscv64 := qemu-riscv64

# The one of big-endian byte order, and one of the others, which the seed picks.
MACHINES_TESTED := s390x $(call pick,0,i686 armhf riscv64)

SUITES += test-machines
.PHONY: test-machines

$(foreach machine,$(MACHINES),$(eval $(call test_variant,$(machine),$(MACHINE_CC_$(machine)) -static)))
$(foreach machine,$(MACHINES),$(eval $(call test_suite,$(machine),unit))\
    $(eval $(call test_program,$(BUILD)/identity/$(machine),$(machine),$(IDENTITY_SOURCES))))

$(MACHINES:%=$(BUILD)/%/%.o): DEBUG :=

test-machines: $(MACHINES_TESTED:%=$(BUILD)/tests/%/unit) $(MACHINES_TESTED:%=$(BUILD)/identity/%) $(firstword $(IDENTITY_HOST)) ## unit tests and the same bits on a big-endian machine and on another that a seed picks
	@echo "$(if $(EVERY),every machine,TEST_SEED=$(TEST_SEED))"
	$(Q)status=0; $(foreach machine,$(MACHINES_TESTED),echo $(machine); $(MACHINE_QEMU_$(machine)) $(BUILD)/tests/$(machine)/unit || status=1;) exit $$status
	@python3 tests/board/identity.py --host $(firstword $(IDENTITY_HOST)) $(foreach machine,$(MACHINES_TESTED),"$(MACHINE_QEMU_$(machine)) $(BUILD)/identity/$(machine)")
