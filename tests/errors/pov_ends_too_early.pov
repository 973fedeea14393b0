// SPDX-License-Identifier: Apache-2.0
torus { 1 }
