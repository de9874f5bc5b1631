#!/usr/bin/env bash
# wrc_compare --only: the lines it prints are lines of the whole table, no others run, and no kind takes an unknown name.
#   only.sh wrc_compare
set -euo pipefail
compare=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# One double ellipse. What the forces are compared with does not matter here.
cat >"$folder/one.csv" <<'CSV'
a_mm,b_mm,psi,nu,G_MPa,mu,N_kN,cx,cy,phi_per_m,Fx_N,Fy_N,Mz_Nm,P_W_at_1mps,adh_frac
5,4,0.2,0.28,82000,0.3,80,0.001,0.0005,0.2,-18000,-9000,10,25,0.3
CSV
"$compare" sdec "$folder/one.csv" >"$folder/all"
"$compare" sdec "$folder/one.csv" --only 'table,fastsim/elliptic' >"$folder/some"
rows() { grep -E '^[* ] [a-z_]+.* 1$' "$1"; } # of variants: they end with the number of rows of the file
test "$(rows "$folder/some" | wc -l)" -eq 6 || { echo "two variants by three measures are six rows:"; cat "$folder/some"; exit 1; }
test "$(rows "$folder/some" | awk '{ print $1 }' | sort -u | xargs)" = 'fastsim/elliptic table'
while IFS= read -r row; do
  grep -qxF -e "$row" "$folder/all" || { echo "not a row of the whole table: $row"; exit 1; }
done < <(rows "$folder/some")

for kind in sdec normal wheelrail halfspace-sdec halfspace-normal grid subsurf temperature; do
  status=0
  "$compare" "$kind" "$folder/one.csv" --only guessed >"$folder/said" 2>&1 || status=$?
  [ "$status" -eq 1 ] && grep -q "no variant 'guessed'; known are" "$folder/said" && [ "$(wc -l <"$folder/said")" -ge 2 ] ||
    { echo "$kind, unknown variant: status $status"; cat "$folder/said"; exit 1; }
done
"$compare" --help | grep -q -- --only
