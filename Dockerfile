# SPDX-License-Identifier: GPL-3.0-or-later
# Debian 12 with everything that the commands of the README need:
#   docker build -t apm-autopilot .
#   docker run --rm -it apm-autopilot toolchain/fly
#   docker run --rm -it apm-autopilot toolchain/test
FROM debian:12

WORKDIR /project

# First what is installed, so that a change of the sources does not install it again.
COPY toolchain/setup toolchain/setup
COPY toolchain/node toolchain/node
COPY toolchain/shared toolchain/shared
COPY web/package.json web/package-lock.json web/
RUN toolchain/setup test && rm -rf /var/lib/apt/lists/*

COPY . .
CMD ["toolchain/fly"]
