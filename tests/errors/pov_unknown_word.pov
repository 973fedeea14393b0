// SPDX-License-Identifier: Apache-2.0
camera { locatoin <0, 0, -5> }
