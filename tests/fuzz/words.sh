#!/bin/sh
# words.sh FOLDER: all words in quotes that are kept there, as a dictionary for libFuzzer; and numbers that are none or not usual.
grep -aoh '"[^"\\]\{1,30\}"' "$1"/* | sort -u | sed 's/"/\\"/g; s/.*/"&"/'
printf '"%s"\n' 1e999 -1e150 5e-324 -0.0 NaN null true '\\ud800'
