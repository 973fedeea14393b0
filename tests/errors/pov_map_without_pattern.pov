// SPDX-License-Identifier: Apache-2.0
sphere { 0, 1 pigment { colour_map { [0 rgb 1] } } }
