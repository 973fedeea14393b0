// SPDX-License-Identifier: Apache-2.0
sphere { 0, 1 finish { subsurface { transmit 1 } } }
