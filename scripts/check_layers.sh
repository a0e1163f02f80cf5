#!/usr/bin/env bash
# check_layers.sh [LIB]: every storey of LIB/rubsweep includes only itself and those it stands on, and every folder only
# folders below it; quoted includes name files that exist, and only config/yaml/ knows yaml-cpp. Lists each include that
# breaks a rule; exits 1 if there is any.
set -euo pipefail
lib=${1:-$(dirname "${BASH_SOURCE[0]}")/../lib}

[[ -d $lib/rubsweep ]] || { echo "no directory $lib/rubsweep"; exit 1; }

# Storeys that each storey stands on. The ring is a storey of one folder.
declare -A stands_on=(
  [core]=''
  [maps]='core'
  [analysis]='maps core'
  [measurement]='analysis maps core'
  [ring]='maps core'
)

# Folders that each folder may include directly, each without its storey; with each come those that it may include. `.` is
# the storey `core` itself.
declare -A below=(
  [.]=''
  [basin]='.'
  [batch]='.'
  [model]='.'
  [contact]='model numerics'
  [structure]='model numerics'
  [scene]='contact structure'
  [numerics/dense]=''
  [numerics]='. numerics/dense'
  [numerics/spectral]='numerics/dense'
  [integrate/run]='scene'
  [integrate/law]='integrate/run numerics'
  [integrate/adaptive]='integrate/law'
  [integrate/exact/modes]='integrate/run numerics'
  [integrate/exact]='integrate/exact/modes'
  [integrate/exact/tube]='integrate/exact'
  [integrate/taylor]='integrate/law'
  [integrate]='integrate/adaptive integrate/exact integrate/taylor'
  [linear]='batch scene numerics numerics/spectral response/spectrum'
  [response/spectrum]='.'
  [fit]='batch linear table'
  [matlab]='.'
  [table]='.'
  [recording]='config matlab response/spectrum'
  [scope]='batch linear recording response/spectrum'
  [diagnose]='batch response'
  [diagnose/features]='diagnose'
  [diagnose/forest]='batch diagnose'
  [diagnose/inference]='diagnose/features diagnose/forest'
  [diagnose/answer]='diagnose/inference'
  [dataset]='diagnose recording'
  [diagnosis]='dataset diagnose/answer scope'
  [response/motion]='response/spectrum integrate'
  [response/proof]='response/motion integrate/exact/tube'
  [response/rotating]='response/proof'
  [response]='response/proof response/rotating'
  [branch/orbits]='batch response'
  [branch/continuation]='branch/orbits numerics/spectral'
  [fit/rub]='branch/continuation'
  [branch/curves]='branch/continuation'
  [branch/families]='branch/continuation sweep'
  [trace]='batch response'
  [sweep]='basin response batch'
  [design]='linear sweep'
  [line]='report trace'
  [ramp]='integrate line response/spectrum'
  [ring]='config numerics'
  [config/yaml]='batch model'
  [config/keys]='model'
  [config/machine]='config/keys config/yaml contact matlab structure table'
  [config/study]='config/machine sweep'
  [config]='config/study'
  [config/templates]='.'
  [report]='sweep'
  [map]='config report'
  [branch/journal]='branch/families map'
  [page]='report trace'
)

# reachable FOLDER: FOLDER and everything below it, one per line.
reachable() {
  echo "$1"
  local folder
  for folder in ${below[$1]}; do reachable "$folder"; done
}

broken=0
complain() {
  echo "$1: $2"
  broken=1
}

# place_of FILE: sets `storey` and `folder`, the latter without its storey, of a file below LIB/rubsweep.
place_of() {
  local directory=${1%/*}
  storey=${1%%/*}
  folder=${directory#*/}
  [[ $directory != core ]] || folder=.
}

# check_include FILE:LINE STOREY FOLDER NAME OPENING, the last one " or <
check_include() {
  local place=$1 from_storey=$2 from=$3 name=$4 opening=$5 storey folder
  if [[ $name == yaml-cpp/* && $from != config/yaml ]]; then complain "$place" "only config/yaml/ may include $name"; fi
  if [[ $opening == '"' && ! -f $lib/$name ]]; then
    complain "$place" "there is no $name under $lib"
  elif [[ $name == rubsweep/* ]]; then
    place_of "${name#rubsweep/}"
    if [[ " $from_storey ${stands_on[$from_storey]} " != *" $storey "* ]]; then
      complain "$place" "$from_storey does not stand on $name"
    elif [[ $'\n'${allowed[$from]}$'\n' != *$'\n'"$folder"$'\n'* ]]; then
      complain "$place" "$from may not include $name"
    fi
  fi
}

declare -A allowed=()
while IFS= read -r file; do
  place_of "${file#"$lib"/rubsweep/}"
  if [[ -z ${stands_on[$storey]+known} ]]; then
    complain "$file" "$storey is no storey"
    continue
  fi
  if [[ -z ${below[$folder]+known} ]]; then
    complain "$file" "folder $folder has no place in the layers"
    continue
  fi
  [[ -n ${allowed[$folder]+known} ]] || allowed[$folder]=$(reachable "$folder")
  while IFS=: read -r line text; do
    [[ $text =~ ([<\"])([^>\"]+) ]]
    check_include "$file:$line" "$storey" "$folder" "${BASH_REMATCH[2]}" "${BASH_REMATCH[1]}"
  done < <(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]' "$file" || true)
done < <(find "$lib/rubsweep" -name '*.hpp' -o -name '*.cpp' | sort)

exit "$broken"
