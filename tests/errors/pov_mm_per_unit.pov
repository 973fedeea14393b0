// SPDX-License-Identifier: Apache-2.0
global_settings { mm_per_unit 0 }
