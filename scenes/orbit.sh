#!/bin/sh
# A flight around the hole: FRAMES pictures, numbered from 0, in the folder FOLDER.
#
#   scenes/orbit.sh [FOLDER [FRAMES [OPTIONS OF blackhole render ...]]]
#
# A frame that exists is kept: a file appears only when it is complete, so after
# an interruption the same command renders just what is missing.
set -eu
folder=${1:-frames}
frames=${2:-48}
[ $# -lt 1 ] || shift
[ $# -lt 1 ] || shift
blackhole=$(dirname -- "$0")/../script/blackhole

mkdir -p "$folder"
frame=0
while [ "$frame" -lt "$frames" ]; do
  file=$folder/$(printf '%05d' "$frame").png
  if [ ! -e "$file" ]; then
    # Tenths of a degree: the shell counts in whole numbers.
    azimuth=$((3600 * frame / frames))
    "$blackhole" render --width 640 --roll 0 \
      --azimuth "$((azimuth / 10)).$((azimuth % 10))" "$@" -o "$file"
    echo "$file"
  fi
  frame=$((frame + 1))
done
