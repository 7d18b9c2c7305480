#!/bin/sh
# A file of cases: CSV in, CSV out, a bad row costs only itself; then the same rows as NDJSON for jq.
set -eu
dynamics skid speed --rows cases.csv --units us
{ cat cases.csv; echo "A-4,oops,0.7"; } | dynamics skid speed --rows - --to speed=mph || echo "exit status $?"
dynamics skid speed --rows cases.csv --format ndjson | jq -r '.case + " " + (.results.time.value | tostring)'
