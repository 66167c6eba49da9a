%
(rule: 4 structures whose number stands in front of the keyword)
(expect: #31=3)
(expect: path X4 Y2)
#31=0
o100 while [#31 LT 3]
o101 if [#31 EQ 1]
G0 X[#31*4]
o101 else
G0 Y[#31]
o101 endif
#31=[#31+1]
o100 endwhile
M2
%
