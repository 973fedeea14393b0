// SPDX-License-Identifier: Apache-2.0
global_settings { subsurface { samples 50, 0 } }
