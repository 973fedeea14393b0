// SPDX-License-Identifier: Apache-2.0
box { -1, 1 finish { phong_sise 3 } }
