// SPDX-License-Identifier: Apache-2.0
sphere { 0, 1 finish { subsurface { translucency <1, -2, 1> } } }
