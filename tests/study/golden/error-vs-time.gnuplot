set terminal pngcairo size 1060,570 noenhanced background rgb 'white' font 'DejaVu Sans,11'
set encoding utf8
set logscale x
set multiplot layout 1,3 margins 0.06,0.985,0.135,0.705 spacing 0.045,0.1 title 'Wrong or undecided against time, means of the 2 of 4 families that float can hold and every setting is asked about; iteration limits 5, 20' font ',10'
set label 'gjkstep-study run --pairs 100 --seed 3 --families triangles,touching-face-askew,cylinders-gap-1e-12,cycles --scalar float,double,exact --limit 5,20; GNU 12.2.0 -O3; CPU time on Abacus, 1 thread' at screen 0.985,0.025 right font ',9'
set grid
set xzeroaxis lt 1 lc rgb 'black'
set ylabel 'share wrong or undecided, mean of families'
set key at screen 0.5,0.935 center top vertical maxrows 5 samplen 4
set title 'float' font ',13'
set xlabel 'nanoseconds per query'
set xrange [95.7143:205.8]
set yrange [-0.010416:0.1736]
set xtics (100, 200)
set label '5' at graph 0.496742,0.943922 center font ',10' front
set label '20' at graph 0.57604,0.681549 center font ',10' front
set label '5' at graph 0.524438,0.183118 center font ',10' front
set label '5' at graph 0.540378,0.735893 center font ',10' front
set label '20' at graph 0.496742,0.47352 center font ',10' front
set label '5' at graph 0.386524,0.708721 center font ',10' front
set label '20' at graph 0.379236,0.600035 center font ',10' front
set label '5' at graph 0.415447,0.110947 center font ',10' front
set label '20' at graph 0.407947,0.0566038 center font ',10' front
set label '5' at graph 0.468447,0.835236 center font ',10' front
$curve0 << EOD
140 0.155
141 0.115
EOD
$curve1 << EOD
143 0.015
144 0
EOD
$curve2 << EOD
139 0.125
140 0.085
EOD
$curve3 << EOD
142 0.015
143 0
EOD
$curve4 << EOD
134 0.12
135 0.1
EOD
$curve5 << EOD
137 0.01
138 0
EOD
$curve6 << EOD
137 0.135
138 0.12
EOD
$curve7 << EOD
140 0.01
141 0
EOD
$curve8 << EOD
141 0
EOD
$curve9 << EOD
147 0
EOD
plot $curve0 with linespoints lc rgb '#0072B2' dt 1 lw 1.5 ps 1.4 pt 5 title 'rules as-intended, zero test exact', $curve1 with linespoints lc rgb '#0072B2' dt 1 lw 1.5 ps 1.4 pt 4 title 'rules as-intended, zero test relative', $curve2 with linespoints lc rgb '#D55E00' dt '-' lw 1.5 ps 1.4 pt 9 title 'rules as-printed, zero test exact', $curve3 with linespoints lc rgb '#D55E00' dt '-' lw 1.5 ps 1.4 pt 8 title 'rules as-printed, zero test relative', $curve4 with linespoints lc rgb '#009E73' dt '.' lw 1.5 ps 1.4 pt 13 title 'rules eager, zero test exact', $curve5 with linespoints lc rgb '#009E73' dt '.' lw 1.5 ps 1.4 pt 12 title 'rules eager, zero test relative', $curve6 with linespoints lc rgb '#E69F00' dt '_' lw 1.5 ps 1.4 pt 11 title 'rules complete, zero test exact', $curve7 with linespoints lc rgb '#E69F00' dt '_' lw 1.5 ps 1.4 pt 10 title 'rules complete, zero test relative', $curve8 with linespoints lc rgb '#CC79A7' ps 1.4 pt 7 title 'certified: 0 of 400 wrong or undecided', $curve9 with linespoints lc rgb '#CC79A7' ps 1.4 pt 6 title 'certified-eager: 0 of 400 wrong or undecided'
unset ylabel
unset key
unset label
set title 'double' font ',13'
set xlabel 'nanoseconds per query'
set xrange [25:67.2]
set yrange [-0.010416:0.1736]
set xtics (50)
set label '5' at graph 0.500301,0.509177 center font ',10' front
set label '20' at graph 0.594671,0.301148 center font ',10' front
set label '5' at graph 0.571719,0.155947 center font ',10' front
set label '5' at graph 0.422329,0.437005 center font ',10' front
set label '20' at graph 0.500301,0.228976 center font ',10' front
set label '5' at graph 0.340284,0.454834 center font ',10' front
set label '20' at graph 0.368774,0.228976 center font ',10' front
set label '5' at graph 0.423454,0.128775 center font ',10' front
set label '5' at graph 0.476454,0.382662 center font ',10' front
set label '5' at graph 0.500301,0.128775 center font ',10' front
$curve0 << EOD
41 0.075
42 0.045
EOD
$curve1 << EOD
44 0.01
45 0
EOD
$curve2 << EOD
40 0.07
41 0.04
EOD
$curve3 << EOD
43 0.01
44 0
EOD
$curve4 << EOD
35 0.065
36 0.04
EOD
$curve5 << EOD
38 0.005
39 0
EOD
$curve6 << EOD
38 0.06
39 0.045
EOD
$curve7 << EOD
41 0.005
42 0
EOD
$curve8 << EOD
42 0
EOD
$curve9 << EOD
48 0
EOD
plot $curve0 with linespoints lc rgb '#0072B2' dt 1 lw 1.5 ps 1.4 pt 5 title 'rules as-intended, zero test exact', $curve1 with linespoints lc rgb '#0072B2' dt 1 lw 1.5 ps 1.4 pt 4 title 'rules as-intended, zero test relative', $curve2 with linespoints lc rgb '#D55E00' dt '-' lw 1.5 ps 1.4 pt 9 title 'rules as-printed, zero test exact', $curve3 with linespoints lc rgb '#D55E00' dt '-' lw 1.5 ps 1.4 pt 8 title 'rules as-printed, zero test relative', $curve4 with linespoints lc rgb '#009E73' dt '.' lw 1.5 ps 1.4 pt 13 title 'rules eager, zero test exact', $curve5 with linespoints lc rgb '#009E73' dt '.' lw 1.5 ps 1.4 pt 12 title 'rules eager, zero test relative', $curve6 with linespoints lc rgb '#E69F00' dt '_' lw 1.5 ps 1.4 pt 11 title 'rules complete, zero test exact', $curve7 with linespoints lc rgb '#E69F00' dt '_' lw 1.5 ps 1.4 pt 10 title 'rules complete, zero test relative', $curve8 with linespoints lc rgb '#CC79A7' ps 1.4 pt 7 title 'certified: 0 of 400 wrong or undecided', $curve9 with linespoints lc rgb '#CC79A7' ps 1.4 pt 6 title 'certified-eager: 0 of 400 wrong or undecided'
unset ylabel
unset key
unset label
set title 'exact' font ',13'
set xlabel 'nanoseconds per query'
set xrange [24.2857:57.4]
set yrange [-0.010416:0.1736]
set xtics (50)
set label '5' at graph 0.580117,0.101604 center font ',10' front
set label '20' at graph 0.678824,0.0566038 center font ',10' front
set label '5' at graph 0.391176,0.101604 center font ',10' front
set label '5' at graph 0.489481,0.101604 center font ',10' front
$curve0 << EOD
40 0
41 0
EOD
$curve1 << EOD
39 0
40 0
EOD
$curve2 << EOD
34 0
35 0
EOD
$curve3 << EOD
37 0
38 0
EOD
plot $curve0 with linespoints lc rgb '#0072B2' dt 1 lw 1.5 ps 1.4 pt 5 title 'rules as-intended, zero test exact', $curve1 with linespoints lc rgb '#D55E00' dt '-' lw 1.5 ps 1.4 pt 9 title 'rules as-printed, zero test exact', $curve2 with linespoints lc rgb '#009E73' dt '.' lw 1.5 ps 1.4 pt 13 title 'rules eager, zero test exact', $curve3 with linespoints lc rgb '#E69F00' dt '_' lw 1.5 ps 1.4 pt 11 title 'rules complete, zero test exact'
unset multiplot
