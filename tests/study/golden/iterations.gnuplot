set terminal pngcairo size 1200,820 noenhanced background rgb 'white' font 'DejaVu Sans,11'
set encoding utf8
set multiplot layout 2,1 title 'Iterations: double, rules as-intended, zero test exact, at most 20 iterations'
set logscale y
set yrange [1e-6:1]
set ytics ('1' 1, '0.1' 0.1, '0.01' 0.01, '1e-3' 1e-3, '1e-4' 1e-4, '1e-5' 1e-5, '1e-6' 1e-6)
set ylabel 'share of hits, of misses'
set xrange [0:21]
set xtics 1
set boxwidth 0.4
set grid y
set key top right
set title 'family triangles'
$data << EOD
1 0 0
2 0 0.15
3 0 0.375
4 0.75 0.275
5 0.25 0.175
6 0 0.025
EOD
plot $data using ($1-0.2):($2>0?$2:NaN) with boxes fs solid 1 lc rgb '#0072B2' title 'hits', $data using ($1+0.2):($3>0?$3:NaN) with boxes fs pattern 2 lc rgb '#D55E00' title 'misses'
set title 'all families, each counting alike'
set xlabel 'iterations; undecided queries count with those that they took'
$data << EOD
1 0 0
2 0 0.05
3 0.03 0.139493
4 0.388056 0.113406
5 0.150278 0.0945652
6 0.0075 0.00833333
7 0.005 0.00724638
8 0.0025 0.0217391
9 0 0.0217391
10 0 0
11 0.00462963 0
12 0 0.0144928
13 0 0.00724638
14 0.00462963 0.00724638
15 0.00925926 0.0144928
16 0 0.00724638
17 0 0
18 0 0.00724638
19 0 0
20 0.398148 0.485507
EOD
plot $data using ($1-0.2):($2>0?$2:NaN) with boxes fs solid 1 lc rgb '#0072B2' title 'hits', $data using ($1+0.2):($3>0?$3:NaN) with boxes fs pattern 2 lc rgb '#D55E00' title 'misses'
unset multiplot
