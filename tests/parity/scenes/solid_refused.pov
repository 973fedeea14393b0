// SPDX-License-Identifier: Apache-2.0
// A shape that the GPU doesn't draw, in a group of others.
#version 3.7;
camera { location <0, 0, -5> look_at 0 }
light_source { -10*z 1 }
difference {
    sphere { 0, 1 }
    julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 15 }
}
