// SPDX-License-Identifier: Apache-2.0
#include "pov_command.h"

namespace sundog::app {

std::string pov_help() {
    return R"(Render a POV-Ray scene, called as povray is.
Usage: sundog pov [+|-SWITCH | Option=value | FILE.ini[section] | SCENE.pov]…

Words are read from left to right, after povray.ini; later ones win. Letters may have any case; + and - are the same
but for switches that turn something on or off.
  +Ifile +HIfile +Lfolder +MVn.n     scene, header, library path, language version     Declare=Name=number
  +Wn +Hn +SCn +ECn +SRn +ERn        width, height; part of the picture, in pixels or as fractions under 1
  +Ofile +F[BCEHJNPT][depth] +UA     output (a folder/ and - too), format and bits a channel, alpha    File_Gamma=n
  +A[threshold] +AMn +Rn +J[n] +Qn   antialiasing, its method, depth and jitter; quality
  +Kn +KFIn +KFFn +KIn +KFn +KC      clock; first and last frame and their clocks; cyclic
  +SFn +EFn +STPn +C                 part of the frames, every n-th one; leave out frames that are there
  +WTn +GA +GDfile …  +GIfile        threads; texts to console and files; write an INI file of the settings
Sundog's own:
  --device NAME       auto, cpu or gpu
  --format            print the scene in normalised language, each identifier replaced by what it stands for
  --sandbox           read only below the scene's folder and the library paths
  --allow-write DIR   what scenes and INI files may write besides the output's folder
  --max-steps N       how long a scene's program may run (2000000000 tokens)
  --max-memory MB     how much memory its declarations may take (half of the machine's)
No command that an INI file names (Pre_Scene_Command and its kin) is ever run.
Exit status: 0 done, 1 an error, 2 interrupted; what was done by then is written.
Examples:
  sundog pov scene.pov +W800 +H600 +A0.1
  sundog pov +Iturn.pov +Oframes/ +KFF120 +KC
The program called by the name povray (ln -s sundog povray) does the same.
)";
}

}  // namespace sundog::app
