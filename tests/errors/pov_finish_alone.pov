// SPDX-License-Identifier: Apache-2.0
finish { phong 1 }
