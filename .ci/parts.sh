# Sourced by test.sh and run.sh: builds and runs of ctest that say what they do, added up so that nothing fails unseen.
passed=0 failed=0 skipped=0

# compile NAME LOG COMMAND...: a build by ninja; says how far it is, prints the log if it fails.
compile() {
  local name=$1 log=$2 start=$SECONDS next=0 line status
  mkdir -p "$(dirname "$log")"
  : >"$log"
  "${@:3}" 2>&1 | while IFS= read -r line; do
    printf '%s\n' "$line" >>"$log"
    [[ $line =~ ^\[([1-9][0-9]*)/([0-9]+)\] ]] && ((BASH_REMATCH[1] * 100 / BASH_REMATCH[2] >= next)) || continue
    echo "$name: step ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]} of the build, $((SECONDS - start)) s"
    next=$((BASH_REMATCH[1] * 100 / BASH_REMATCH[2] + 10))
  done
  status=${PIPESTATUS[0]}
  [ "$status" -eq 0 ] || cat "$log"
  return "$status"
}

# failure SENTENCE: counts as a failed test.
failure() {
  echo "$1: counted as a failure"
  failed=$((failed + 1))
}

# run_ctest LOG OPTIONS...: runs ctest, which prints a line per test, and adds its counts. An end with an error that names
# no failed test is a failure, and so is one in which no test passed. Of the log and not of ctest's JUnit report, which calls a
# test skipped whose program is not there.
run_ctest() {
  local log=$1 status=0 failures total passes skips
  ctest "${@:2}" --no-tests=error --no-label-summary --output-on-failure 2>&1 | tee "$log" |
    { grep --line-buffered -vE '^(Test project|Internal ctest|Total Test time| +Start |$)' || true; } || status=$?
  read -r failures total < <(
    sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$log"; echo 0 0)
  skips=$(grep -cE '^[[:space:]]+[0-9]+ - .* \((Skipped|Disabled)\)$' "$log" || true)
  passes=$((total - failures - skips))
  passed=$((passed + passes)) failed=$((failed + failures)) skipped=$((skipped + skips))
  if [ "$failures" -eq 0 ] && { [ "$status" -ne 0 ] || [ "$passes" -le 0 ]; }; then
    failure "ctest ended with status $status after $total tests, $skips of them skipped"
  fi
}

# Processor time of all that this shell ran so far, into `processor` [s].
read_processor() {
  local minutes_user seconds_user minutes_system seconds_system file
  file=$(mktemp)
  times >"$file" # in this shell: another one would tell its own
  { read -r && IFS='m s' read -r minutes_user seconds_user minutes_system seconds_system; } <"$file"
  rm "$file"
  processor=$((minutes_user * 60 + minutes_system * 60 + ${seconds_user%%[.,]*} + ${seconds_system%%[.,]*}))
}

# part NAME COMMAND...: runs a part of the suite and notes what it took.
parts=()
part() {
  local start=$SECONDS before
  read_processor
  before=$processor
  echo "== $1"
  "${@:2}"
  read_processor
  parts+=("$(printf '%-12s %5d s, of processors %5d s' "$1" $((SECONDS - start)) $((processor - before)))")
}

# say_counts: what each part took, the last line, and the exit status that goes with it.
say_counts() {
  [ ${#parts[@]} -eq 0 ] || printf '%s\n' "${parts[@]}"
  echo "$passed passed, $failed failed, $skipped skipped"
  [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
}
