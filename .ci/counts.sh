# Sourced by test.sh: what ran and how it went, added up so that nothing fails unseen.
passed=0 failed=0 skipped=0

# count_ctest LOG OPTIONS...: runs ctest, prints a line per test and adds its counts. A run that ends with an error but
# names no failed test is a failure, and so is one in which no test passed.
count_ctest() {
  local log=$1 status=0 failures total passes skips
  ctest "${@:2}" --no-tests=error >"$log" 2>&1 || status=$?
  grep -vE '^(Test project|    Start|Total Test time)' "$log" || true
  read -r failures total < <(
    sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$log"; echo 0 0)
  skips=$(grep -cE '^[[:space:]]+[0-9]+ - .* \((Skipped|Disabled)\)$' "$log" || true)
  passes=$((total - failures - skips))
  if [ "$failures" -eq 0 ] && { [ "$status" -ne 0 ] || [ "$passes" -le 0 ]; }; then
    echo "ctest ended with status $status after $total tests, $skips of them skipped: counted as a failure"
    failures=1
  fi
  passed=$((passed + passes)) failed=$((failed + failures)) skipped=$((skipped + skips))
}

# count_check NAME COMMAND...: one check that passes or fails; status 77: it could not be made here.
count_check() {
  echo "== $1"
  local status=0
  "${@:2}" || status=$?
  case $status in
    0) passed=$((passed + 1)) ;;
    77) skipped=$((skipped + 1)) ;;
    *) failed=$((failed + 1)) ;;
  esac
}

# Processor time of all that this shell ran so far, into `processor` [s].
read_processor() {
  local minutes_user seconds_user minutes_system seconds_system file
  file=$(mktemp)
  times >"$file"
  { read -r && IFS='m s' read -r minutes_user seconds_user minutes_system seconds_system; } <"$file"
  rm "$file"
  processor=$((minutes_user * 60 + minutes_system * 60 + ${seconds_user%%[.,]*} + ${seconds_system%%[.,]*}))
}

# part NAME COMMAND...: runs a part of the suite and notes what it took.
parts=()
part() {
  local processor start=$SECONDS before
  read_processor
  before=$processor
  "${@:2}"
  read_processor
  parts+=("$(printf '%-12s %5d s, of processors %5d s' "$1" $((SECONDS - start)) $((processor - before)))")
}

# beside LOG COMMAND...: runs it while the script goes on; what it prints goes into a file.
besides=()
beside() {
  local log=$1
  (
    passed=0 failed=0 skipped=0 parts=()
    trap 'declare -p passed failed skipped parts >"$log.counts"' EXIT
    "${@:2}"
  ) >"$log" 2>&1 &
  besides+=("$! $log")
}

# gather: waits for what runs beside, prints what it printed and adds what it counted. One that ended with an error is a
# failure.
gather() {
  local each log status passed_before=$passed failed_before=$failed skipped_before=$skipped parts_before=("${parts[@]}")
  for each in "${besides[@]}"; do
    log=${each#* } status=0
    wait "${each%% *}" || status=$?
    cat "$log"
    passed=0 failed=0 skipped=0 parts=()
    [ ! -f "$log.counts" ] || . <(sed 's/^declare /declare -g /' "$log.counts")
    [ "$status" -eq 0 ] || { echo "$log ended with status $status: counted as a failure"; failed=$((failed + 1)); }
    passed=$((passed_before += passed)) failed=$((failed_before += failed)) skipped=$((skipped_before += skipped))
    parts_before+=("${parts[@]}")
    rm -f "$log.counts"
  done
  besides=() parts=("${parts_before[@]}")
}

# What each part took, the last line, and the exit status that goes with it.
say_counts() {
  [ ${#parts[@]} -eq 0 ] || printf '%s\n' "${parts[@]}"
  echo "$passed passed, $failed failed, $skipped skipped"
  [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
}
