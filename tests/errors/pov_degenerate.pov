// SPDX-License-Identifier: Apache-2.0
cylinder { x, x, 1 }
