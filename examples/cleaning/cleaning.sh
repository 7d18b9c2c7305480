#!/bin/sh
# Units as people wrote them, to one unit for each quantity; what cannot be read has its reason in its row.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tail -n +2 messy.csv | while IFS=';' read -r part what value; do
    case $what in
        length) unit=mm ;; mass) unit=kg ;; torque) unit='N*m' ;; rate) unit=N/mm ;;
        pressure) unit=kPa ;; area) unit='m^2' ;; *) unit=L ;;
    esac
    if dynamics convert "$value" "$unit" --json > "$work/good.json" 2> "$work/bad.json"; then
        jq -r --arg part "$part" --arg what "$what" '"\($part);\($what);\(.results.value.value);\(.results.value.unit);"' "$work/good.json"
    else
        jq -r --arg part "$part" --arg what "$what" '"\($part);\($what);;;\(.error.message)"' "$work/bad.json"
    fi
done
