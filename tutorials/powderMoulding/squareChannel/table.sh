#!/bin/bash
# y z phi of the particles of a time folder that is written as text, for this case and circularPipe: table.sh <folder>
paste <(grep -E '^\(.' "$1/lagrangian/sph/positions" | tr -d '()') <(sed -n '/^($/,/^)$/p' "$1/lagrangian/sph/phi" | grep -vE '^[()]') | awk '{ print $2, $3, $NF }'
