%
O0001
(rule: F 6.5 #2500, #2600, #2700: EXT and G54 to G59 by axis)
(expect: to X3 Y4 Z5)
(expect: #1=10)
(expect: #2=20)
(expect: #3=30)
#2501=3
#2601=4
#2701=5
G54G00X0.Y0.Z0.
#1=#2502
#2=#2602
#3=#2702
M30
%
