// SPDX-License-Identifier: Apache-2.0
#include "show/sound.h"

namespace sundog::intro {
namespace {

void fill(void* synth, Uint8* bytes, int count) {
    play(*static_cast<Synth*>(synth), reinterpret_cast<float*>(bytes),
         static_cast<unsigned>(count) / (2 * sizeof(float)));
}

}  // namespace

Sound::Sound(bool wanted) : synth_(1) {
    if (!wanted || SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return;
    SDL_AudioSpec spec{};
    spec.freq = static_cast<int>(kSampleRate);
    spec.format = AUDIO_F32SYS;
    spec.channels = 2;
    spec.samples = 1024;
    spec.callback = fill;
    spec.userdata = synth_.get();
    device_ = SDL_OpenAudioDevice(nullptr, 0, &spec, nullptr, 0);
    if (device_ != 0) SDL_PauseAudioDevice(device_, 0);
}

Sound::~Sound() {
    if (device_ != 0) SDL_CloseAudioDevice(device_);
}

}  // namespace sundog::intro
