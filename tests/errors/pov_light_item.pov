// SPDX-License-Identifier: Apache-2.0
light_source { <0, 5, 0>, rgb 1 hollow }
