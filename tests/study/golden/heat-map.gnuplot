set terminal png size 1160,316 noenhanced background rgb 'white' font 'DejaVu Sans,11'
set encoding utf8
$cells << EOD
0 1 -0.638272
1 1 -1.04576
0 2 0
1 2 0
2 2 0
0 3 -0.267606
1 3 -0.283997
3 3 0
EOD
set label '<0.04' at 0,0 center front textcolor rgb '#666666'
set label '<0.04' at 1,0 center front textcolor rgb '#666666'
set label '<0.7' at 2,0 center front textcolor rgb '#666666'
set label '<0.04' at 3,0 center front textcolor rgb '#666666'
set label '<0.04' at 4,0 center front textcolor rgb '#666666'
set label '0.23' at 0,1 center front textcolor rgb '#FFFFFF'
set label '0.09' at 1,1 center front textcolor rgb '#FFFFFF'
set label '<0.7' at 2,1 center front textcolor rgb '#666666'
set label '<0.04' at 3,1 center front textcolor rgb '#666666'
set label '<0.04' at 4,1 center front textcolor rgb '#666666'
set label '1' at 0,2 center front textcolor rgb '#FFFFFF'
set label '1' at 1,2 center front textcolor rgb '#FFFFFF'
set label '1' at 2,2 center front textcolor rgb '#FFFFFF'
set label '0' at 3,2 center front textcolor rgb '#000000'
set label '0' at 4,2 center front textcolor rgb '#000000'
set label '0.54' at 0,3 center front textcolor rgb '#FFFFFF'
set label '0.52' at 1,3 center front textcolor rgb '#FFFFFF'
set label 'not asked' at 2,3 center front textcolor rgb '#666666'
set label 'all in doubt' at 3,3 center front textcolor rgb '#FFFFFF'
set label '<0.04' at 4,3 center front textcolor rgb '#666666'
set title 'Wrong or undecided, share of pairs: rules as-intended, zero test exact, at most 20 iterations'
set xtics ('float' 0, 'double' 1, 'exact' 2, 'certified float' 3, 'certified double' 4) scale 0
set ytics ('triangles' 0, 'touching-face-askew' 1, 'cycles' 2, 'cylinders-gap-1e-12' 3) scale 0
set label 'A number after <: none seen; if there are any they are fewer than this (upper end of the 95 % interval).' at screen 0.5,0.170886 center font ',9'
set label '0: none of all the pairs that there are. Float is judged by the truth about the pair as float writes it.' at screen 0.5,0.113924 center font ',9'
set label 'gjkstep-study run --pairs 100 --seed 3 --families triangles,touching-face-askew,cylinders-gap-1e-12,cycles --scalar float,double,exact --limit 5,20; GNU 12.2.0 -O3' at screen 0.5,0.0443038 center font ',9'
set bmargin at screen 0.316456
set xrange [-0.5:5 - 0.5]
set yrange [4 - 0.5:-0.5]
set palette defined (0 '#FFF3B0', 1 '#F6C667', 2 '#E58F4B', 3 '#B8504A', 4 '#6F2C5B', 5 '#2A1145')
set cbrange [-6:0]
set cbtics ('1' 0, '0.1' -1, '0.01' -2, '1e-3' -3, '1e-4' -4, '1e-5' -5, '1e-6' -6)
set style fill solid noborder
unset key
plot $cells using 1:2:(0.5):(0.5):3 with boxxyerror palette
