// SPDX-License-Identifier: Apache-2.0
sphere { 0, 1 matrix <0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1> }
