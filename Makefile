# Short names for the usual work. Everything is built by CMake (CMakePresets.json); this file
# only sets up the machine and calls it.
#   make run               set up, build, run the full ring shear test of the 5 % ore
#   make run ARGS=--fresh  the same, with options for `clod run`
#   make test              set up, build, run every test and check
.PHONY: build run chute calibrate test verify validate cross bench bench-peers check-arm format lint package install clean help \
	setup setup-report setup-test setup-peers setup-arm
.DEFAULT_GOAL := build

ARGS :=
NAMES :=
PREFIX := /usr/local
RELEASE := build/release
JOBS := $(shell nproc)

setup: ## install the packages that a build needs
	@tools/setup build

setup-report: ## install what puts the scripts into report pages (npm; 150 MB)
	@tools/setup report

setup-test: ## install the packages that the tests need as well
	@tools/setup test

setup-peers: ## install LIGGGHTS and LAMMPS too, for comparison (500 MB)
	@tools/setup peers

setup-arm: ## install a compiler and an emulator for 64-bit ARM (300 MB)
	@tools/setup arm

build: setup ## build the program, build/release/clod
	@cmake --preset release -DCLOD_TESTS=OFF --log-level=WARNING
	@cmake --build --preset release

run: build ## run the 5 % copper ore into run/copper-ore-5, with ARGS
	$(RELEASE)/clod run cases/copper-ore-5/case.yaml -o run/copper-ore-5 $(ARGS)

chute: build ## run the small transfer chute, dry and at 8 % moisture, and compare them
	@mkdir -p run
	$(RELEASE)/clod run cases/transfer-chute/dry.yaml -o run/chute-dry -t 1 $(ARGS) >run/chute-dry.txt & dry=$$!; \
		$(RELEASE)/clod run cases/transfer-chute/case.yaml -o run/chute-8 -t 1 $(ARGS); wet=$$?; \
		wait $$dry && exit $$wet
	@cases/transfer-chute/table run/chute-dry run/chute-8
	@$(RELEASE)/clod picture run/chute-dry --beside run/chute-8 --time 2.75 --range 0,4 --size 1600x800 \
		-o run/chutes.png
	@$(RELEASE)/clod picture run/chute-8 --color clump_size --hide feed --size 1000x1000 -o run/clumps.png

calibrate: build ## calibrate k_adh of the 5 % ore against its laboratory angle (budget 25 minutes; took 27), with ARGS
	$(RELEASE)/clod calibrate cases/calibrate-kadh/plan.yaml -o run/calibrate-kadh $(ARGS)

test: setup-test ## build and run every test and check
	@cmake --preset test --log-level=WARNING
	@cmake --build --preset test
	@ctest --preset test -j $(JOBS)

verify: setup-test build ## run the verification suite and renew docs/verification.md
	@status=0; $(RELEASE)/clod verify -o build/verify || status=$$?; \
		tools/plot-verification build/verify docs verification && exit $$status

validate: setup-test build ## run the slow tests, or NAMES of them, and renew docs/validation.md
	@status=0; $(RELEASE)/clod verify --slow -o build/validate $(NAMES) || status=$$?; \
		tools/plot-verification build/validate docs validation && exit $$status

cross: setup-peers build ## compare with LIGGGHTS and LAMMPS and renew docs/cross-code.md
	@rm -f build/cross/cross-code.md; status=0; tools/cross-check -o build/cross || status=$$?; \
		[ $$status -gt 1 ] || cp build/cross/cross-code.md docs/cross-code.md; exit $$status

lint: setup-test ## only the checks of the sources
	@cmake --preset test --log-level=WARNING
	@ctest --preset test -j $(JOBS) -L lint

bench: setup-test build ## measure the speed of the step into bench/results/step.md
	@cmake --build --preset release --target bench
	@bench/run-step $(RELEASE)/bench/bench_step >bench/results/step.part
	@mv bench/results/step.part bench/results/step.md
	@cat bench/results/step.md

bench-peers: setup-peers build ## measure beside LIGGGHTS and LAMMPS into bench/results/peers.md, with ARGS
	@cmake --build --preset release --target bench
	@bench/run-peers $(RELEASE)/bench $(ARGS)

check-arm: setup-arm build ## see that clod gives the same bits on 64-bit ARM, in qemu
	@tools/check-arm $(RELEASE)/clod

format: setup-test ## put all sources into the house format
	clang-format-14 -i $$(find src include app tests bench examples -name '*.[ch]')

package: build ## make the Debian packages clod and python3-clod in build/release
	cd $(RELEASE) && cpack -G DEB

install: ## install what was built into PREFIX
	cmake --install $(RELEASE) --prefix $(PREFIX)

clean: ## remove everything that was built; results in run/ stay
	rm -rf build

help: ## this list
	@sed -n 's/^\([a-z-]*\):[^#]*## /\1\t/p' Makefile | expand -t 14
