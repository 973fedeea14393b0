# SPDX-License-Identifier: Apache-2.0
# Completion of sundog's commands, options and files for bash. Source it, or put it into
# /usr/share/bash-completion/completions/sundog.

_sundog() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]:-}
  local commands="render view info compare bake bench pov help"
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word")
    return
  fi
  case $before in
    --device) mapfile -t COMPREPLY < <(compgen -W "auto cpu gpu" -- "$word"); return ;;
    --accel)
      if [ "$command" != bench ]; then
        mapfile -t COMPREPLY < <(compgen -W "embree bvh kdtree octree grid boxes none" -- "$word")
        return
      fi ;;
    --method) mapfile -t COMPREPLY < <(compgen -W "paths radiosity" -- "$word"); return ;;
    --denoiser) mapfile -t COMPREPLY < <(compgen -W "auto filter oidn" -- "$word"); return ;;
    --show) mapfile -t COMPREPLY < <(compgen -W "cost" -- "$word"); return ;;
    --tone-map) mapfile -t COMPREPLY < <(compgen -W "linear reinhard aces agx gamma" -- "$word"); return ;;
    --camera) mapfile -t COMPREPLY < <(compgen -W "front back left right top bottom iso" -- "$word"); return ;;
    --sampler) mapfile -t COMPREPLY < <(compgen -W "r2 regular jittered sobol" -- "$word"); return ;;
    --filter) mapfile -t COMPREPLY < <(compgen -W "pixel box tent gaussian mitchell blackman-harris" -- "$word"); return ;;
    --adaptive-method) mapfile -t COMPREPLY < <(compgen -W "1 2" -- "$word"); return ;;
    --adaptive-by) mapfile -t COMPREPLY < <(compgen -W "color object depth" -- "$word"); return ;;
    --scene) mapfile -t COMPREPLY < <(compgen -W "table cornell mirrors glass textured balls gears mount rings tetra tree scan" -- "$word"); return ;;
    --shadows) mapfile -t COMPREPLY < <(compgen -W "on off" -- "$word"); return ;;
    --format) mapfile -t COMPREPLY < <(compgen -W "png jpg exr hdr ppm tga bmp" -- "$word"); return ;;
    --aov) mapfile -t COMPREPLY < <(compgen -W "depth normal albedo object samples cost all" -- "$word"); return ;;
    --size) mapfile -t COMPREPLY < <(compgen -W "640x480 1280x720 1920x1080 3840x2160" -- "$word"); return ;;
    --allow-write) mapfile -t COMPREPLY < <(compgen -d -- "$word"); compopt -o filenames; return ;;
    -o | --output | --environment) mapfile -t COMPREPLY < <(compgen -f -- "$word"); compopt -o filenames; return ;;
    --max-steps | --max-memory | --threads | --spp | --preview | --filter-radius | --adaptive | --adaptive-depth | --target-error | --time-limit | --refine | --max-depth | --min-weight | --time | --patch | --variant | --frames | --fps | --exposure | --white-point | --white-balance | --environment-turn | --environment-gain | --sky | --photons | --radiosity | --radiosity-bounces | --radiosity-error | --turntable | --pixel | --gain | --rounds)
      return ;;
  esac
  local options="--help" files=""
  case $command in
    render)
      options+=" --variant --output --format --size --device --threads --accel --show --spp --sampler --filter --filter-radius --preview --preview-method --adaptive --adaptive-method --adaptive-depth --adaptive-by --target-error --time-limit --max-depth --min-weight --shadows --no-shadows"
      options+=" --time --shutter --shutter-blur --frames --fps --exposure --tone-map --white-point --white-balance --environment --environment-turn --environment-gain --sky --aov --photons --radiosity --radiosity-bounces --radiosity-error --integrator --seed --clamp --occlusion-distance --aperture --focus --focus-pixel --blades --lens-blur --camera --turntable --pixel --denoise --denoiser --quiet"
      files='@(scene|obj|gltf|glb|conf)' ;;
    view) options+=" --variant --size --device --threads --accel --max-depth --min-weight --environment --environment-turn --environment-gain --sky --photons --fullscreen"; files='@(scene|obj|gltf|glb|conf)' ;;
    info) options+=" --variant --devices --all"; files='@(scene|obj|gltf|glb|conf)' ;;
    bake) options+=" --output --method --patch --spp --max-depth --time --seed --threads --quiet"; files='@(scene|obj|gltf|glb|conf|pov)' ;;
    compare) options+=" --output --gain --flip"; files='@(png|jpg|jpeg|exr|hdr|ppm|tga|bmp)' ;;
    bench) options+=" --scenes --device --threads --rounds --no-tachyon --no-load --accel --refine --sampling --scene" ;;
    pov)
      options+=" --device --format --sandbox --allow-write --max-steps --max-memory +W +H +I +O +A +R +Q +FN +FJ +FT +UA +L +WT +KFF"
      [[ $word == +* ]] && mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word") && return
      files='@(pov|ini|POV|INI)' ;;
    help) mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word"); return ;;
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif [ -n "$files" ]; then
    # Folders too, so that one can walk down to a file.
    compopt -o filenames
    mapfile -t COMPREPLY < <(shopt -s extglob; compgen -d -- "$word"; compgen -f -X "!*.$files" -- "$word")
  fi
}
complete -F _sundog sundog

# The link by which other programs call it.
_sundog_povray() {
  COMP_WORDS=(sundog pov "${COMP_WORDS[@]:1}")
  COMP_CWORD=$((COMP_CWORD + 1))
  _sundog
}
# Where povray itself is installed, its own completion is left alone.
if [[ $(readlink -f "$(type -P povray)") == */sundog ]]; then complete -F _sundog_povray povray; fi
