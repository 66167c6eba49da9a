%
O0001
(rule: F 1.2 a header of a name; O123 is <O123>)
(expect: #1=1)
(expect: #2=2)
M98<PART_B.2>
M98<O0007>
M30
<PART_B.2>
#1=1
M99
O7
#2=2
M99
%
