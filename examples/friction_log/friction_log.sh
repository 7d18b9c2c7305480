#!/bin/sh
# A log of 100,000 test skids, three of them bad, to coefficients of friction and their summary.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The log: 100,000 rows of three roads, with a negative distance, a word and a zero among them.
awk 'BEGIN {
    print "road,speed[km/h],distance[m]"
    for (i = 0; i < 100000; i++) {
        speed = 40 + i % 21; mu = 0.62 + 0.04 * sin(i) + 0.03 * (i % 3)
        distance = (speed / 3.6) * (speed / 3.6) / (2 * 9.80665 * mu)
        if (i == 777) distance = -1
        if (i == 5000) distance = "wet"
        if (i == 99999) distance = 0
        printf "%s,%g,%.4f\n", substr("ABC", i % 3 + 1, 1), speed, distance
    }
}' | sed 's/0.0000$/0/' > "$work/log.csv"

# A bad row costs only itself: its error stands in its row, and the exit status is 4.
dynamics skid friction --rows "$work/log.csv" --jobs 2 > "$work/out.csv" 2> /dev/null || echo "exit status $?"
wc -l < "$work/out.csv" | tr -d ' '

# Each road in SQL, and how many rows were refused; then why they were, by jq.
sqlite3 -csv -header :memory: ".import $work/out.csv log" \
    "SELECT road, count(*) AS skids, round(avg(\"friction\"), 3) AS mean, round(min(\"friction\"), 3) AS minimum, round(max(\"friction\"), 3) AS maximum FROM log WHERE error = '' GROUP BY road" \
    "SELECT count(*) AS refused FROM log WHERE error <> ''" | tr -d '\r'
dynamics skid friction --rows "$work/log.csv" --format ndjson 2> /dev/null |
    jq -r 'select(.error) | .error.message' | sort | uniq -c | sed 's/^ *//'
