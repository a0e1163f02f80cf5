#!/usr/bin/env bash
# check_layers.sh [LIB]: every folder of LIB/rubsweep includes only folders below it, quoted includes name files that
# exist, and only config/yaml/ knows yaml-cpp. Lists each include that breaks a rule; exits 1 if there is any.
set -euo pipefail
lib=${1:-$(dirname "${BASH_SOURCE[0]}")/../lib}

[[ -d $lib/rubsweep ]] || { echo "no directory $lib/rubsweep"; exit 1; }

# Folders that each folder may include directly; with each come those that it may include. `.` is LIB/rubsweep itself.
declare -A below=(
  [.]=''
  [basin]='.'
  [batch]='.'
  [model]='.'
  [contact]='model numerics/dense'
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
  [identify]='batch scene numerics numerics/spectral response/spectrum'
  [response/spectrum]='.'
  [fit]='batch identify table'
  [matlab]='.'
  [table]='.'
  [recording]='batch matlab model response/spectrum table'
  [scope]='batch identify recording response/spectrum'
  [diagnose]='batch response'
  [diagnose/features]='diagnose'
  [diagnose/forest]='batch diagnose'
  [diagnose/inference]='diagnose/features diagnose/forest'
  [diagnose/answer]='diagnose/inference'
  [dataset]='batch diagnose recording'
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
  [design]='identify sweep'
  [line]='report trace'
  [ramp]='integrate line response/spectrum'
  [ring]='batch numerics'
  [config/yaml]='batch model'
  [config/machine]='config/yaml contact matlab structure table'
  [config/study]='config/machine sweep'
  [config]='config/study'
  [config/keys]='config'
  [config/templates]='.'
  [config/dataset]='config dataset'
  [config/recording]='config recording'
  [config/ring]='config ring'
  [report]='sweep'
  [map]='config report'
  [map/families]='branch/families map'
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

# check_include FILE:LINE FOLDER NAME OPENING, the last one " or <
check_include() {
  local place=$1 folder=$2 name=$3 opening=$4
  if [[ $name == yaml-cpp/* && $folder != config/yaml ]]; then complain "$place" "only config/yaml/ may include $name"; fi
  if [[ $opening == '"' && ! -f $lib/$name ]]; then
    complain "$place" "there is no $name under $lib"
  elif [[ $name == rubsweep/* ]]; then
    local target=${name#rubsweep/}
    [[ $target == */* ]] && target=${target%/*} || target=.
    [[ $'\n'${allowed[$folder]}$'\n' == *$'\n'"$target"$'\n'* ]] || complain "$place" "$folder may not include $name"
  fi
}

declare -A allowed=()
while IFS= read -r file; do
  folder=${file#"$lib"/rubsweep/}
  [[ $folder == */* ]] && folder=${folder%/*} || folder=.
  if [[ -z ${below[$folder]+known} ]]; then
    complain "$file" "folder $folder has no place in the layers"
    continue
  fi
  [[ -n ${allowed[$folder]+known} ]] || allowed[$folder]=$(reachable "$folder")
  while IFS=: read -r line text; do
    [[ $text =~ ([<\"])([^>\"]+) ]]
    check_include "$file:$line" "$folder" "${BASH_REMATCH[2]}" "${BASH_REMATCH[1]}"
  done < <(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]' "$file" || true)
done < <(find "$lib/rubsweep" -name '*.hpp' -o -name '*.cpp' | sort)

exit "$broken"
